#include "diagnosis/fit/derivatives.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/fit/fit.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

/// Largest difference of two derivatives of one observation, relative to the largest value of the first.
double largest_difference(const PredictionDerivative& first, const PredictionDerivative& second) {
    double most = 0.0, off = 0.0;
    for (std::size_t i = 0; i < first.values.size(); ++i) {
        most = std::max(most, std::abs(first.values[i]));
        off = std::max(off, std::abs(first.values[i] - second.values[i]));
    }
    return most > 0.0 ? off / most : 0.0;  // without lines their width moves nothing
}

// Twice the irregularity is twice every derivative. Differences over 1e-5 and 1e-7 of doubles are good to 1e-8.
TEST(Derivatives, CarriedAlongWithTheLevelOfTheIrregularityAreExact) {
    BelievedCase believed = paper_believed({"vehicle.bogie_mass_kg", "track.pads.static_stiffness_n_per_m"});
    believed.numbers.sleeper_passing.amplitude_factor = 0.0;  // its lines stay
    Synthesised made = synthesised(believed, {20.0}, 60.0, {"bogie_1", "wheel_1"}, kSmall);
    made.draw(1);
    const std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    std::vector<double> values = means(unknowns);
    Trial trial = believed_trial(made.believed, made.observations);
    set_values(trial, unknowns, values);
    const Predictions before = predict(trial, made.context());
    Derivatives known{.values = differentiate(trial, unknowns, values, before, made.context()), .at = before.spectra};
    for (const Unknown& unknown : unknowns) known.names.push_back(unknown.name);
    for (std::size_t u = 0; u < unknowns.size(); ++u)
        if (unknowns[u].name == "irregularity level") values[u] += std::log(2.0);
    set_values(trial, unknowns, values);
    const Predictions after = predict(trial, made.context());
    const auto carried = derivatives_near(known, trial, unknowns, values, after, made.context()),
               anew = differentiate(trial, unknowns, values, after, made.context());
    ASSERT_EQ(carried.size(), anew.size());
    for (std::size_t d = 0; d < anew.size(); ++d) {
        ASSERT_EQ(carried[d].unknown, anew[d].unknown);
        EXPECT_LT(largest_difference(anew[d], carried[d]), 1e-6)
            << unknowns[static_cast<std::size_t>(anew[d].unknown)].name;
    }
}

}  // namespace
}  // namespace railpem::diagnosis
