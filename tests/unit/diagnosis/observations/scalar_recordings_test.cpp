// Recordings without time series: what each kind can name, and that it names nothing when nothing is missing. The
// levels come from the solver on another grid than the prediction uses, with random errors of the size that the
// recording states.

#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/fit/derivatives.hpp"
#include "diagnosis/fit/fit.hpp"
#include "diagnosis/likelihood/likelihood.hpp"
#include "diagnosis/likelihood/scalar_likelihood.hpp"
#include "parameters/parameter_error.hpp"
#include "tests/unit/diagnosis/scalar_recordings.hpp"

namespace railpem::diagnosis {
namespace {

constexpr const char* kTrack = "cases/ballasted/uic60.toml";
constexpr const char* kVehicle = "cases/wei2016/case1.toml";

bool mentions(const std::vector<std::string>& texts, const std::string& what) {
    return std::any_of(texts.begin(), texts.end(),
                       [&](const std::string& text) { return text.find(what) != std::string::npos; });
}

bool names(const Diagnosis& diagnosis, const std::string& effect) {
    return std::any_of(diagnosis.omitted.begin(), diagnosis.omitted.end(),
                       [&](const NamedEffect& own) { return own.instance.effect == effect; });
}

TEST(ScalarRecordings, NullsAreConsistent) {
    const BelievedCase track = believed_file(kTrack), vehicle = believed_file(kVehicle);
    EXPECT_EQ(diagnosed(track, {decay_recording(track.numbers, 0.10, 1)}).verdict, Verdict::consistent);
    EXPECT_EQ(diagnosed(track, {receptance_recording(track.numbers, 0.05, 2)}).verdict, Verdict::consistent);
    EXPECT_EQ(diagnosed(vehicle, {psd_recording(vehicle.numbers, 60, 3)}).verdict, Verdict::consistent);
}

TEST(ScalarRecordings, RailDamperInDecayRates) {
    const BelievedCase track = believed_file(kTrack);
    pem::CaseParameters truth = track.numbers;
    truth.track.rail_dampers.push_back({.mass_kg_per_m = 15.0, .frequency_hz = 900.0, .loss_factor = 0.35});
    const Diagnosis diagnosis = diagnosed(track, {decay_recording(truth, 0.05, 4)});
    EXPECT_EQ(diagnosis.verdict, Verdict::explained) << diagnosis.statement;
    ASSERT_TRUE(names(diagnosis, "rail-damper")) << diagnosis.statement;
    for (const FittedParameter& parameter : diagnosis.omitted.front().parameters) {
        // a third-octave is ±12 %
        if (parameter.name == "frequency_hz") {
            EXPECT_NEAR(parameter.value, 900.0, 180.0);
        }
    }
    EXPECT_TRUE(mentions(diagnosis.not_tested, "sensor-gain"));
    EXPECT_TRUE(mentions(diagnosis.not_tested, "body-bending"));
    EXPECT_TRUE(mentions(diagnosis.rests_on, "nothing is known of the vehicle") ||
                mentions(diagnosis.rests_on, "without a vehicle"));
}

TEST(ScalarRecordings, WhatIsLeftOutOfTheCatalogueIsNotNamed) {
    const BelievedCase track = believed_file(kTrack);
    pem::CaseParameters truth = track.numbers;
    truth.track.rail_dampers.push_back({.mass_kg_per_m = 15.0, .frequency_hz = 900.0, .loss_factor = 0.35});
    const std::vector<Observation> observations{
        observe_scalars(decay_recording(truth, 0.05, 4), "decay", track.numbers, {})};
    DiagnoseOptions options{.threads = 2};
    options.naming.without = {"rail-damper"};
    const Diagnosis diagnosis = diagnose(track, observations, options);
    EXPECT_FALSE(names(diagnosis, "rail-damper")) << diagnosis.statement;  // with it: RailDamperInDecayRates
    EXPECT_TRUE(mentions(diagnosis.not_tested, "rail-damper: it was to be left out"));
}

TEST(ScalarRecordings, TwoLayerSupportInReceptance) {
    const BelievedCase believed = believed_file(kVehicle);  // pads on rigid ground
    pem::CaseParameters truth = believed.numbers;
    truth.track.support = {
        .model = track::SupportModel::two_layer, .mass_kg = 150.0, .stiffness_n_per_m = 80e6, .damping_n_s_per_m = 5e4};
    const Diagnosis diagnosis = diagnosed(believed, {receptance_recording(truth, 0.05, 5)});
    EXPECT_TRUE(names(diagnosis, "support-compliance")) << diagnosis.statement;
}

TEST(ScalarRecordings, PrimaryStiffnessInSpectra) {
    const BelievedCase believed = believed_file(kVehicle);
    pem::CaseParameters truth = believed.numbers;
    // tolerance 10 %; without cross-spectra a factor of two hides behind the other numbers
    truth.vehicle.primary.stiffness_n_per_m *= 4.0;
    const Diagnosis diagnosis = diagnosed(believed, {psd_recording(truth, 200, 6)});
    // Levels alone tell that something is wrong and where; that it is a number and which is asked too much of them.
    EXPECT_NE(diagnosis.verdict, Verdict::consistent) << diagnosis.statement;
    ASSERT_FALSE(diagnosis.places.empty());
    EXPECT_EQ(diagnosis.places.front().element, Element::primary) << diagnosis.statement;
    EXPECT_TRUE(mentions(diagnosis.not_tested, "timing-skew"));
}

TEST(ScalarRecordings, SlopeIsThatOfTheLikelihood) {
    const BelievedCase believed = believed_file(kTrack);
    const std::vector<Observation> observations{
        observe_scalars(receptance_recording(believed.numbers, 0.05, 7), "hammer", believed.numbers, {})};
    const LikelihoodContext context{.believed = &believed, .observations = &observations, .threads = 1};
    Trial trial = believed_trial(believed, observations);
    const std::vector<Unknown> unknowns = nuisance_unknowns(believed, observations);
    std::vector<double> values = means(unknowns);
    set_values(trial, unknowns, values);
    const Predictions predictions = predict(trial, context);
    const LikelihoodSlope slope = likelihood_slope(
        trial, unknowns, predictions, differentiate(trial, unknowns, values, predictions, context), context);
    for (std::size_t u = 0; u < unknowns.size(); ++u) {
        const auto at = [&](double step) {
            Trial moved = trial;
            unknowns[u].set(moved, values[u] + step);
            return log_likelihood(moved, predict(moved, context), context);
        };
        const double expected = (at(1e-4) - at(-1e-4)) / 2e-4;
        EXPECT_NEAR(slope.gradient(static_cast<long>(u)), expected, 1e-3 * (1.0 + std::abs(expected)))
            << unknowns[u].name;
    }
}

TEST(ScalarRecordings, DiscrepancyIsSharedWithinATwelfthOctave) {
    // Ten times the lines in a band bring ten times the information without a discrepancy, and hardly any more with
    // one.
    const ScalarValue alone{.deviation = 0.05, .sharing = 1.0}, crowded{.deviation = 0.05, .sharing = 10.0};
    EXPECT_DOUBLE_EQ(scalar_variance(alone, 0.0), scalar_variance(crowded, 0.0));
    EXPECT_NEAR(10.0 / scalar_variance(crowded, 0.5), 1.0 / scalar_variance(alone, 0.5), 0.04 * 4.0);
}

TEST(ScalarRecordings, OneThirdOctaveInFourIsHeldOut) {
    const BelievedCase track = believed_file(kTrack);
    const Observation observation = observe_scalars(decay_recording(track.numbers, 0.1, 1), "decay", track.numbers, {});
    ASSERT_EQ(observation.scalar->values.size(), 17u);  // 100 Hz to 4 kHz
    for (std::size_t i = 0; i < 17; ++i) EXPECT_EQ(observation.scalar->values[i].held_out, i % 4 == 2) << i;
}

TEST(ScalarRecordings, SpectraNeedASpeedAndABand) {
    const BelievedCase vehicle = believed_file(kVehicle);
    recordings::Recording recording = psd_recording(vehicle.numbers, 60, 3);
    recording.description.speed_m_per_s = 0.0;
    EXPECT_THROW(observe_scalars(recording, "psd", vehicle.numbers, {}), parameters::ParameterError);
    recording.description.speed_m_per_s = 0.05;  // the shortest wave excites 0.5 Hz
    EXPECT_THROW(observe_scalars(recording, "psd", vehicle.numbers, {}), parameters::ParameterError);
}

TEST(ScalarRecordings, UnknownScaleSaysNothingOfLevels) {
    const BelievedCase vehicle = believed_file(kVehicle);
    recordings::Recording recording = psd_recording(vehicle.numbers, 60, 3);
    for (recordings::ChannelSpectrum& spectrum : recording.spectra) {
        spectrum.description.scale = recordings::Scale::unknown;
        for (double& value : spectrum.psd) value *= 1e4;
        for (double& value : spectrum.standard_error) value *= 1e4;
    }
    EXPECT_EQ(diagnosed(vehicle, {recording}).verdict, Verdict::consistent);
}

}  // namespace
}  // namespace railpem::diagnosis
