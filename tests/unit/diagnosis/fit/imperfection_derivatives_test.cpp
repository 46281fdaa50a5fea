// What wheels meet alone and calibrations: closed-form derivatives against differences of whole predictions.

#include "diagnosis/fit/imperfection_derivatives.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/fit/derivatives.hpp"
#include "diagnosis/fit/fit.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

constexpr double kImperfectionStep = 1e-3;

/// Largest difference between a derivative and a central difference, of the power of the channels.
double largest_difference(const Synthesised& made, const Trial& trial, const Unknown& unknown, double value,
                          const ExpectedSpectra& at, const PredictionDerivative& own) {
    Trial up = trial, down = trial;
    unknown.set(up, value + kImperfectionStep);
    unknown.set(down, value - kImperfectionStep);
    const auto o = static_cast<std::size_t>(own.observation);
    const ExpectedSpectra high = predict_one(up, made.context(), o), low = predict_one(down, made.context(), o);
    const std::size_t size = at.channels;
    double most = 0.0;
    for (std::size_t k = 0; k < at.values.size(); ++k) {
        const std::size_t first = k / (size * size) * size * size, i = k % size, j = k / size % size;
        const double power =
            std::sqrt(at.values[first + i * (size + 1)].real() * at.values[first + j * (size + 1)].real());
        most = std::max(most,
                        std::abs((high.values[k] - low.values[k]) / (2.0 * kImperfectionStep) - own.values[k]) / power);
    }
    return most;
}

// A central difference over ±h of e^x is off by h²/6: 1.7e-7 of what moves.
TEST(ImperfectionDerivatives, AreThoseOfWholePredictions) {
    Synthesised made = synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {20.0, 33.0}, 60.0,
                                   {"bogie_1", "wheel_1", "wheel_4"}, kSmall);
    made.draw(1);
    for (Observation& own : made.observations) own.calibration.assign(3, 0.01);
    std::vector<Unknown> unknowns = nuisance_unknowns(made.believed, made.observations);
    std::erase_if(unknowns, [](const Unknown& own) {
        return own.kind != UnknownKind::met_alone && own.kind != UnknownKind::calibration;
    });
    std::vector<double> values = means(unknowns);
    // a share that shows: 1 %
    for (std::size_t u = 0; u < values.size(); ++u)
        values[u] = (unknowns[u].kind == UnknownKind::met_alone ? std::log(0.01) : 0.0) +
                    0.1 * std::sin(static_cast<double>(u));
    Trial trial = believed_trial(made.believed, made.observations);
    set_values(trial, unknowns, values);
    const Predictions at = predict(trial, made.context());
    const std::vector<PredictionDerivative> derivatives = differentiate(trial, unknowns, values, at, made.context());
    std::size_t calibrations = 0;
    for (const PredictionDerivative& own : derivatives) {
        const auto u = static_cast<std::size_t>(own.unknown);
        calibrations += unknowns[u].kind == UnknownKind::calibration;
        EXPECT_LT(
            largest_difference(made, trial, unknowns[u], values[u], at[static_cast<std::size_t>(own.observation)], own),
            1e-6)
            << unknowns[u].name;
    }
    EXPECT_EQ(calibrations, 6u);  // each of its own recording
}

TEST(ImperfectionDerivatives, NothingIsMetAloneWithoutAShare) {
    Synthesised made =
        synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {20.0}, 60.0, {"wheel_1", "wheel_4"}, kSmall);
    made.draw(1);
    const Trial trial = believed_trial(made.believed, made.observations);
    const Predictions at = predict(trial, made.context());
    for (const std::complex<double> value : met_alone_spectra(trial, made.context(), 0, at)) EXPECT_EQ(value, 0.0);
}

}  // namespace
}  // namespace railpem::diagnosis
