#pragma once

#include <memory>

#include "pem/case_parameters.hpp"
#include "track/exact_rail.hpp"

namespace railpem::pem {

/// Evaluates one rail, group of lines by group of lines. One per thread: it owns its workspace.
class RailEvaluator {
  public:
    virtual ~RailEvaluator() = default;
    /// Receptances between the wheels and the sum of the pad forces, for ω in rad/s. Valid until the next call.
    virtual const track::RailReceptance& at(lanes::Real omega) = 0;
};

/// A rail prepared for all frequencies; shared between threads, immutable.
class RailModel {
  public:
    virtual ~RailModel() = default;
    virtual std::unique_ptr<RailEvaluator> evaluator() const = 0;
    /// R(v) − R(0) for points at these separations (track/convected_rail.hpp).
    virtual std::vector<std::complex<double>> convected_change(double omega, double speed_m_per_s, const std::vector<double>& separations_m) const = 0;
};

/// The rail that the case asks for (solver.rail), on the pads of the static equilibrium.
std::unique_ptr<RailModel> rail_model(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                      const track::StaticEquilibrium& equilibrium);

/// Static equilibrium of the case: the same pads, the same rail, the same wheel positions as in its dynamics.
track::StaticEquilibrium case_equilibrium(const CaseParameters& parameters);

}  // namespace railpem::pem
