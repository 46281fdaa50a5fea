// One pad for all of them: against the track in finite elements at rest, and against the receptances of a track that
// stands.

#include "track/statics/rolling_pads.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/unit/track/wei2016_track.hpp"
#include "track/pads/pad_positions.hpp"
#include "track/rail/exact_rail.hpp"
#include "track/statics/static_equilibrium.hpp"

namespace railpem::track {
namespace {

/// Between the points of a history: all harmonics that it holds.
double compression_at(const PadHistory& history, double s) {
    const std::size_t size = history.compression_m.size();
    double sum = 0.0;
    for (std::size_t i = 0; i < size; ++i) {
        const double x = std::numbers::pi * ((s - history.first_m) / history.step_m - static_cast<double>(i));
        // Kernel of the trigonometric interpolation through an even number of points.
        const double turn = x / static_cast<double>(size);
        sum += history.compression_m[i] *
               (std::abs(std::sin(turn)) < 1e-14 ? 1.0 : std::sin(x) / std::tan(turn) / static_cast<double>(size));
    }
    return sum;
}

// At rest the pads of a history are those of the equilibrium, wherever the wheels stand. 1e-4 of the largest
// compression: the equilibrium has the rail's weight between the seats and a polygon of forces at the wheels that the
// history, three points per wave of the fourth order, rounds.
TEST(PadHistory, AtRestIsTheEquilibriumOfTheTrack) {
    TrackParameters track = wei2016_track();
    track.pads.preload_strength = 1.0;
    for (const bool layered : {false, true}) {
        if (layered) track.support = {.model = SupportModel::two_layer, .mass_kg = 150.0, .stiffness_n_per_m = 60e6};
        const PadHistory history = pad_history(track, wei2016_wheels_m, wei2016_wheel_load_n, 0.0, true);
        TrackParameters passing = passing_track(track, wei2016_wheel_load_n);
        for (const double offset : {0.0, 0.17, 0.3}) {
            passing.wheel_offset_m = offset;
            const std::vector<double> pads = pad_positions(passing, wei2016_wheels_m, 0);
            const StaticEquilibrium equilibrium =
                static_equilibrium(passing, wei2016_wheels_m, wei2016_wheel_load_n, pads);
            double most = 0.0, wrong = 0.0;
            for (std::size_t j = 0; j < pads.size(); ++j) {
                const double expected = equilibrium.compression_m[j] - equilibrium.unloaded_compression_m;
                most = std::max(most, expected);
                wrong = std::max(wrong, std::abs(compression_at(history, -pads[j]) - expected));
            }
            EXPECT_LT(wrong, 1e-4 * most) << offset << (layered ? " on sleepers" : "");
        }
    }
}

// Where the iteration begins makes no difference: it ends within 1e-10 of the wheel load in the pads' forces.
TEST(PadHistory, FromANearOneIsTheSame) {
    TrackParameters track = wei2016_track();
    track.pads.preload_strength = 0.8;
    const auto history_of = [&](double load_n, const PadHistory* near) {
        return pad_history(track, wei2016_wheels_m, load_n, 22.0, false, {}, near);
    };
    const PadHistory alone = history_of(wei2016_wheel_load_n, nullptr),
                     lighter = history_of(0.8 * wei2016_wheel_load_n, nullptr),
                     from_near = history_of(wei2016_wheel_load_n, &lighter);
    const PadHistory of_another_grid = pad_history(track, {0.0, 60.0}, wei2016_wheel_load_n, 22.0),
                     from_another = history_of(wei2016_wheel_load_n, &of_another_grid);
    ASSERT_EQ(from_near.compression_m.size(), alone.compression_m.size());
    const double most = *std::max_element(alone.compression_m.begin(), alone.compression_m.end());
    for (std::size_t i = 0; i < alone.compression_m.size(); ++i) {
        EXPECT_NEAR(from_near.compression_m[i], alone.compression_m[i], 1e-9 * most);
        EXPECT_EQ(from_another.compression_m[i], alone.compression_m[i]) << "another grid is no beginning";
    }
}

// A wheel at rest is given 12 m of track, a train 40 m: enough, by the same track in finite elements. 1e-4 of the
// compression as of the equilibrium above (7e-5 is left), of which a second difference has little: 1.2e-3 is left of
// that.
TEST(LoadedDeflection, IsThatOfTheTrackInFiniteElements) {
    TrackParameters track = wei2016_track();
    track.pads.preload_strength = 0.8;
    const LoadedDeflection own = loaded_deflection(track, wei2016_wheel_load_n);
    TrackParameters passing = passing_track(track, wei2016_wheel_load_n);
    passing.wheel_offset_m = 0.0;
    const std::vector<double> pads = pad_positions(passing, {0.0}, 0);
    std::array<double, 3> under{};
    for (int i = 0; i < 3; ++i) {
        const StaticEquilibrium equilibrium =
            static_equilibrium(passing, {0.0}, wei2016_wheel_load_n * (0.9 + 0.1 * i), pads);
        const auto seat =
            std::min_element(pads.begin(), pads.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
        under[static_cast<std::size_t>(i)] = equilibrium.compression_m[static_cast<std::size_t>(seat - pads.begin())];
    }
    const double step = 0.1 * wei2016_wheel_load_n;
    EXPECT_NEAR(own.compliance_m_per_n, (under[2] - under[0]) / (2.0 * step), 1e-4 * own.compliance_m_per_n);
    EXPECT_LT(own.curvature_m_per_n2, 0.0);
    EXPECT_NEAR(own.curvature_m_per_n2, (under[2] - 2.0 * under[1] + under[0]) / (step * step),
                -2e-3 * own.curvature_m_per_n2);
}

// Springs that load does not stiffen, wheels that crawl: the deflection is P times the receptances of the standing
// track. 0.6 m/s: the waves of the rail run some hundred times as fast, and what the motion changes is of the first
// order in that.
TEST(RollingDeflection, OfCrawlingWheelsIsThatOfStandingOnes) {
    constexpr double kSpeed = 0.6;
    constexpr int kPlaces = 24;
    TrackParameters track = wei2016_track();
    track.pads.preload_strength = track.pads.exponent = track.pads.damping_n_s_per_m = 0.0;
    const std::vector<std::complex<double>> rolling = rolling_deflection(
        track, wei2016_wheels_m, kSpeed, pad_history(track, wei2016_wheels_m, wei2016_wheel_load_n, kSpeed), 3);
    for (int m = 1; m <= 3; ++m) {
        std::vector<std::complex<double>> expected(wei2016_wheels_m.size());
        for (int place = 0; place < kPlaces; ++place) {
            track.wheel_offset_m = track.spacing_m * place / kPlaces;
            const ExactRail rail = exact_rail(track, wei2016_wheels_m,
                                              load_independent_pads(track, pad_positions(track, wei2016_wheels_m, 0)));
            ExactRailWorkspace workspace(rail);
            const RailReceptance& receptance =
                rail_receptance(rail, lanes::broadcast(2.0 * std::numbers::pi * m), workspace);
            for (std::size_t i = 0; i < wei2016_wheels_m.size(); ++i)
                for (std::size_t j = 0; j < wei2016_wheels_m.size(); ++j)
                    expected[i] += wei2016_wheel_load_n / kPlaces *
                                   receptance.at(static_cast<int>(i), static_cast<int>(j))[0] *
                                   std::polar(1.0, -2.0 * std::numbers::pi * m * place / kPlaces);
        }
        for (std::size_t i = 0; i < wei2016_wheels_m.size(); ++i)
            EXPECT_NEAR(std::abs(rolling[static_cast<std::size_t>(m - 1) * wei2016_wheels_m.size() + i] - expected[i]),
                        0.0, 0.01 * std::abs(expected[i]))
                << m << ", " << i;
    }
}

// Where load stiffens the pads the line is a tenth larger (found: 1.13); with the tangents of a standing train it
// was 1.7 times that. At no strength the line of linear pads: table and iteration are nowhere seen.
TEST(RollingDeflection, LoadThatStiffensPadsAddsATenth) {
    TrackParameters track = wei2016_track();
    track.pads.preload_strength = 0.0;
    const auto size = [&] {
        return std::abs(rolling_deflection(track, wei2016_wheels_m, 22.0,
                                           pad_history(track, wei2016_wheels_m, wei2016_wheel_load_n, 22.0), 1)[0]);
    };
    const double plain = size();
    track.pads.preload_strength = 1e-6;
    EXPECT_NEAR(size() / plain, 1.0, 1e-5);
    track.pads.preload_strength = 1.0;
    EXPECT_GT(size() / plain, 1.05);
    EXPECT_LT(size() / plain, 1.25);
}

}  // namespace
}  // namespace railpem::track
