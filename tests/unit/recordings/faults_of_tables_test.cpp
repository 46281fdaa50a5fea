// Receptances, decay rates and spectra whose numbers make no sense.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "recordings/checks/check_tables.hpp"

namespace railpem::recordings::testing {
namespace {

using Complex = std::complex<double>;

/// A beam-like point on a spring: level below 250 Hz, then falling, and it takes energy.
Complex track(double f) {
    const double r = f / 250.0;
    return 1.3e-8 / std::sqrt(Complex(1.0 - r * r, 0.3 * r));
}

Recording receptance(const std::function<Complex(double)>& value, bool has_phase = true) {
    Recording recording;
    recording.description.kind = RecordingKind::receptance;
    recording.receptance.has_phase = has_phase;
    for (double f = 50.0; f < 1500.0; f *= 1.12) {
        recording.receptance.frequency_hz.push_back(f);
        recording.receptance.value_m_per_n.push_back(has_phase ? value(f) : Complex(std::abs(value(f))));
    }
    return recording;
}

std::vector<Fault> faults_of(const std::function<Complex(double)>& value, bool has_phase = true) {
    return checks::check_tables(receptance(value, has_phase), {});
}

TEST(Tables, ATrackThatTakesEnergyIsSound) {
    EXPECT_TRUE(faults_of(track).empty());
    EXPECT_TRUE(faults_of(track, false).empty());
    // Twenty times as stiff, and twenty times as soft.
    EXPECT_TRUE(faults_of([](double f) { return 0.05 * track(f); }).empty());
    EXPECT_TRUE(faults_of([](double f) { return 20.0 * track(f); }).empty());
}

TEST(Tables, AConjugatedAndAnInvertedReceptanceAreToldApart) {
    const auto conjugated = faults_of([](double f) { return std::conj(track(f)); });
    ASSERT_EQ(conjugated.size(), 1U);
    EXPECT_EQ(conjugated[0].kind, FaultKind::not_causal);
    EXPECT_NE(conjugated[0].says.find("conjugated"), std::string::npos);
    const auto inverted = faults_of([](double f) { return -track(f); });
    ASSERT_EQ(inverted.size(), 1U);
    EXPECT_EQ(inverted[0].kind, FaultKind::inverted);
    const auto both = faults_of([](double f) { return -std::conj(track(f)); });
    ASSERT_EQ(both.size(), 1U);
    EXPECT_EQ(both[0].severity, Severity::error);
}

TEST(Tables, MobilityAcceleranceAndUnitsAreNamedBySizeAndSlope) {
    const auto derivative = [](double f, int n) { return std::pow(Complex(0.0, 2.0 * std::numbers::pi * f), n); };
    struct Mistake {
        std::function<Complex(double)> value;
        std::string says;
    };
    const std::vector<Mistake> mistakes = {
        {[&](double f) { return track(f) * derivative(f, 1); }, "mobility in (m/s)/N"},
        {[&](double f) { return track(f) * derivative(f, 2); }, "accelerance in (m/s^2)/N"},
        {[&](double f) { return 1e9 * track(f); }, "receptance in nm/N"},
        {[&](double f) { return 1e6 * track(f); }, "receptance in um/N"},
    };
    for (const Mistake& mistake : mistakes)
        for (const bool has_phase : {true, false}) {
            const auto faults = faults_of(mistake.value, has_phase);
            ASSERT_EQ(faults.size(), 1U) << mistake.says;
            EXPECT_EQ(faults[0].kind, FaultKind::wrong_unit);
            EXPECT_NE(faults[0].says.find(mistake.says), std::string::npos) << faults[0].says;
        }
}

TEST(Tables, ACaseNarrowsWhatSizeIsRight) {
    InspectionContext context;
    for (double f = 20.0; f < 2000.0; f *= 1.1) {
        context.track.frequency_hz.push_back(f);
        context.track.receptance_m_per_n.push_back(std::abs(track(f)));
    }
    EXPECT_TRUE(checks::check_tables(receptance(track), context).empty());
    const auto faults = checks::check_tables(receptance([](double f) { return 20.0 * track(f); }), context);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].severity, Severity::warning);
}

Recording decay_rates(const std::vector<double>& centres, double rate) {
    Recording recording;
    recording.description.kind = RecordingKind::decay_rate;
    recording.decay_rate.centre_hz = centres;
    recording.decay_rate.decay_rate_db_per_m.assign(centres.size(), rate);
    return recording;
}

TEST(Tables, CentresOfDecayRatesAreThoseOfThirdOctaves) {
    const std::vector<double> nominal = {100, 125, 160, 200, 250, 315, 400, 500, 630, 800, 1000, 1250, 1600, 5000},
                              exact = {100.0, 125.89, 158.49, 199.53, 251.19, 316.23, 398.11, 501.19},
                              base_two = {99.21, 125.0, 157.49, 198.43, 250.0, 314.98, 396.85, 500.0};
    for (const auto& centres : {nominal, exact, base_two})
        EXPECT_TRUE(checks::check_tables(decay_rates(centres, 5.0), {}).empty());
    std::vector<double> off = nominal;
    for (double& centre : off) centre *= 1.03;
    const auto faults = checks::check_tables(decay_rates(off, 5.0), {});
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].kind, FaultKind::band_centres);
}

TEST(Tables, DecayRatesPerKilometreAreNoticed) {
    const auto faults = checks::check_tables(decay_rates({100, 200, 400}, 3000.0), {});
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_NE(faults[0].says.find("dB/km"), std::string::npos) << faults[0].says;
}

}  // namespace
}  // namespace railpem::recordings::testing
