// Slips of units, signs and quantities in recordings without time series, made on purpose.

#include "diagnosis/judge/spoiled_values.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "diagnosis/judge/scalar_levels.hpp"
#include "diagnosis/likelihood/likelihood.hpp"
#include "tests/unit/diagnosis/scalar_recordings.hpp"

namespace railpem::diagnosis {
namespace {

using Complex = std::complex<double>;
constexpr const char* kHammerTrack = "cases/ballasted/uic60.toml";
constexpr double kError = 0.02;

/// A track that is 20 % softer than believed: a difference that physics makes.
pem::CaseParameters truth_of(const BelievedCase& believed) {
    pem::CaseParameters truth = believed.numbers;
    truth.track.pads.static_stiffness_n_per_m *= 0.8;
    return truth;
}

std::vector<Observation> seen(const recordings::Recording& recording, const BelievedCase& believed) {
    return {observe_scalars(recording, "hammer", believed.numbers, {})};
}

/// Slips found in a receptance whose every value was changed.
std::vector<SpoiledChannel> of_receptance(Complex (*change)(Complex value, double omega)) {
    const BelievedCase believed = believed_file(kHammerTrack);
    recordings::Recording recording = receptance_recording(truth_of(believed), kError, 1);
    for (std::size_t i = 0; i < recording.receptance.value_m_per_n.size(); ++i)
        recording.receptance.value_m_per_n[i] = change(recording.receptance.value_m_per_n[i],
                                                       2.0 * std::numbers::pi * recording.receptance.frequency_hz[i]);
    std::vector<Observation> observations = seen(recording, believed);
    return undo_spoiling(believed, observations);
}

TEST(SpoiledValues, SoundOnesHaveNoSlip) {
    EXPECT_TRUE(of_receptance([](Complex value, double) { return value; }).empty());
}

TEST(SpoiledValues, FactorsOfUnitsAreFound) {
    const auto micro = of_receptance([](Complex value, double) { return 1e6 * value; });
    ASSERT_EQ(micro.size(), 1u);
    EXPECT_EQ(micro[0].factor, 1e6);
    const auto gravity = of_receptance([](Complex value, double) { return value / 9.81; });
    ASSERT_EQ(gravity.size(), 1u);
    EXPECT_NEAR(gravity[0].factor, 1.0 / 9.81, 1e-3);
}

TEST(SpoiledValues, SignsAndConjugatesAreFound) {
    const auto inverted = of_receptance([](Complex value, double) { return -value; });
    ASSERT_EQ(inverted.size(), 1u);
    EXPECT_EQ(inverted[0].factor, -1.0);
    EXPECT_FALSE(inverted[0].conjugated);
    const auto turned = of_receptance([](Complex value, double) { return std::conj(value); });
    ASSERT_EQ(turned.size(), 1u);
    EXPECT_TRUE(turned[0].conjugated);
    EXPECT_EQ(turned[0].factor, 1.0);
}

TEST(SpoiledValues, OtherQuantitiesAreFound) {
    const auto mobility = of_receptance([](Complex value, double omega) { return Complex(0.0, omega) * value; });
    ASSERT_EQ(mobility.size(), 1u);
    EXPECT_EQ(mobility[0].derivatives, 1);
    const auto accelerance = of_receptance([](Complex value, double omega) { return -omega * omega * value; });
    ASSERT_EQ(accelerance.size(), 1u);
    EXPECT_EQ(accelerance[0].derivatives, 2);
    EXPECT_EQ(accelerance[0].factor, 1.0);
}

// Undone, the values are those of the sound recording.
TEST(SpoiledValues, UndoesWhatItFinds) {
    const BelievedCase believed = believed_file(kHammerTrack);
    const recordings::Recording sound = receptance_recording(truth_of(believed), kError, 1);
    recordings::Recording spoiled = sound;
    for (Complex& value : spoiled.receptance.value_m_per_n) value = 1e3 * std::conj(value);
    const std::vector<Observation> right = seen(sound, believed);
    std::vector<Observation> undone = seen(spoiled, believed);
    ASSERT_EQ(undo_spoiling(believed, undone).size(), 1u);
    for (std::size_t i = 0; i < right[0].scalar->values.size(); ++i)
        EXPECT_NEAR(std::abs(right[0].scalar->values[i].log_value - undone[0].scalar->values[i].log_value), 0.0, 1e-9);
}

TEST(SpoiledValues, DecayRatesPerKilometreAreARecordingFault) {
    const BelievedCase believed = believed_file(kHammerTrack);
    recordings::Recording recording = decay_recording(believed.numbers, 0.05, 2);
    for (double& value : recording.decay_rate.decay_rate_db_per_m) value *= 1e3;
    for (double& value : recording.decay_rate.standard_error_db_per_m) value *= 1e3;
    const Diagnosis found = diagnosed(believed, {recording});
    EXPECT_EQ(found.verdict, Verdict::recording_fault);
    ASSERT_EQ(found.omitted.size(), 1u);
    EXPECT_EQ(found.omitted[0].instance.values.at("gain"), 1e3);
    EXPECT_NE(found.statement.find("1e+03 times too large"), std::string::npos) << found.statement;
}

// Spectra 60 dB off were 13 dB off once: the pedestal of what was recorded hid the model.
TEST(SpoiledValues, SpectraInMillimetresAreFoundWhateverTheirPedestal) {
    const BelievedCase believed = believed_file("cases/wei2016/case1.toml");
    for (const double factor : {1e3, 1e-3}) {
        recordings::Recording recording = psd_recording(believed.numbers, 100, 3);
        for (recordings::ChannelSpectrum& spectrum : recording.spectra)
            for (std::size_t i = 0; i < spectrum.psd.size(); ++i)
                spectrum.psd[i] *= factor * factor, spectrum.standard_error[i] *= factor * factor;
        std::vector<Observation> observations = {observe_scalars(recording, "spectra", believed.numbers, {})};
        const std::vector<SpoiledChannel> found = undo_spoiling(believed, observations);
        ASSERT_EQ(found.size(), 3u);
        for (const SpoiledChannel& own : found) EXPECT_NEAR(own.factor / factor, 1.0, 1e-9) << own.channel;
    }
}

/// By how many dB levels are said to be off when decay rates are a factor too high.
double level_error(double factor) {
    const BelievedCase believed = believed_file(kHammerTrack);
    recordings::Recording recording = decay_recording(believed.numbers, 0.05, 4);
    for (double& value : recording.decay_rate.decay_rate_db_per_m) value *= factor;
    const std::vector<Observation> observations = seen(recording, believed);
    const LikelihoodContext context{.believed = &believed, .observations = &observations, .part = Part::all};
    const Trial trial = believed_trial(believed, observations);
    const Fit fit{.trial = trial, .predictions = predict(trial, context)};
    return scalar_level_db(fit, context);
}

// A factor of 1.5 is 1.76 dB; the errors, 5 % of the value and as much of the model, are 0.3 dB and leave nothing.
TEST(ScalarLevels, AreWhatIsLeftBeyondTheStatedErrors) {
    EXPECT_LT(level_error(1.0), 0.3);
    EXPECT_NEAR(level_error(1.5), 1.76, 0.15);
}

}  // namespace
}  // namespace railpem::diagnosis
