#pragma once

#include <cstdint>

namespace railpem::simulate {

/// Scatter of seats along the line: factors with mean 1 whose logarithms are normal.
struct SeatScatter {
    std::uint64_t seed = 1;
    double pad = 0.0;            ///< standard deviation of the logarithm of a pad's stiffness, seat to seat
    double pad_damping = 0.0;    ///< the same of its dashpot
    double support = 0.0;        ///< the same of what lies under it, varying smoothly along the line
    double support_seats = 1.0;  ///< correlation length of that, in seats
    double ground_share = 0.0;   ///< of a seat's compliance; 0: what lies under the pad has a law of its own

    bool any() const { return pad > 0.0 || pad_damping > 0.0 || support > 0.0; }
    double pad_factor(std::int64_t seat) const;
    double dashpot_factor(std::int64_t seat) const;
    double support_factor(std::int64_t seat) const;
    /// Of the stiffness of pad and ground in series, where the ground has no law of its own; else of the pad.
    double seat_factor(std::int64_t seat) const;
};

/// What varies from seat to seat: a function of the seat's number, counted from the one at or behind wheel 1 at the
/// start.
struct SeatVariation {
    int failed_every = 0;
    int failed_origin = 0;  ///< number of the seat nearest to wheel 1
    double failed_fraction = 0.0;
    std::uint64_t failed_seed = 1;
    double remaining_share = 1.0;
    double ground_variation = 0.0;  ///< relative, of the last oscillator's frequency
    double ground_period_seats = 1.0;
    SeatScatter scatter;

    bool is_uniform() const {
        return failed_every == 0 && failed_fraction == 0.0 && ground_variation == 0.0 && !scatter.any();
    }
    bool has_failed(std::int64_t seat) const;
    double ground_scale(std::int64_t seat) const;  ///< of its stiffness
};

}  // namespace railpem::simulate
