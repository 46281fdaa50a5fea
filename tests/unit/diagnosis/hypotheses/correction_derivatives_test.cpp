#include "diagnosis/hypotheses/correction_derivatives.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "diagnosis/hypotheses/locate.hpp"
#include "diagnosis/hypotheses/screen.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

// A correction acts at its own frequency, so that one derivative serves all nodes of a curve. What the window of 4 s
// brings over from neighbouring bins is seen most at the lowest, 2 Hz, where a bin is an eighth of the frequency.
TEST(CorrectionDerivatives, PromiseWhatThoseOfTheNodesPromise) {
    Synthesised made =
        synthesised(paper_believed({"vehicle.bogie_mass_kg", "vehicle.primary.stiffness_n_per_m"}), {15.0, 80.0 / 3.6},
                    60.0, nine_channels(), {.window_s = 4.0, .low_hz = 2.0, .high_hz = 100.0});
    number_at(made.truth.numbers, "vehicle.primary.damping_n_s_per_m") *= 1.2;
    made.draw(3);
    const std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    const Fit retuned =
        fit(believed_trial(made.believed, made.observations), unknowns, means(unknowns), made.context());
    const std::vector<CorrectionPlace> places = correction_places(made.believed, made.observations);
    std::vector<std::vector<Unknown>> freedoms;
    for (const CorrectionPlace& place : places) freedoms.push_back(correction_unknowns(place, made.observations));
    const auto exact = promises_of(retuned, freedoms, made.context());
    const auto shared = promises_of(retuned, freedoms, made.context(), [&](std::size_t i) {
        return correction_derivatives(retuned, places[i], made.context());
    });
    for (std::size_t i = 0; i < places.size(); ++i) {
        std::printf("%s %d%s: %.2f, shared %.2f\n", element_name(places[i].element).c_str(), places[i].which,
                    places[i].attached ? " attached" : "", exact[i].nats, shared[i].nats);
        EXPECT_NEAR(shared[i].nats, exact[i].nats, 0.01 * std::abs(exact[i].nats) + 2.5)
            << element_name(places[i].element);
    }
}

}  // namespace
}  // namespace railpem::diagnosis
