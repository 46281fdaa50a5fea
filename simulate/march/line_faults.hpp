#pragma once
// What a line has at places of its own: dips, and a stretch that is rougher than the rest.

#include <cstdint>
#include <vector>

#include "simulate/march/profile.hpp"
#include "simulate/world_draws.hpp"
#include "simulate/world_parameters.hpp"

namespace railpem::simulate {

/// Dips between two positions, by position: a Poisson process of `impacts_per_km`, drawn hectometre by hectometre, so
/// that a place of a line is the same however much of the line is looked at. Depth and length are uniform about their
/// means.
std::vector<Dip> draw_dips(const WorldParameters& world, std::uint64_t line_seed, double from_m, double to_m);

/// Length of the longest dip, m; 0 of none.
double longest_m(const std::vector<Dip>& dips);

/// Height of all dips at a place, m: none is positive. `dips` by position, none longer than `longest_m`.
double height_of_dips(const std::vector<Dip>& dips, double longest_m, double position_m);

/// Multiplies the heights between two positions by 10^(level/20), faded in and out over 10 m or a quarter of the
/// stretch.
void roughen(Profile& profile, double from_m, double to_m, double level_db);

}  // namespace railpem::simulate
