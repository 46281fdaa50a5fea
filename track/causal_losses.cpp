#include "track/causal_losses.hpp"

#include <cmath>

namespace railpem::track {

namespace {

bool has_constant_loss(const PadParameters& pads) {
    return pads.loss_factor > 0.0 && pads.loss_law == LossLaw::constant && pads.table_frequency_hz.empty();
}

bool has_constant_loss(const SupportParameters& support) {
    return support.model == SupportModel::two_layer && support.loss_factor > 0.0 && support.mass_kg > 0.0;
}

bool has_constant_loss(const RailParameters& rail) {
    return rail.loss_factor > 0.0 && rail.loss_reference_hz == 0.0;
}

}  // namespace

TrackParameters causal_losses(TrackParameters track) {
    if (has_constant_loss(track.pads)) track.pads.loss_law = LossLaw::causal;
    if (has_constant_loss(track.support)) {
        SupportParameters& support = track.support;
        support.damping_n_s_per_m += support.loss_factor * std::sqrt(support.stiffness_n_per_m * support.mass_kg);
        support.loss_factor = 0.0;
    }
    if (has_constant_loss(track.rail)) track.rail.loss_reference_hz = kRailLossHz;
    return track;
}

std::vector<std::string> constant_losses(const TrackParameters& track) {
    std::vector<std::string> parts;
    if (has_constant_loss(track.pads)) parts.emplace_back("the pads");
    if (has_constant_loss(track.support)) parts.emplace_back("the ballast");
    if (has_constant_loss(track.rail)) parts.emplace_back("the rail");
    return parts;
}

}  // namespace railpem::track
