#include "diagnosis/findings/friction_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnosis/fit/synthesis.hpp"
#include "parameters/parameter_error.hpp"
#include "pem/response_names.hpp"

namespace railpem::diagnosis {

namespace {

constexpr double kMinute_s = 60.0;
constexpr std::uint64_t kSeed = 1;  // of the run that is drawn: how much it tells hardly depends on the draw
constexpr double kFactors[] = {1.0, 0.6, 1.5};  // of the speed

/// Null where all recordings are of the track alone.
const Observation* first_of_vehicle(const LikelihoodContext& context) {
    const auto found = std::find_if(context.observations->begin(), context.observations->end(),
                                    [](const Observation& own) { return !own.scalar; });
    return found == context.observations->end() ? nullptr : &*found;
}

/// The channels of `known` as accelerations, at another speed.
Observation run_like(const Observation& known, double speed, const BelievedCase& believed) {
    std::vector<std::string> responses;
    for (const ObservedChannel& channel : known.channels)
        responses.push_back(pem::response_names()[channel.response].where);
    ObservationOptions options;
    options.window_s = 1.0 / known.kernel.bin_hz();
    options.low_hz = known.expectation.low_hz;
    options.high_hz = known.expectation.high_hz;
    Observation run = observation_shape(speed, known.payload_kg, kMinute_s, responses, believed.numbers, options);
    run.expectation.contacts = known.expectation.contacts;
    return run;
}

/// The trial where it says nothing of the run yet: its speed and noise.
Trial with_run(Trial trial, const Observation& run) {
    trial.speed_m_per_s.push_back(run.speed_m_per_s);
    trial.noise_psd.push_back(run.noise_psd);
    trial.flicker_psd.emplace_back(run.noise_psd.size(), 0.0);
    trial.discrepancy.push_back(0.0);
    trial.log_gain.emplace_back(run.channels.size(), 0.0);
    return trial;
}

}  // namespace

double deviation_with_run(const Fit& fit, double speed, const LikelihoodContext& context) {
    std::vector<Observation> observations = *context.observations;
    const std::size_t index = observations.size();
    observations.push_back(run_like(*first_of_vehicle(context), speed, *context.believed));
    Fit more{.trial = with_run(fit.trial, observations.back()), .unknowns = fit.unknowns, .values = fit.values};
    observations.back() = synthesise(observations.back(), index, more.trial, *context.believed, kSeed);
    for (const Unknown& unknown : nuisance_unknowns(*context.believed, observations)) {
        if (unknown.observation != static_cast<int>(index)) continue;
        more.unknowns.push_back(unknown);
        more.values.push_back(unknown.mean);
    }
    LikelihoodContext with = context;
    with.observations = &observations;
    more.predictions = predict(more.trial, with);
    more.gradient = Eigen::VectorXd::Zero(static_cast<long>(more.unknowns.size()));
    return friction_power(more, with).value().deviation;
}

std::string would_tell_friction(const Fit& fit, const LikelihoodContext& context) {
    const Observation* known = first_of_vehicle(context);
    std::optional<double> best;
    double speed = 0.0;
    for (const double factor : kFactors) try {
            if (!known) break;
            const double own = factor * known->speed_m_per_s, deviation = deviation_with_run(fit, own, context);
            if (best && deviation >= *best) continue;
            best = deviation;
            speed = own;
        } catch (const parameters::ParameterError&) {
        }
    if (!best) return "a test of the damper alone";
    return fmt::format(
        "a minute at {:.0f} km/h, after which the power of the forces that friction has beside its damping is known to "
        "+- {:.2g} of a constant force's",
        3.6 * speed, *best);
}

}  // namespace railpem::diagnosis
