#pragma once
// The train at places of the track that differ in the phase of the supports and in the seats that have failed.

#include <vector>

#include "pem/case_parameters.hpp"
#include "track/rail/joint_deflection.hpp"

namespace railpem::pem {

/// What the wheels feel of the track at rest at each place: Σ_j C_ij, the deflection under wheel i by unit forces at
/// all of them. Everything that does not depend on the frequency, the static equilibria included, is computed once.
class PassingPositions {
  public:
    /// Places (b, s): wheel 1 stands the share bay_shares[b] of a bay (≥ 0, < 1) ahead of seat 0, and the regularly
    /// failed seats are counted from first_seats[s]. Random failures are left out; without a table of failed fasteners
    /// every s is the same.
    PassingPositions(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                     const std::vector<double>& bay_shares, const std::vector<int>& first_seats);

    std::size_t places() const { return phases_.size() * rows_; }
    std::size_t place(std::size_t bay_share, std::size_t first_seat) const { return bay_share * rows_ + first_seat; }

    /// In m/N, [place·wheels + wheel]; ω > 0 in rad/s.
    std::vector<lanes::Complex> deflection(lanes::Real omega) const;

  private:
    struct Phase {
        CaseParameters moved;
        std::vector<track::StaticEquilibrium> equilibria;  ///< per first seat
        std::vector<std::vector<track::Seat>> rows;
        std::optional<track::PlacedPoints> placed;
    };
    void by_waves(const Phase& phase, const track::BlochWaves& waves, const track::SupportLaw& law,
                  track::ScatterRow& memory, lanes::Complex* result) const;
    void directly(const Phase& phase, lanes::Real omega, lanes::Complex* result) const;

    std::vector<double> wheels_m_;
    std::vector<int> first_seats_;
    std::size_t rows_;
    std::vector<Phase> phases_;
};

}  // namespace railpem::pem
