// A later state of a track against the case that was fitted to an earlier one: several recordings, whole ones held out,
// and what the case could not say then is not taken for news. The levels come from the solver on another grid than the
// prediction uses.

#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/findings/decay_rate_reference.hpp"
#include "diagnosis/likelihood/hold_out_recordings.hpp"
#include "diagnosis/model/predict_scalars.hpp"
#include "tests/unit/diagnosis/scalar_recordings.hpp"

namespace railpem::diagnosis {
namespace {

constexpr const char* kSection = "cases/ballasted/uic60.toml";
constexpr double kDayError = 0.1;

/// What no beam on springs says of this track: up to a third more and less, from one third-octave to the next but one.
double unsaid(double frequency_hz) {
    return std::exp(0.3 * std::sin(7.0 * std::log(frequency_hz)));
}

recordings::Recording day(const pem::CaseParameters& truth, unsigned seed) {
    recordings::Recording recording = decay_recording(truth, kDayError, seed);
    for (std::size_t i = 0; i < recording.decay_rate.centre_hz.size(); ++i) {
        recording.decay_rate.decay_rate_db_per_m[i] *= unsaid(recording.decay_rate.centre_hz[i]);
        recording.decay_rate.standard_error_db_per_m[i] *= unsaid(recording.decay_rate.centre_hz[i]);
    }
    return recording;
}

std::vector<Observation> days(const pem::CaseParameters& truth, const BelievedCase& believed, unsigned seed,
                              int count) {
    std::vector<Observation> observations;
    for (int i = 0; i < count; ++i)
        observations.push_back(observe_scalars(day(truth, seed + static_cast<unsigned>(i)),
                                               "day " + std::to_string(i + 1), believed.numbers, {}));
    hold_out_recordings(observations);
    return observations;
}

/// The case fitted to two days of the earlier state.
BelievedCase fitted(const BelievedCase& track) {
    BelievedCase later = track;
    later.numbers = diagnose(track, days(track.numbers, track, 1, 2), {.threads = 2}).diagnosed_numbers;
    return later;
}

TEST(HoldOutRecordings, WholeOnesAndOneDiscrepancy) {
    const BelievedCase track = believed_file(kSection);
    const std::vector<Observation> observations = days(track.numbers, track, 1, 4);
    for (std::size_t o = 0; o < 4; ++o)
        for (const ScalarValue& value : observations[o].scalar->values) {
            EXPECT_EQ(value.held_out, o == 3);
            EXPECT_EQ(value.sharing, o == 3 ? 1.0 : 3.0);
        }
    const std::vector<Unknown> unknowns = nuisance_unknowns(track, observations);
    EXPECT_EQ(std::count_if(unknowns.begin(), unknowns.end(),
                            [](const Unknown& own) { return own.kind == UnknownKind::discrepancy; }),
              1);
}

TEST(HoldOutRecordings, OneAloneKeepsItsBands) {
    const BelievedCase track = believed_file(kSection);
    const std::vector<Observation> observations = days(track.numbers, track, 1, 1);
    const auto& values = observations[0].scalar->values;
    const auto held = std::count_if(values.begin(), values.end(), [](const ScalarValue& own) { return own.held_out; });
    EXPECT_GT(held, 0);
    EXPECT_LT(held, static_cast<long>(values.size()) / 2);
}

TEST(DecayRateReference, IsWhatTheFittedCaseLeaves) {
    const BelievedCase track = believed_file(kSection);
    const BelievedCase later = fitted(track);
    const std::vector<Observation> observations = days(track.numbers, later, 11, 1);
    // Predictions are logarithms of predicted by recorded: with the reference only the errors of three days are left,
    // kDayError·√(1 + 1/2), and four of those are rare among seventeen.
    for (const std::complex<double> left :
         predict_scalars(later.numbers, 0.0, observations[0], nullptr, Reuse::nothing, nullptr))
        EXPECT_LT(std::abs(left.real()), 4.0 * 1.23 * kDayError);
    EXPECT_NEAR(observations[0].scalar->values[0].shared_deviation, kDayError / std::sqrt(2.0), 0.2 * kDayError);
}

TEST(TrackStates, AnUnchangedTrackIsConsistent) {
    const BelievedCase track = believed_file(kSection);
    const BelievedCase later = fitted(track);
    const Diagnosis diagnosis = diagnose(later, days(track.numbers, later, 21, 4), {.threads = 2});
    EXPECT_EQ(diagnosis.verdict, Verdict::consistent) << diagnosis.statement;
}

TEST(TrackStates, DampersOfTwoMassesAreNamed) {
    const BelievedCase track = believed_file(kSection);
    const BelievedCase later = fitted(track);
    pem::CaseParameters truth = track.numbers;
    truth.track.rail_dampers.push_back({.mass_kg_per_m = 12.0, .frequency_hz = 630.0, .loss_factor = 0.3});
    truth.track.rail_dampers.push_back({.mass_kg_per_m = 6.0, .frequency_hz = 2500.0, .loss_factor = 0.3});
    const Diagnosis diagnosis = diagnose(later, days(truth, later, 31, 4), {.threads = 2});
    EXPECT_EQ(diagnosis.verdict, Verdict::explained) << diagnosis.statement;
    std::vector<double> frequencies;
    for (const NamedEffect& own : diagnosis.omitted)
        for (const FittedParameter& parameter : own.parameters)
            if (own.instance.effect == "rail-damper" && parameter.name == "frequency_hz")
                frequencies.push_back(parameter.value);
    std::sort(frequencies.begin(), frequencies.end());
    ASSERT_EQ(frequencies.size(), 2u) << diagnosis.statement;
    EXPECT_NEAR(frequencies[0], 630.0, 0.15 * 630.0);  // a third-octave is ±12 %
    EXPECT_NEAR(frequencies[1], 2500.0, 0.15 * 2500.0);
}

}  // namespace
}  // namespace railpem::diagnosis
