#include "pem/coupling/track_response.hpp"

#include <cmath>
#include <optional>

#include "pem/angular_frequency.hpp"
#include "pem/rail/case_equilibrium.hpp"
#include "pem/threads.hpp"
#include "track/rail/decay_rate.hpp"
#include "track/rail/exact_rail.hpp"

namespace railpem::pem {

namespace {

/// K0 of a pad far from every wheel: with a preload-dependent law that of the unloaded track.
double unloaded_pad_stiffness(const CaseParameters& parameters) {
    return case_equilibrium(parameters).unloaded_dynamic_stiffness_n_per_m;
}

}  // namespace

std::vector<double> geometric_lines(double from_hz, double to_hz, int lines) {
    std::vector<double> frequencies(static_cast<std::size_t>(lines));
    const double ratio = lines > 1 ? std::log(to_hz / from_hz) / (lines - 1) : 0.0;
    for (int i = 0; i < lines; ++i) frequencies[static_cast<std::size_t>(i)] = from_hz * std::exp(ratio * i);
    return frequencies;
}

TrackResponse track_response(const CaseParameters& parameters, const std::vector<double>& frequency_hz, bool with_decay,
                             int threads) {
    const double spacing = parameters.track.spacing_m;
    const double stiffness = unloaded_pad_stiffness(parameters);
    // The force stands in the middle of bay 0; for decay rates the responses of EN 15461 go with it.
    std::vector<double> points{0.5 * spacing};
    if (with_decay) {
        points = track::decay_rate_positions_m(spacing);
        for (double& point : points) point += 0.5 * spacing;
    }
    const track::ExactRail pad_rail =
        track::uniform_rail(parameters.track, {0.0}, stiffness, parameters.modifiers.track);
    const track::ExactRail rail = track::uniform_rail(parameters.track, points, stiffness, parameters.modifiers.track);

    TrackResponse response;
    const std::size_t lines = frequency_hz.size();
    response.frequency_hz = frequency_hz;
    response.over_pad.resize(lines);
    response.mid_bay.resize(lines);
    response.bloch_decay_db_per_m.resize(lines);
    response.squared_transfer.resize(with_decay ? lines : 0);
    const std::size_t groups = (lines + lanes::width - 1) / lanes::width;
    TeamFailure failure;
#pragma omp parallel num_threads(thread_count(threads))
    {
        std::optional<track::ExactRailWorkspace> over_pad, along;
        failure.guard([&] {
            over_pad.emplace(pad_rail);
            along.emplace(rail);
        });
#pragma omp for schedule(dynamic, 4)
        for (std::size_t group = 0; group < groups; ++group)
            failure.guard([&] {
                const lanes::Real omega = group_omega(frequency_hz, group);
                const lanes::Complex pad = track::rail_receptance(pad_rail, omega, *over_pad).at(0, 0);
                const track::RailReceptance& bay = track::rail_receptance(rail, omega, *along);
                const track::HalfTrack half = track::uniform_half_track(rail, omega);
                for (std::size_t lane = 0; lane < lanes::width && group * lanes::width + lane < lines; ++lane) {
                    const std::size_t line = group * lanes::width + lane;
                    const int l = static_cast<int>(lane);
                    response.over_pad[line] = pad[l];
                    response.mid_bay[line] = bay.at(0, 0)[l];
                    response.bloch_decay_db_per_m[line] =
                        track::bloch_decay_rate_db_per_m(half.factor_1[l], half.factor_2[l], spacing);
                    if (!with_decay) continue;
                    const double omega4 = std::pow(kTwoPi * frequency_hz[line], 4);
                    for (std::size_t n = 0; n < points.size(); ++n)
                        response.squared_transfer[line].push_back(omega4 *
                                                                  std::norm(bay.at(static_cast<int>(n), 0)[l]));
                }
            });
    }
    failure.rethrow();
    return response;
}

std::vector<DecayBand> decay_bands(const TrackResponse& response, const std::vector<double>& centres_hz,
                                   double spacing_m) {
    const std::vector<double> positions = track::decay_rate_positions_m(spacing_m);
    std::vector<DecayBand> bands;
    for (const double centre : centres_hz) {
        std::vector<double> squared(positions.size(), 0.0);
        double bloch = 0.0;
        int count = 0;
        for (std::size_t line = 0; line < response.squared_transfer.size(); ++line) {
            const double f = response.frequency_hz[line];
            if (f < centre * std::pow(10.0, -0.05) || f >= centre * std::pow(10.0, 0.05)) continue;
            for (std::size_t n = 0; n < squared.size(); ++n) squared[n] += response.squared_transfer[line][n];
            bloch += response.bloch_decay_db_per_m[line];
            ++count;
        }
        if (count >= 3) bands.push_back({centre, track::decay_rate_db_per_m(positions, squared), bloch / count});
    }
    return bands;
}

}  // namespace railpem::pem
