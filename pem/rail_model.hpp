#pragma once

#include <memory>

#include "pem/case_parameters.hpp"
#include "track/convected_rail.hpp"
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
    /// R(v) − R(0) for points at these distances, into `change` (track/convected_rail.hpp).
    virtual void convected_change(double omega, double speed_m_per_s, const std::vector<double>& distances_m,
                                  track::ConvectedChange* change) const = 0;
};

/// The rail that the case asks for (solver.rail), on the pads of the static equilibrium; with solver.moving the exact one stands on the pads as
/// wheels at this speed press them.
std::unique_ptr<RailModel> rail_model(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                      const track::StaticEquilibrium& equilibrium, double speed_m_per_s = 0.0);

/// Static equilibrium of the case: the same pads, the same rail, the same wheel positions as in its dynamics.
track::StaticEquilibrium case_equilibrium(const CaseParameters& parameters);

/// As far as the dynamics of the rail need it, which is less when the pads do not stiffen under load; `start`: that of a similar
/// case, to begin from.
track::StaticEquilibrium dynamic_equilibrium(const CaseParameters& parameters, const track::StaticEquilibrium* start = nullptr);

/// The same with the regularly failed seats counted from each of `first_seats` in turn; `start`: as many similar ones, or none.
std::vector<track::StaticEquilibrium> dynamic_equilibria(const CaseParameters& parameters, const std::vector<int>& first_seats,
                                                         const std::vector<track::StaticEquilibrium>& start = {});

}  // namespace railpem::pem
