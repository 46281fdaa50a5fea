#include "pem/coupling/passing_feedback.hpp"

#include <complex>

#include "pem/angular_frequency.hpp"
#include "track/statics/rolling_pads.hpp"

namespace railpem::pem {

void feed_back(const CaseParameters& parameters, const CoupledModel& model, double speed,
               std::vector<SpectralLine>& passing) {
    if (passing.size() < 2) return;
    WheelVector irregularity;
    for (std::size_t wheel = 0; wheel < 4; ++wheel)
        irregularity[wheel] = lanes::Complex(passing.front().amplitude_m[wheel]);
    CoupledWorkspace workspace(model);
    const WheelVector force = contact_forces(
        solve_group(model, lanes::broadcast(kTwoPi * passing.front().frequency_hz), workspace), irregularity);
    std::vector<std::complex<double>> swelling_n;
    for (const lanes::Complex& own : force) swelling_n.push_back(own[0]);
    // What the constant loads do is in the lines already: of linear pads it is left out at once.
    const bool linear = parameters.track.pads.preload_strength == 0.0;
    const double load_n = wheel_load_n(parameters);
    const track::PadHistory* known = model.rail->constant_loads();
    const track::PadHistory constant = linear  ? track::PadHistory{}
                                       : known ? *known
                                               : track::pad_history(parameters.track, model.wheels_m, load_n, speed,
                                                                    false, {}, nullptr, parameters.modifiers.track);
    track::PadHistory history = track::pad_history(parameters.track, model.wheels_m, linear ? 0.0 : load_n, speed,
                                                   false, swelling_n, &constant, parameters.modifiers.track);
    for (std::size_t i = 0; i < constant.force_n_m.size(); ++i) history.force_n_m[i] -= constant.force_n_m[i];
    const auto deflection =
        track::rolling_deflection(parameters.track, model.wheels_m, speed, history, static_cast<int>(passing.size()),
                                  false, parameters.modifiers.track);
    for (std::size_t line = 1; line < passing.size(); ++line)
        for (std::size_t wheel = 0; wheel < 4; ++wheel)
            passing[line].amplitude_m[wheel] -= 2.0 * deflection[line * 4 + wheel];
}

}  // namespace railpem::pem
