#include "diagnosis/fit/irregularity_derivatives.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/fit/derivatives.hpp"
#include "diagnosis/fit/fit.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

constexpr double kStep = 1e-3;

/// Largest difference between a derivative and a central difference of whole predictions, in units of the power of the
/// channels.
double largest_difference(const Synthesised& made, const Trial& trial, const Unknown& unknown, double value,
                          const ExpectedSpectra& at, const PredictionDerivative& own) {
    Trial up = trial, down = trial;
    unknown.set(up, value + kStep);
    unknown.set(down, value - kStep);
    const auto o = static_cast<std::size_t>(own.observation);
    const ExpectedSpectra high = predict_one(up, made.context(), o), low = predict_one(down, made.context(), o);
    const std::size_t size = at.channels;
    double most = 0.0;
    for (std::size_t b = 0; b < at.bins(); ++b)
        for (std::size_t j = 0; j < size; ++j)
            for (std::size_t i = 0; i < size; ++i) {
                const std::size_t k = (b * size + j) * size + i;
                const double power = std::sqrt(at.values[b * size * size + i * (size + 1)].real() *
                                               at.values[b * size * size + j * (size + 1)].real());
                most =
                    std::max(most, std::abs((high.values[k] - low.values[k]) / (2.0 * kStep) - own.values[k]) / power);
            }
    return most;
}

// A central difference over ±h of e^x is off by h²/6: 1.7e-7. The paper's spectrum has an edge at 1 m, within a fine
// line's cell; with the weight at the middle of the cell the bin there was off by half a per cent.
TEST(IrregularityDerivatives, AreThoseOfWholePredictions) {
    Synthesised made = synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {20.0, 33.0}, 60.0,
                                   {"bogie_1", "wheel_1", "wheel_4"}, kSmall);
    made.draw(1);
    std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    std::erase_if(unknowns, [](const Unknown& own) { return own.kind != UnknownKind::irregularity; });
    std::vector<double> values = means(unknowns);
    for (std::size_t u = 0; u < values.size(); ++u) values[u] += 0.3 * std::sin(static_cast<double>(u));
    Trial trial = believed_trial(made.believed, made.observations);
    set_values(trial, unknowns, values);
    const Predictions at = predict(trial, made.context());
    ASSERT_TRUE(has_irregularity_derivatives(trial, made.context(), 0, at));
    const std::vector<PredictionDerivative> derivatives = differentiate(trial, unknowns, values, at, made.context());
    ASSERT_EQ(derivatives.size(), unknowns.size() * 2);
    for (const PredictionDerivative& own : derivatives) {
        const auto u = static_cast<std::size_t>(own.unknown);
        EXPECT_LT(
            largest_difference(made, trial, unknowns[u], values[u], at[static_cast<std::size_t>(own.observation)], own),
            1e-6)
            << unknowns[u].name;
    }
}

}  // namespace
}  // namespace railpem::diagnosis
