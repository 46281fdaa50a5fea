#include "diagnosis/model/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "diagnosis/observations/force_reference.hpp"
#include "diagnosis/observations/measured_irregularity.hpp"
#include "diagnosis/observations/shows.hpp"
#include "pem/contact.hpp"
#include "pem/response_names.hpp"

namespace railpem::diagnosis {

namespace {

std::vector<double> spline_wavelengths(const std::vector<Observation>& observations, double nodes_per_octave) {
    double shortest = 1e300, longest = 0.0;
    for (const Observation& observation : observations) {
        if (!reaches(observation, Element::irregularity)) continue;
        shortest = std::min(shortest, observation.speed_m_per_s / observation.expectation.high_hz);
        longest = std::max(longest, observation.speed_m_per_s / observation.expectation.low_hz);
    }
    if (longest == 0.0) return {};
    const int count = 1 + static_cast<int>(std::ceil(nodes_per_octave * std::log2(longest / shortest)));
    std::vector<double> nodes;
    for (int i = 0; i < count; ++i)
        nodes.push_back(shortest * std::pow(longest / shortest, static_cast<double>(i) / (count - 1)));
    return nodes;
}

/// The longest wave first belongs to spline nodes of increasing wavelength.
void add_irregularity(const BelievedCase& believed, const std::vector<Observation>& observations,
                      std::vector<Unknown>& unknowns) {
    const std::vector<double> nodes = spline_wavelengths(observations, kBeliefs.nodes_per_octave);
    if (nodes.empty()) return;  // a track without a vehicle does not feel it
    const std::vector<NodeBelief> beliefs =
        node_beliefs(believed.numbers.irregularity, believed.measured_irregularity, nodes);
    const bool any_measured =
        std::any_of(beliefs.begin(), beliefs.end(), [](const NodeBelief& belief) { return belief.measured; });
    for (std::size_t i = 0; i < nodes.size(); ++i)
        unknowns.push_back({.kind = UnknownKind::irregularity,
                            .name = fmt::format("irregularity at {:.2g} m", nodes[i]),
                            .mean = beliefs[i].measured ? beliefs[i].mean : 0.0,
                            .deviation = beliefs[i].measured ? beliefs[i].deviation : kBeliefs.irregularity_deviation,
                            .low = -kBeliefs.most_irregularity,
                            .high = kBeliefs.most_irregularity,
                            .step = kBeliefs.smooth_step,
                            .index = static_cast<int>(i),
                            .set = [nodes, i](Trial& trial, double x) {
                                auto& spline = trial.numbers.irregularity.wave_correction;
                                if (spline.wavelength_m.empty()) {
                                    spline.wavelength_m = nodes;
                                    spline.log_factor.assign(nodes.size(), 0.0);
                                }
                                spline.log_factor[i] = x;
                            }});
    unknowns.push_back({.kind = UnknownKind::irregularity,
                        .name = "irregularity level",
                        .deviation = any_measured ? kBeliefs.measured_level_deviation : kBeliefs.level_deviation,
                        .low = -kBeliefs.most_irregularity,
                        .high = kBeliefs.most_irregularity,
                        .step = kBeliefs.smooth_step,
                        .index = -1,
                        .set = [level = believed.numbers.irregularity.level_db](Trial& trial, double x) {
                            trial.numbers.irregularity.level_db = level + x * 10.0 / std::log(10.0);
                        }});
}

/// What wheels meet alone: only cross-spectra tell it from what they meet one after the other.
void add_met_alone(const std::vector<Observation>& observations, std::vector<Unknown>& unknowns) {
    const auto tells = [](const Observation& own) { return !own.scalar && reaches(own, Element::irregularity); };
    if (std::none_of(observations.begin(), observations.end(), tells)) return;
    const std::vector<double> nodes = spline_wavelengths(observations, kBeliefs.met_alone_nodes_per_octave);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        unknowns.push_back({.kind = UnknownKind::met_alone,
                            .name = fmt::format("share met by each wheel alone at {:.2g} m", nodes[i]),
                            .mean = kBeliefs.log_met_alone,
                            .deviation = kBeliefs.met_alone_deviation,
                            .low = kBeliefs.log_least_met_alone,
                            .high = kBeliefs.log_most_met_alone,
                            .step = kBeliefs.smooth_step,
                            .index = static_cast<int>(i),
                            .element = Element::irregularity,
                            .set = [nodes, i](Trial& trial, double x) {
                                spectra::LogSpline& own = trial.numbers.modifiers.met_alone;
                                if (own.empty()) {
                                    own.wavelength_m = nodes;
                                    own.log_factor.assign(nodes.size(), kBeliefs.log_met_alone);
                                }
                                own.log_factor[i] = x;
                            }});
}

/// The sensitivity of every sensor whose unit can be trusted. Of every recording by itself: it is fitted anew, and
/// changes with the temperature.
void add_calibrations(const Observation& observation, std::size_t o, std::vector<Unknown>& unknowns) {
    for (std::size_t c = 0; c < observation.calibration.size(); ++c)
        if (!observation.unknown_scale[c] && observation.calibration[c] > 0.0)
            unknowns.push_back(
                {.kind = UnknownKind::calibration,
                 .name = fmt::format("calibration of {} in {}", observation.channel_names[c], observation.name),
                 .deviation = 2.0 * observation.calibration[c],  // of the power
                 .low = -kBeliefs.most_calibration,
                 .high = kBeliefs.most_calibration,
                 .step = kBeliefs.smooth_step,
                 .observation = static_cast<int>(o),
                 .index = static_cast<int>(c),
                 .element = Element::sensor,
                 .set = [o, c](Trial& trial, double x) { trial.log_gain[o][c] = x; }});
}

/// The first guess of a channel's scale.
double guessed_scale(const Observation& observation, std::size_t channel) {
    return observation.log_scale.empty() ? 0.0 : observation.log_scale[channel];
}

/// The scale of every channel whose unit cannot be trusted.
void add_scales(const Observation& observation, std::size_t o, std::vector<Unknown>& unknowns) {
    for (std::size_t c = 0; c < observation.channels.size(); ++c)
        if (observation.unknown_scale[c])
            unknowns.push_back(
                {.kind = UnknownKind::gain,
                 .name = fmt::format("scale of {} in {}", observation.channel_names[c], observation.name),
                 .mean = guessed_scale(observation, c),
                 .deviation = kBeliefs.scale_deviation,
                 .low = guessed_scale(observation, c) - kBeliefs.most_scale,
                 .high = guessed_scale(observation, c) + kBeliefs.most_scale,
                 .observation = static_cast<int>(o),
                 .index = static_cast<int>(c),
                 .set = [o, c](Trial& trial, double x) { trial.log_gain[o][c] = x; }});
}

/// The discrepancy of a recording and of those that share it.
void add_discrepancy(const std::vector<Observation>& observations, std::size_t o, std::vector<Unknown>& unknowns) {
    std::vector<std::size_t> led;
    for (std::size_t other = 0; other < observations.size(); ++other)
        if (observations[other].scalar && observations[other].scalar->leader.value_or(other) == o) led.push_back(other);
    if (led.empty()) return;
    unknowns.push_back({.kind = UnknownKind::discrepancy,
                        .name = "discrepancy of " + observations[o].name,
                        .mean = std::log(kBeliefs.scalar_discrepancy),
                        .deviation = kBeliefs.scalar_discrepancy_deviation,
                        .low = std::log(kBeliefs.least_discrepancy),
                        .high = std::log(kBeliefs.most_discrepancy),
                        .observation = static_cast<int>(o),
                        .set = [led](Trial& trial, double x) {
                            for (const std::size_t own : led) trial.discrepancy[own] = std::exp(x);
                        }});
}

/// The width of all lines. Held at a guess it is taken from their power: a line narrower than believed has less beside
/// its bin than the model says, and the amplitude of an out-of-round wheel came out 14 % low.
void add_fluctuation(const BelievedCase& believed, const std::vector<Observation>& observations,
                     std::vector<Unknown>& unknowns) {
    const double own = believed.numbers.running.speed_fluctuation;
    if (std::all_of(observations.begin(), observations.end(),
                    [](const Observation& observation) { return observation.scalar.has_value(); }))
        return;
    unknowns.push_back({.kind = UnknownKind::width,
                        .name = "speed fluctuation",
                        .deviation = kBeliefs.fluctuation_deviation,
                        .low = std::log(kBeliefs.least_fluctuation / own),
                        .high = std::log(kBeliefs.most_fluctuation / own),
                        .step = kBeliefs.smooth_step,
                        .set = [own](Trial& trial, double x) {
                            trial.numbers.running.speed_fluctuation =
                                std::clamp(own * std::exp(x), kBeliefs.least_fluctuation, kBeliefs.most_fluctuation);
                        }});
}

/// What a sensor's noise has beside its white part: it grows towards low frequencies with 1/f.
void add_flicker(const Observation& observation, std::size_t o, std::vector<Unknown>& unknowns) {
    for (std::size_t c = 0; c < observation.noise_psd.size(); ++c) {
        const double guess = std::log(observation.noise_psd[c]);
        unknowns.push_back(
            {.kind = UnknownKind::flicker,
             .name = fmt::format("1/f noise of {} in {}", observation.channel_names[c], observation.name),
             .mean = guess - kBeliefs.noise_below_guess,
             .deviation = kBeliefs.noise_deviation,
             .low = guess - kBeliefs.noise_low,
             .high = guess + kBeliefs.flicker_high,
             .observation = static_cast<int>(o),
             .index = static_cast<int>(c),
             .set = [o, c](Trial& trial, double x) { trial.flicker_psd[o][c] = std::exp(x); }});
    }
}

void add_recording(const std::vector<Observation>& observations, std::vector<Unknown>& unknowns) {
    for (std::size_t o = 0; o < observations.size(); ++o) {
        const Observation& observation = observations[o];
        if (observation.scalar) add_discrepancy(observations, o, unknowns);
        add_scales(observation, o, unknowns);
        add_calibrations(observation, o, unknowns);
        if (!reaches(observation, Element::irregularity)) continue;
        const double speed = observation.speed_m_per_s;
        unknowns.push_back(
            {.kind = UnknownKind::speed,
             .name = "speed of " + observation.name,
             .deviation = observation.speed_tolerance,
             .low = -kBeliefs.most_speed,
             .high = kBeliefs.most_speed,
             .step = kBeliefs.speed_step,
             .observation = static_cast<int>(o),
             .set = [o, speed](Trial& trial, double x) { trial.speed_m_per_s[o] = speed * std::exp(x); }});
        add_flicker(observation, o, unknowns);
        for (std::size_t c = 0; c < observation.noise_psd.size(); ++c) {
            const double guess = std::log(observation.noise_psd[c]);
            unknowns.push_back(
                {.kind = UnknownKind::noise,
                 .name = fmt::format("noise of {} in {}", observation.channel_names[c], observation.name),
                 .mean = guess - kBeliefs.noise_below_guess,
                 .deviation = kBeliefs.noise_deviation,
                 .low = guess - kBeliefs.noise_low,
                 .high = guess + kBeliefs.noise_high,
                 .observation = static_cast<int>(o),
                 .index = static_cast<int>(c),
                 .set = [o, c](Trial& trial, double x) { trial.noise_psd[o][c] = std::exp(x); }});
        }
    }
}

void add_floor(const std::vector<Observation>& observations, std::vector<Unknown>& unknowns) {
    for (std::size_t group = 0; group < kFloorGroups; ++group) {
        const auto present = [&](const Observation& observation) {
            return !observation.scalar &&
                   std::any_of(observation.channels.begin(), observation.channels.end(),
                               [&](const ObservedChannel& channel) { return floor_group(channel.response) == group; });
        };
        if (std::none_of(observations.begin(), observations.end(), present)) continue;
        for (int node = 0; node < kFloorNodeCount; ++node) {
            const int index = static_cast<int>(group) * kFloorNodeCount + node;
            unknowns.push_back({.kind = UnknownKind::floor,
                                .name = fmt::format("floor {} at {:g} Hz", group,
                                                    kBeliefs.floor_nodes_hz[static_cast<std::size_t>(node)]),
                                .mean = kBeliefs.log_floor_mean,
                                .deviation = kBeliefs.floor_deviation,
                                .low = kBeliefs.log_least_floor,
                                .high = kBeliefs.log_most_floor,
                                .index = index,
                                .set = [index](Trial& trial, double x) {
                                    trial.floor[static_cast<std::size_t>(index)] = std::exp(x);
                                }});
        }
    }
}

}  // namespace

std::size_t floor_group(std::size_t response) {
    const std::string& where = pem::response_names()[response].where;
    return where.starts_with("body") ? 0 : where.starts_with("bogie") ? 1 : where.starts_with("wheel") ? 2 : 3;
}

FloorPlace floor_place(double frequency_hz) {
    const std::array<double, kFloorNodeCount>& nodes = kBeliefs.floor_nodes_hz;
    const double f = std::clamp(frequency_hz, nodes.front(), nodes.back());
    std::size_t node = 0;
    while (node + 2 < nodes.size() && f > nodes[node + 1]) ++node;
    return {static_cast<int>(node), std::log(f / nodes[node]) / std::log(nodes[node + 1] / nodes[node])};
}

pem::CaseParameters case_of(const Trial& trial, const BelievedCase& believed, const Observation& observation) {
    pem::CaseParameters parameters = trial.numbers;
    apply(trial.effects, believed.access, parameters, true);
    parameters.vehicle.payload_kg = observation.payload_kg;
    for (pem::ForceSpectrum* own : {&parameters.modifiers.primary_forces, &parameters.modifiers.secondary_forces})
        if (!own->empty() && !observation.fitted.values.empty())
            own->reference_n2_per_hz = force_reference(observation, own->frequency_hz);
    // Quoted spectra and hammer tests do not say that the wheels moved; what the case says of it holds.
    if (!observation.scalar) parameters.solver.moving = true;
    parameters.frequency.to_hz = observation.expectation.high_hz + 10.0;
    return parameters;
}

Trial believed_trial(const BelievedCase& believed, const std::vector<Observation>& observations) {
    Trial trial{.numbers = believed.numbers, .effects = believed.effects};
    for (const Observation& observation : observations) {
        trial.speed_m_per_s.push_back(observation.speed_m_per_s);
        trial.noise_psd.push_back(observation.noise_psd);
        trial.flicker_psd.emplace_back(observation.noise_psd.size(), 0.0);
        trial.discrepancy.push_back(observation.scalar ? kBeliefs.scalar_discrepancy : 0.0);
        trial.log_gain.emplace_back();
        for (std::size_t c = 0; c < observation.channels.size(); ++c)
            trial.log_gain.back().push_back(guessed_scale(observation, c));
    }
    return trial;
}

std::vector<Unknown> nuisance_unknowns(const BelievedCase& believed, const std::vector<Observation>& observations) {
    std::vector<Unknown> unknowns;
    for (const BelievedNumber& number : believed.uncertain)
        unknowns.push_back({.kind = UnknownKind::number,
                            .name = number.key,
                            .deviation = number.tolerance,
                            .low = std::log(kBeliefs.least_number),
                            .high = std::log(kBeliefs.most_number),
                            .step = kBeliefs.number_step,
                            .nature = number.nature,
                            .set = [&access = believed.access, number](Trial& trial, double x) {
                                access.set(trial.numbers, number.key, number.value * std::exp(x));
                            }});
    add_irregularity(believed, observations, unknowns);
    add_met_alone(observations, unknowns);
    const double passing = believed.numbers.sleeper_passing.amplitude_factor;
    if (passing > 0.0)
        unknowns.push_back({.kind = UnknownKind::passing,
                            .name = "sleeper passing",
                            .deviation = kBeliefs.passing_deviation,
                            .low = -kBeliefs.most_passing,
                            .high = kBeliefs.most_passing,
                            .step = kBeliefs.smooth_step,
                            .set = [passing](Trial& trial, double x) {
                                trial.numbers.sleeper_passing.amplitude_factor = passing * std::exp(x);
                            }});
    add_fluctuation(believed, observations, unknowns);
    add_recording(observations, unknowns);
    add_floor(observations, unknowns);
    return unknowns;
}

double noise_at(const Trial& trial, std::size_t observation, std::size_t channel, double frequency_hz) {
    const double white = trial.noise_psd[observation][channel];
    return trial.flicker_psd.empty() ? white : white + trial.flicker_psd[observation][channel] / frequency_hz;
}

double to_coordinate(const EffectParameter& parameter, double value) {
    return parameter.spread == Spread::logarithmic ? std::log(value) : value;
}

double from_coordinate(const EffectParameter& parameter, double coordinate) {
    return parameter.spread == Spread::logarithmic ? std::exp(coordinate) : coordinate;
}

std::vector<Unknown> effect_unknowns(const EffectInstance& instance, std::size_t effect_index) {
    const Effect* effect = find_effect(instance.effect);
    assert(effect);
    std::vector<Unknown> unknowns;
    for (const EffectParameter& parameter : effect->parameters) {
        const bool replaced =
            std::any_of(effect->choices.begin(), effect->choices.end(), [&](const EffectChoice& choice) {
                return choice.replaces == parameter.name && instance.choices.count(choice.name) > 0;
            });
        if (replaced) continue;
        const double low = to_coordinate(parameter, parameter.low), high = to_coordinate(parameter, parameter.high);
        unknowns.push_back({.kind = UnknownKind::effect,
                            .name = effect->id + "." + parameter.name,
                            .mean = 0.5 * (low + high),
                            .deviation = 0.5 * (high - low),
                            .low = low,
                            .high = high,
                            .step = kBeliefs.usual_step * (high - low),
                            .index = static_cast<int>(effect_index),
                            .set = [parameter, effect_index](Trial& trial, double x) {
                                trial.effects[effect_index].values[parameter.name] = from_coordinate(parameter, x);
                            }});
    }
    return unknowns;
}

const EffectParameter* parameter_of(const Unknown& unknown) {
    if (unknown.kind != UnknownKind::effect) return nullptr;
    const std::size_t point = unknown.name.find('.');
    const Effect& effect = *find_effect(unknown.name.substr(0, point));
    const auto own = std::find_if(effect.parameters.begin(), effect.parameters.end(), [&](const EffectParameter& one) {
        return one.name == unknown.name.substr(point + 1);
    });
    return own == effect.parameters.end() ? nullptr : &*own;
}

void set_values(Trial& trial, const std::vector<Unknown>& unknowns, const std::vector<double>& values) {
    for (std::size_t i = 0; i < unknowns.size(); ++i) unknowns[i].set(trial, values[i]);
}

}  // namespace railpem::diagnosis
