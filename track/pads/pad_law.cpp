#include "track/pads/pad_law.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "lanes/elementary_lanes.hpp"

namespace railpem::track {

namespace {

std::complex<double> table_shape(const PadParameters& pads, double frequency_hz) {
    const std::vector<double>&f = pads.table_frequency_hz, &storage = pads.table_storage_ratio,
          &loss = pads.table_loss_factor;
    assert(storage.size() == f.size() && loss.size() == f.size());
    if (frequency_hz <= f.front()) return {storage.front(), storage.front() * loss.front()};
    if (frequency_hz >= f.back()) return {storage.back(), storage.back() * loss.back()};
    const std::size_t i = static_cast<std::size_t>(std::upper_bound(f.begin(), f.end(), frequency_hz) - f.begin());
    const double share = std::log(frequency_hz / f[i - 1]) / std::log(f[i] / f[i - 1]);
    const double ratio = storage[i - 1] * std::pow(storage[i] / storage[i - 1], share);
    return {ratio, ratio * (loss[i - 1] + share * (loss[i] - loss[i - 1]))};
}

bool loss_replaces_dashpot(const PadParameters& pads) {
    return pads.table_frequency_hz.empty() && pads.loss_factor > 0.0 && pads.loss_law == LossLaw::causal;
}

}  // namespace

std::complex<double> pad_shape(const PadParameters& pads, double frequency_hz) {
    assert(frequency_hz > 0.0);
    if (!pads.table_frequency_hz.empty()) return table_shape(pads, frequency_hz);
    std::complex<double> shape = std::pow(frequency_hz / pads.reference_frequency_hz, pads.exponent);
    if (pads.causal) shape *= std::complex<double>(1.0, std::tan(0.5 * std::numbers::pi * pads.exponent));
    shape *= std::complex<double>(1.0, pads.loss_factor);
    if (loss_replaces_dashpot(pads))
        shape *= std::pow(frequency_hz / pads.loss_reference_hz, 2.0 / std::numbers::pi * std::atan(pads.loss_factor));
    return shape;
}

lanes::Complex pad_shape(const PadParameters& pads, lanes::Real frequency_hz) {
    lanes::Complex shape;
    if (!pads.table_frequency_hz.empty()) {
        for (int lane = 0; lane < lanes::width; ++lane) shape.set(lane, table_shape(pads, frequency_hz[lane]));
        return shape;
    }
    shape.re = lanes::power(frequency_hz / pads.reference_frequency_hz, pads.exponent);
    if (pads.causal) shape.im = shape.re * std::tan(0.5 * std::numbers::pi * pads.exponent);
    if (pads.loss_factor != 0.0) shape = shape * lanes::Complex(std::complex<double>(1.0, pads.loss_factor));
    if (!loss_replaces_dashpot(pads)) return shape;
    return shape *
           lanes::power(frequency_hz / pads.loss_reference_hz, 2.0 / std::numbers::pi * std::atan(pads.loss_factor));
}

double pad_damping(const PadParameters& pads) {
    return loss_replaces_dashpot(pads) ? 0.0 : pads.damping_n_s_per_m;
}

double initial_dynamic_stiffness(const PadParameters& pads, double static_stiffness_n_per_m) {
    const double s = pads.preload_strength;
    return pads.dynamic_to_static_ratio *
           std::max(0.0, (1.0 - s) * pads.static_stiffness_n_per_m + s * static_stiffness_n_per_m);
}

}  // namespace railpem::track
