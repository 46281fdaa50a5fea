#include "track/rail/exact_rail.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "track/pads/pad_law.hpp"
#include "track/pads/support_law.hpp"
#include "track/statics/seat_row.hpp"

namespace railpem::track {

namespace {

int length_index(std::vector<double>& lengths, double length) {
    for (std::size_t i = 0; i < lengths.size(); ++i)
        if (std::abs(lengths[i] - length) < kSameNode) return static_cast<int>(i);
    lengths.push_back(length);
    return static_cast<int>(lengths.size()) - 1;
}

/// Merges seats and points into nodes and names the stretches between them.
void place_nodes(ExactRail& rail, const std::vector<Seat>& seats, const std::vector<double>& points) {
    for (const Seat& seat : seats)
        rail.nodes.push_back({.position_m = seat.position_m,
                              .pad_stiffness_n_per_m = seat.pad_stiffness_n_per_m,
                              .pad_scale = seat.scale,
                              .supported = true});
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto same = [&](const RailNode& node) { return std::abs(node.position_m - points[i]) < kSameNode; };
        const auto found = std::find_if(rail.nodes.begin(), rail.nodes.end(), same);
        if (found != rail.nodes.end()) {
            assert(found->point < 0 && "two points at one place");
            found->point = static_cast<int>(i);
        } else {
            rail.nodes.push_back({.position_m = points[i], .point = static_cast<int>(i)});
        }
    }
    std::sort(rail.nodes.begin(), rail.nodes.end(),
              [](const RailNode& a, const RailNode& b) { return a.position_m < b.position_m; });
    rail.lengths_m = {rail.spacing_m};
    for (std::size_t j = 0; j + 1 < rail.nodes.size(); ++j)
        rail.nodes[j].stretch = length_index(rail.lengths_m, rail.nodes[j + 1].position_m - rail.nodes[j].position_m);
    rail.points = static_cast<int>(points.size());
}

ExactRail bare_rail(const TrackParameters& track, const TrackModifiers& modifiers, double uniform_stiffness) {
    ExactRail rail;
    rail.rail = track.rail;
    rail.dampers = track.rail_dampers;
    rail.pads = track.pads;
    rail.support = track.support;
    rail.modifiers = modifiers;
    rail.spacing_m = track.spacing_m;
    rail.uniform_pad_stiffness_n_per_m = uniform_stiffness;
    return rail;
}

}  // namespace

ExactRail exact_rail(const TrackParameters& track, const std::vector<double>& points_m,
                     const StaticEquilibrium& equilibrium, const TrackModifiers& modifiers, double tolerance) {
    ExactRail rail = bare_rail(track, modifiers, equilibrium.unloaded_dynamic_stiffness_n_per_m);
    const double rearmost = *std::min_element(points_m.begin(), points_m.end());
    const double foremost = *std::max_element(points_m.begin(), points_m.end());
    const std::vector<Seat> seats = seat_row(track, points_m, equilibrium);
    const auto differs = [&](const Seat& seat) {
        return seat.scale != 1.0 ||
               std::abs(seat.pad_stiffness_n_per_m / rail.uniform_pad_stiffness_n_per_m - 1.0) > tolerance;
    };
    const auto first = std::find_if(seats.begin(), seats.end(), [&](const Seat& s) {
        return differs(s) || s.position_m > rearmost - track.spacing_m - kSameNode;
    });
    const auto last = std::find_if(seats.rbegin(), seats.rend(), [&](const Seat& s) {
        return differs(s) || s.position_m < foremost + track.spacing_m + kSameNode;
    });
    place_nodes(rail, {first, last.base()}, points_m);
    return rail;
}

ExactRail uniform_rail(const TrackParameters& track, const std::vector<double>& points_m, double pad_stiffness_n_per_m,
                       const TrackModifiers& modifiers) {
    ExactRail rail = bare_rail(track, modifiers, pad_stiffness_n_per_m);
    const auto [low, high] = std::minmax_element(points_m.begin(), points_m.end());
    std::vector<Seat> seats;
    const int begin = static_cast<int>(std::floor(*low / track.spacing_m)) - 1;
    const int end = static_cast<int>(std::ceil(*high / track.spacing_m)) + 1;
    for (int j = begin; j <= end; ++j) seats.push_back({j * track.spacing_m, pad_stiffness_n_per_m, 1.0});
    place_nodes(rail, seats, points_m);
    return rail;
}

ExactRailWorkspace::ExactRailWorkspace(const ExactRail& rail)
    : elements(rail.lengths_m.size()),
      supports(rail.nodes.size()),
      condensed(rail.nodes.size()),
      back(rail.nodes.size()),
      load(rail.nodes.size()) {
    const std::size_t points = static_cast<std::size_t>(rail.points);
    result.between.resize(points * points);
    result.trackbed.resize(points);
    met.resize(points);
    row.resize(points);
}

SupportLaw::SupportLaw(const PadParameters& pads, const SupportParameters& support, lanes::Real omega,
                       const TrackModifiers& modifiers)
    : rigid_(support.model == SupportModel::rigid) {
    const double damping = pad_damping(pads);
    shape_ = pad_shape(pads, omega / (2.0 * M_PI));
    if (!rigid_) below_ = support_receptance(support, omega, modifiers.support);
    dashpot_ = lanes::Complex(lanes::Real{}, damping * omega);
    if (modifiers.pads.empty()) return;
    const lanes::Complex factor = modifiers.pads.at(omega);
    shape_ = shape_ * factor;
    dashpot_ = dashpot_ * factor;
}

lanes::Complex SupportLaw::stiffness(double pad_stiffness_n_per_m, double scale) const {
    const lanes::Complex pad = (shape_ * pad_stiffness_n_per_m + dashpot_) * scale;
    if (rigid_) return pad;
    return pad / (pad * below_ + 1.0);
}

SupportLaw::Change SupportLaw::change_from(double uniform_n_per_m) const {
    Change change;
    const lanes::Complex softening = lanes::reciprocal((shape_ * uniform_n_per_m + dashpot_) * below_ + 1.0);
    change.over_stiffness_ = shape_ * softening;
    change.over_scale_ = dashpot_ * softening;
    change.under_stiffness_ = shape_ * below_;
    change.under_scale_ = dashpot_ * below_;
    change.uniform_ = uniform_n_per_m;
    return change;
}

}  // namespace railpem::track
