#pragma once
// The rail of a case under the static load of its wheels.

#include <vector>

#include "pem/case_parameters.hpp"
#include "track/statics/static_equilibrium.hpp"

namespace railpem::pem {

/// Where the case has pads, m; `wheels_m` as in make_rail().
std::vector<double> case_pads(const CaseParameters& parameters, const std::vector<double>& wheels_m);

/// Static equilibrium of the case: the same pads, the same rail, the same wheel positions as in its dynamics.
track::StaticEquilibrium case_equilibrium(const CaseParameters& parameters);

/// As far as the dynamics of the rail need it, which is less when the pads do not stiffen under load; `start`: that of
/// a similar case, to begin from.
track::StaticEquilibrium dynamic_equilibrium(const CaseParameters& parameters,
                                             const track::StaticEquilibrium* start = nullptr);

/// The same with the regularly failed seats counted from each of `first_seats` in turn; `start`: as many similar ones,
/// or none.
std::vector<track::StaticEquilibrium> dynamic_equilibria(const CaseParameters& parameters,
                                                         const std::vector<int>& first_seats,
                                                         const std::vector<track::StaticEquilibrium>& start = {});

}  // namespace railpem::pem
