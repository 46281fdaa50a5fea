// The dynamic stiffness of the pads as three runs infer it, when the pads stiffen with frequency and the believed ones
// do not.

#include "diagnosis/findings/inferred_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/hypotheses/fitted_set.hpp"
#include "diagnosis/hypotheses/locate.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

TEST(InferredCurve, HoldsTheTrueLawInItsBandAndNoConstant) {
    Synthesised made = synthesised(
        paper_believed({"vehicle.wheelset_mass_kg", "vehicle.primary.stiffness_n_per_m",
                        "track.pads.static_stiffness_n_per_m", "track.pads.damping_n_s_per_m"}),
        {15.0, 80.0 / 3.6, 33.0}, 60.0, nine_channels(), {.window_s = 2.0, .low_hz = 4.0, .high_hz = 175.0});
    made.truth.effects.push_back({.effect = "pad-frequency-stiffening", .values = {{"exponent", 0.15}}, .choices = {}});
    made.draw(5);
    std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    const Fit retuned =
        fit(believed_trial(made.believed, made.observations), unknowns, means(unknowns), made.context(Part::fitted, 2));
    const std::vector<LocatedEvidence> places = locate(retuned, made.context(Part::fitted, 2));
    const auto pad = std::find_if(places.begin(), places.end(),
                                  [](const LocatedEvidence& own) { return own.place.element == Element::pad; });
    ASSERT_NE(pad, places.end());
    const FittedSet free = fit_correction(made.believed, {.fit = retuned}, *pad, made.context(Part::fitted, 2),
                                          {.iterations = 20, .from_far = false});
    const InferredCurve curve = inferred_curve(free.fit, pad->place, made.believed, made.observations);

    const pem::CaseParameters truth = case_of(made.truth, made.believed, made.observations[0]);
    std::size_t real = 0, imaginary = 0;
    double highest_low = 0.0, lowest_high = 1e300;
    for (std::size_t i = 0; i < curve.frequency_hz.size(); ++i) {
        const std::complex<double> law = *place_law(truth, Element::pad, curve.frequency_hz[i]);
        real += curve.real_low[i] <= law.real() && law.real() <= curve.real_high[i];
        imaginary += curve.imaginary_low[i] <= law.imag() && law.imag() <= curve.imaginary_high[i];
        highest_low = std::max(highest_low, curve.real_low[i]);
        lowest_high = std::min(lowest_high, curve.real_high[i]);
    }
    // A band of 90 % at seven nodes: all of them inside in half of the draws, five or more in 97 % (binomial).
    const double count = static_cast<double>(curve.frequency_hz.size());
    EXPECT_GE(static_cast<double>(real) / count, 5.0 / 7.0);
    EXPECT_GE(static_cast<double>(imaginary) / count, 5.0 / 7.0);
    EXPECT_GT(highest_low, lowest_high) << "a constant stiffness would lie in the band";
}

}  // namespace
}  // namespace railpem::diagnosis
