// Whether the lines of a case show what is there.

#include "pem/lines/judged_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "spectra/integrate_psd.hpp"
#include "spectra/third_octaves.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::pem {
namespace {

constexpr double kRunning_m_per_s = 22.0;

/// Dampers so weak that body and bogies resonate within 0.01 Hz.
CaseParameters lightly_damped(double step_hz) {
    CaseParameters c = tests::paper_case(1);
    c.vehicle.secondary.damping_n_s_per_m = 1e3;
    c.vehicle.primary.damping_n_s_per_m = 1e3;
    c.frequency = {.from_hz = 1.0, .to_hz = 101.0, .step_hz = step_hz};
    return c;
}

double rms(const JudgedCase& judged, const std::string& where) {
    return spectra::root_mean_square(judged.lines(), judged.psd(response_index(where)));
}

bool warned(const JudgedCase& judged, const std::string& word) {
    return std::any_of(judged.solution.warnings.begin(), judged.solution.warnings.end(),
                       [&](const std::string& warning) { return warning.find(word) != std::string::npos; });
}

/// Within 1 % per third-octave each, so that two agree within 2 %, levels within 0.1 dB.
TEST(JudgedCase, CoarseAndFineLinesAgree) {
    const JudgedCase fine = solve_judged(lightly_damped(0.01), kRunning_m_per_s);
    for (const double step : {5.0, 1.0, 0.0}) {
        const JudgedCase coarse = solve_judged(lightly_damped(step), kRunning_m_per_s);
        for (const ResponseName& name : response_names())
            EXPECT_NEAR(rms(coarse, name.where) / rms(fine, name.where), 1.0, 0.02) << name.where << ' ' << step;
        for (const char* where : {"body_front", "bogie_1", "wheel_1"}) {
            const auto a = spectra::third_octave_levels(coarse.lines(), coarse.psd(response_index(where)));
            const auto b = spectra::third_octave_levels(fine.lines(), fine.psd(response_index(where)));
            ASSERT_EQ(a.size(), b.size());
            for (std::size_t i = 0; i < a.size(); ++i)
                EXPECT_NEAR(a[i].level_db, b[i].level_db, 0.1) << where << ' ' << a[i].band.nominal_hz << ' ' << step;
        }
    }
}

TEST(JudgedCase, WarnsOfALineDistanceThatHidesAPeak) {
    const JudgedCase coarse = solve_judged(lightly_damped(5.0), kRunning_m_per_s);
    EXPECT_TRUE(warned(coarse, "lines 5 Hz apart do not resolve the peak"));
    EXPECT_EQ(coarse.solution.frequency_hz.size(), 21u);  // the table is as asked for
    EXPECT_FALSE(warned(solve_judged(lightly_damped(0.0), kRunning_m_per_s), "apart"));
    CaseParameters published = tests::paper_case(1);
    EXPECT_TRUE(
        warnings_beside_validity(published, solve_judged(published, kRunning_m_per_s).solution.warnings).empty());
}

TEST(JudgedCase, WithoutDampingSaysThatNothingConverges) {
    CaseParameters c = lightly_damped(0.5);
    c.vehicle.secondary.damping_n_s_per_m = c.vehicle.primary.damping_n_s_per_m = 0.0;
    c.track.rail.loss_factor = c.track.pads.loss_factor = c.track.pads.damping_n_s_per_m = 0.0;
    const JudgedCase judged = solve_judged(c, kRunning_m_per_s);
    EXPECT_FALSE(judged.judgement.converged);
    EXPECT_TRUE(warned(judged, "not converged"));
    EXPECT_TRUE(warned(judged, "has no damping"));
    for (const ResponseName& name : response_names()) EXPECT_TRUE(std::isfinite(rms(judged, name.where)));
}

/// A tooth between two lines, on a line, and half way: its power is that of its frequency, wherever the lines fall.
TEST(JudgedCase, TheToothOfAWheelHasItsPowerWhereverTheLinesFall) {
    std::vector<double> found;
    for (const double from : {1.0, 1.9, 3.3}) {
        CaseParameters c = tests::paper_case(1);
        c.wheel_out_of_roundness = {{.wheel = 1, .order = 4, .amplitude_m = 1e-3}};
        c.frequency = {.from_hz = from, .to_hz = 101.0, .step_hz = 4.0};
        found.push_back(rms(solve_judged(c, kRunning_m_per_s), "wheel_1"));
    }
    EXPECT_NEAR(found[1] / found[0], 1.0, 0.02);
    EXPECT_NEAR(found[2] / found[0], 1.0, 0.02);
}

}  // namespace
}  // namespace railpem::pem
