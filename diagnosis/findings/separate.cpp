#include "diagnosis/findings/separate.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "diagnosis/observations/channel_scales.hpp"
#include "parameters/parameter_error.hpp"

namespace railpem::diagnosis {

namespace {

constexpr double kDecisive = 10.0;  ///< nats: odds of 20 000 to one

struct Test {
    std::string says;
    double speed_factor;
    double payload_kg;
};

/// Divergence of two predictions per minute: Σ n [tr(S₂⁻¹S₁) − p − log det(S₂⁻¹S₁)], the smaller of both directions.
double divergence(const Observation& observation, std::size_t index, const ExpectedSpectra& first,
                  const ExpectedSpectra& second, const Trial& trial) {
    const double averages_per_minute = 60.0 * observation.all.averages / observation.all.seconds;
    double one = 0.0, other = 0.0;
    for (std::size_t bin = 0; bin < first.bins(); ++bin) {
        const Eigen::MatrixXcd a = complete_prediction(trial, observation, index, first, bin),
                               b = complete_prediction(trial, observation, index, second, bin);
        const Eigen::LLT<Eigen::MatrixXcd> factor_a(a), factor_b(b);
        double logs = 0.0;
        for (long i = 0; i < a.rows(); ++i)
            logs += 2.0 * std::log(factor_a.matrixLLT()(i, i).real() / factor_b.matrixLLT()(i, i).real());
        const double size = static_cast<double>(a.rows());
        one += factor_b.solve(a).trace().real() - size - logs;
        other += factor_a.solve(b).trace().real() - size + logs;
    }
    return averages_per_minute * std::min(one, other);
}

/// What recordings without time series leave open is best asked of a recording of another kind.
std::string other_kind(const std::vector<Observation>& observations) {
    const bool track = std::any_of(observations.begin(), observations.end(),
                                   [](const Observation& own) { return own.scalar->of_track(); });
    return track ? "receptances over a support and in the middle of a bay, with phase, beside what was measured"
                 : "the time series of all channels at two speeds: their cross-spectra tell what levels alone do not";
}

}  // namespace

std::string would_separate(const FittedSet& first, const FittedSet& second, const BelievedCase& believed,
                           const std::vector<Observation>& observations) {
    const auto series =
        std::find_if(observations.begin(), observations.end(), [](const Observation& own) { return !own.scalar; });
    if (series == observations.end()) return other_kind(observations);
    const Observation& known = *series;
    const double v = known.speed_m_per_s;
    const Test tests[] = {
        {fmt::format("a run at {:.0f} km/h", 3.6 * 0.6 * v), 0.6, known.payload_kg},
        {fmt::format("a run at {:.0f} km/h", 3.6 * 1.5 * v), 1.5, known.payload_kg},
        {fmt::format("a run at {:.0f} km/h with 10 t more in the car body", 3.6 * v), 1.0, known.payload_kg + 1e4},
        {fmt::format("more of the same, {:.0f} km/h", 3.6 * v), 1.0, known.payload_kg}};
    const Test* best = nullptr;
    double most = 0.0;
    for (const Test& test : tests) try {
            Observation observation = known;
            observation.payload_kg = test.payload_kg;
            const double speed = v * test.speed_factor;
            observation.expectation.high_hz =
                std::min(observation.expectation.high_hz, observation.expectation.high_hz * test.speed_factor);
            const auto index = static_cast<std::size_t>(series - observations.begin());
            const auto expect = [&](const FittedSet& set) {
                ExpectedSpectra spectra =
                    expected_spectra(case_of(set.fit.trial, believed, observation), speed, observation.kernel,
                                     observation.channels, {}, observation.expectation);
                scale_channels(set.fit.trial.log_gain[index], spectra.values);
                return spectra;
            };
            const double nats = divergence(observation, index, expect(first), expect(second), first.fit.trial);
            if (nats > most) most = nats, best = &test;
        } catch (const parameters::ParameterError&) {
        }
    if (!best || most < 0.05)
        return "no run of this train would: a receptance or decay rate measured on the track, or a test of the part "
               "alone";
    return fmt::format("{}: {:.2g} nats a minute, decided after {:.2g} minutes", best->says, most,
                       std::max(0.1, kDecisive / most));
}

}  // namespace railpem::diagnosis
