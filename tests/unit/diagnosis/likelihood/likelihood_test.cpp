// The Wishart log-likelihood against closed forms, its slope against differences and against draws.

#include "diagnosis/fit/derivatives.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>

#include "diagnosis/fit/fit.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

/// Power with a floor of 3 % and what every sensor errs by itself.
const double kFloored = 1.0 + 0.03 * 0.03 + std::pow(kObservationSettings.sensor_error, 2);

Synthesised small(const std::vector<std::string>& responses) {
    return synthesised(paper_believed({"vehicle.bogie_mass_kg", "vehicle.primary.stiffness_n_per_m",
                                       "vehicle.primary.damping_n_s_per_m", "track.pads.static_stiffness_n_per_m"}),
                       {tests::kPaperSpeed}, 60.0, responses, kSmall);
}

/// Something that is not the truth, with floor.
Trial another(const Synthesised& made) {
    Trial trial = believed_trial(made.believed, made.observations);
    number_at(trial.numbers, "vehicle.primary.stiffness_n_per_m") *= 1.05;
    trial.floor.assign(trial.floor.size(), 0.03);
    return trial;
}

// One channel: n[ln Ŝ/S + 1 − Ŝ/S] summed, the gamma distribution's.
TEST(LogLikelihood, OneChannelIsGamma) {
    Synthesised made = small({"bogie_1"});
    made.draw(1);
    const Trial trial = another(made);
    const Predictions predictions = predict(trial, made.context());
    double sum = 0.0;
    const Observation& observation = made.observations[0];
    for (std::size_t bin = 0; bin < observation.bins(); ++bin) {
        const double model = predictions[0].values[bin].real() * kFloored + trial.noise_psd[0][0];
        const double ratio = observation.fitted.values[bin].real() / model;
        sum += observation.fitted.averages * (std::log(ratio) + 1.0 - ratio);
    }
    EXPECT_LT(sum, -10.0);
    EXPECT_NEAR(log_likelihood(trial, predictions, made.context()), sum, 1e-9 * std::abs(sum));
}

// Two channels: determinant and trace written out.
TEST(LogLikelihood, TwoChannelsWrittenOut) {
    Synthesised made = small({"bogie_1", "wheel_2"});
    made.draw(2);
    const Trial trial = another(made);
    const Predictions predictions = predict(trial, made.context());
    const Observation& observation = made.observations[0];
    double sum = 0.0;
    for (std::size_t bin = 0; bin < observation.bins(); ++bin) {
        const auto* p = &predictions[0].values[4 * bin];
        const auto* e = &observation.fitted.values[4 * bin];
        const double a = p[0].real() * kFloored + trial.noise_psd[0][0],
                     d = p[3].real() * kFloored + trial.noise_psd[0][1];
        const std::complex<double> c = p[1];  // row 2, column 1
        const double det = a * d - std::norm(c), own = e[0].real() * e[3].real() - std::norm(e[1]);
        const double trace = (d * e[0].real() + a * e[3].real() - 2.0 * std::real(std::conj(c) * e[1])) / det;
        sum -= observation.fitted.averages * (std::log(det) - std::log(own) + trace - 2.0);
    }
    EXPECT_LT(sum, -10.0);
    // The power of a bin is free within what r > 1 delayed copies claim to know of it too much: that can only raise the
    // likelihood, by the best of a fine search over it.
    double best = 0.0;
    for (std::size_t bin = 0; bin < observation.bins(); ++bin) {
        const auto* p = &predictions[0].values[4 * bin];
        const auto* e = &observation.fitted.values[4 * bin];
        double highest = -1e300, stiffness = 0.0;
        for (int i = 0; i <= 6000; ++i) {
            const double s = i == 0 ? 0.0 : -3.0 + 0.001 * i, power = std::exp(s);
            const double x = power * p[0].real() * kFloored, y = power * p[3].real() * kFloored,
                         m = trial.noise_psd[0][0], n = trial.noise_psd[0][1];
            const std::complex<double> c = power * p[1];
            const double a = x + m, d = y + n, det = a * d - std::norm(c),
                         own = e[0].real() * e[3].real() - std::norm(e[1]);
            // tr((S⁻¹E)²), E the excited part: the square of the trace less twice the determinant of S⁻¹E
            if (i == 0) {
                const double first = (d * x + a * y - 2.0 * std::norm(c)) / det, second = (x * y - std::norm(c)) / det;
                const double r = first * first - 2.0 * second;
                stiffness = r > 1.0 ? r / (r - 1.0) : 1e300;
            }
            const double trace = (d * e[0].real() + a * e[3].real() - 2.0 * std::real(std::conj(c) * e[1])) / det;
            if (i == 0 || s != 0.0)
                highest = std::max(highest, -(std::log(det) - std::log(own) + trace - 2.0) -
                                                (s == 0.0 ? 0.0 : 0.5 * stiffness * s * s));
        }
        best += observation.fitted.averages * highest;
    }
    EXPECT_GT(best, sum + 1.0);
    // the search's grid: ½·(0.0005)²·curvature
    EXPECT_NEAR(log_likelihood(trial, predictions, made.context()), best, 1e-4 * std::abs(best));
}

TEST(LogLikelihood, SaturatedIsZeroAndNothingIsAbove) {
    Synthesised made = small({"bogie_1", "wheel_2"});
    made.draw(3);
    Trial trial = another(made);
    std::fill(trial.floor.begin(), trial.floor.end(), 0.0);
    const Predictions predictions = predict(trial, made.context());
    EXPECT_LT(log_likelihood(trial, predictions, made.context()), 0.0);
    Observation& observation = made.observations[0];
    observation.fitted.values.clear();
    for (std::size_t bin = 0; bin < observation.bins(); ++bin) {
        const Eigen::MatrixXcd model = complete_prediction(trial, observation, 0, predictions[0], bin);
        observation.fitted.values.insert(observation.fitted.values.end(), model.data(), model.data() + 4);
    }
    set_log_determinants(observation.fitted, 2, 60.0);
    // 37 bins · n ≈ 22 · rounding of det and trace at a condition number of some 1e4
    EXPECT_NEAR(log_likelihood(trial, predictions, made.context()), 0.0, 1e-8);
}

/// What the slope is about: the unknowns of retuning, moved off their means.
struct Point {
    std::vector<Unknown> unknowns;
    std::vector<double> values;
    Trial trial;
    Predictions predictions;
};

Point point_of(const Synthesised& made, const LikelihoodContext& context, double away) {
    Point point{.unknowns = nuisance_unknowns(made.believed, made.observations)};
    point.values = means(point.unknowns);
    for (std::size_t i = 0; i < point.values.size(); ++i)
        if (point.unknowns[i].kind != UnknownKind::floor)
            point.values[i] += away * point.unknowns[i].deviation * (i % 2 ? 1.0 : -1.0);
        else
            point.values[i] += 4.0;  // a floor of 3 %, or nothing would depend on it
    point.trial = believed_trial(made.believed, made.observations);
    set_values(point.trial, point.unknowns, point.values);
    point.predictions = predict(point.trial, context);
    return point;
}

// Central differences of the log-likelihood. Their own error: third derivative times h²/6 and rounding ε·|L|/h; 1e-3 of
// the gradient's natural size √F covers both, and what a one-sided derivative of the predictions adds; 2e-2 of it the
// change of the number of processes r in a bin, which the slope takes as given (at most some 5e-3 nats).
TEST(LikelihoodSlope, GradientIsTheDerivative) {
    Synthesised made = small({"body", "bogie_1", "wheel_2"});
    made.draw(4);
    const LikelihoodContext context = made.context();
    const Point point = point_of(made, context, 0.2);
    const LikelihoodSlope slope =
        likelihood_slope(point.trial, point.unknowns, point.predictions,
                         differentiate(point.trial, point.unknowns, point.values, point.predictions, context), context);
    EXPECT_NEAR(slope.log_likelihood, log_likelihood(point.trial, point.predictions, context),
                1e-9 * std::abs(slope.log_likelihood));
    for (std::size_t i = 0; i < point.unknowns.size(); ++i) {
        const double natural = std::sqrt(slope.information(static_cast<long>(i), static_cast<long>(i)));
        if (natural == 0.0) continue;
        const double h = std::min(1e-3 / natural, 1e-3 * point.unknowns[i].deviation);
        const auto at = [&](double x) {
            Trial trial = point.trial;
            point.unknowns[i].set(trial, point.values[i] + x);
            return log_likelihood(trial, predict(trial, context), context);
        };
        EXPECT_NEAR(slope.gradient(static_cast<long>(i)), (at(h) - at(-h)) / (2.0 * h),
                    5e-3 + 2e-2 * (natural + std::abs(slope.gradient(static_cast<long>(i)))))
            << point.unknowns[i].name;
    }
}

// Nine channels of two speeds, whose bins are several processes each: the likelihood is that at the most probable power
// of every bin. Steps towards it that ended a thousandth before it made slopes wrong by up to 0.6 of their natural
// size, and fits crept; 0.05 is left. The counts of processes are held, as climb() holds them.
TEST(LikelihoodSlope, IsThatAtTheMostProbablePower) {
    Synthesised made = synthesised(
        paper_believed({"vehicle.bogie_mass_kg", "track.pads.static_stiffness_n_per_m", "contact.constant_m_per_n23"}),
        {15.0, 33.0}, 60.0, nine_channels(), {.window_s = 4.0, .low_hz = 2.0, .high_hz = 175.0});
    made.draw(4);
    LikelihoodContext context = made.context();
    const Point point = point_of(made, context, 0.05);
    const BinPowers powers = bin_powers(point.trial, point.predictions, context);
    context.powers = &powers;
    const LikelihoodSlope slope =
        likelihood_slope(point.trial, point.unknowns, point.predictions,
                         differentiate(point.trial, point.unknowns, point.values, point.predictions, context), context);
    for (std::size_t i = 0; i < point.unknowns.size(); ++i) {
        if (point.unknowns[i].kind != UnknownKind::irregularity) continue;
        // a step that is not worth making moves the likelihood itself by 1e-5
        const double natural = std::sqrt(slope.information(static_cast<long>(i), static_cast<long>(i))),
                     h = 0.03 / natural;
        const auto at = [&](double x) {
            Trial trial = point.trial;
            point.unknowns[i].set(trial, point.values[i] + x);
            return log_likelihood(trial, predict(trial, context), context);
        };
        EXPECT_NEAR(slope.gradient(static_cast<long>(i)), (at(h) - at(-h)) / (2.0 * h), 0.1 * natural)
            << point.unknowns[i].name;
    }
}

// Wherever the search for a bin's power begins, it ends where its rest is worth less than a thousandth of a nat
// (whitened_bin.cpp).
TEST(BinPowers, DoNotDependOnWhereTheSearchBegins) {
    Synthesised made = synthesised(paper_believed({}), {15.0, 33.0}, 60.0, nine_channels(),
                                   {.window_s = 4.0, .low_hz = 2.0, .high_hz = 60.0});
    made.draw(4);
    LikelihoodContext context = made.context();
    const Point point = point_of(made, context, 0.05);
    const BinPowers found = bin_powers(point.trial, point.predictions, context);
    BinPowers elsewhere = found;
    double bins = 0.0;
    for (std::vector<BinPower>& own : elsewhere.at)
        for (BinPower& power : own) power.log_amplification += 0.3, power.bend = 0.0, bins += 1.0;
    const auto likelihood_from = [&](const BinPowers& powers) {
        context.powers = &powers;
        return log_likelihood(point.trial, point.predictions, context);
    };
    EXPECT_NEAR(likelihood_from(found), found.log_likelihood, 1e-3 * bins);
    EXPECT_NEAR(likelihood_from(elsewhere), found.log_likelihood, 1e-3 * bins);
}

// At the truth the score has mean 0 and the Fisher information as covariance. 400 draws: a whitened variance estimate
// has standard error √(2/400) = 7 %, a mean 5 %. The mean square of many whitened components is far better determined;
// single ones get 5 standard errors.
TEST(LikelihoodSlope, InformationIsTheCovarianceOfScores) {
    Synthesised made = small({"body", "bogie_1", "wheel_2"});
    made.draw(5);
    const LikelihoodContext context = made.context();
    Point point = point_of(made, context, 0.0);
    std::fill(point.trial.floor.begin(), point.trial.floor.end(), 0.0);
    std::erase_if(point.unknowns, [](const Unknown& unknown) {
        return unknown.kind == UnknownKind::floor || unknown.name == "speed fluctuation";
    });
    point.values.resize(point.unknowns.size());
    made.truth = point.trial;
    const auto derivatives = differentiate(point.trial, point.unknowns, point.values, point.predictions, context);
    constexpr int kDraws = 400;
    const long size = static_cast<long>(point.unknowns.size());
    Eigen::MatrixXd scores(size, kDraws), information;
    for (int draw = 0; draw < kDraws; ++draw) {
        made.draw(1000 + static_cast<std::uint64_t>(draw));
        const LikelihoodSlope slope =
            likelihood_slope(point.trial, point.unknowns, point.predictions, derivatives, context);
        scores.col(draw) = slope.gradient;
        information = slope.information;
    }
    const Eigen::VectorXd scale = information.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd whitened = scale.asDiagonal() * scores;
    const Eigen::MatrixXd covariance = whitened * whitened.transpose() / kDraws;
    const Eigen::MatrixXd expected = scale.asDiagonal() * information * scale.asDiagonal();
    for (long i = 0; i < size; ++i) {
        EXPECT_NEAR(whitened.row(i).mean(), 0.0, 5.0 / std::sqrt(kDraws))
            << point.unknowns[static_cast<std::size_t>(i)].name;
        for (long j = 0; j <= i; ++j)
            EXPECT_NEAR(covariance(i, j), expected(i, j), 5.0 * std::sqrt(2.0 / kDraws)) << i << " " << j;
    }
    EXPECT_NEAR(covariance.trace() / static_cast<double>(size), 1.0, 0.1);
}

// A fit climbs by the Fisher information; that has to be the curvature also where a large floor blunts the likelihood.
// Differences over a fifth of a standard deviation; observed and expected information of 37 bins with 22 averages
// differ by 1/√(37·22) = 4 %, five of which. With the floor in the model and not in the estimate the ratio is 1.8.
TEST(LikelihoodSlope, BluntInformationIsTheCurvature) {
    Synthesised made = small(nine_channels());
    made.draw(6);
    LikelihoodContext context = made.context();
    context.least_floor = 0.1;
    Point point = point_of(made, context, 0.0);
    std::fill(point.trial.floor.begin(), point.trial.floor.end(), 0.0);
    const LikelihoodSlope slope =
        likelihood_slope(point.trial, point.unknowns, point.predictions,
                         differentiate(point.trial, point.unknowns, point.values, point.predictions, context), context);
    int numbers = 0;
    for (std::size_t i = 0; i < point.unknowns.size(); ++i) {
        if (point.unknowns[i].kind != UnknownKind::number) continue;
        const double information = slope.information(static_cast<long>(i), static_cast<long>(i)),
                     h = 0.2 / std::sqrt(information);
        // hardly seen: second derivatives of the prediction count (the pads below 40 Hz)
        if (h > 0.05 * point.unknowns[i].deviation) continue;
        const auto at = [&](double x) {
            Trial trial = point.trial;
            point.unknowns[i].set(trial, point.values[i] + x);
            return log_likelihood(trial, predict(trial, context), context);
        };
        const double ratio = -(at(h) - 2.0 * at(0.0) + at(-h)) / (h * h) / information;
        EXPECT_NEAR(ratio, 1.0, 0.2) << point.unknowns[i].name;
        ++numbers;
    }
    EXPECT_EQ(numbers, 3);
}

// The paper's irregularity jumps 16-fold at 1 m. At 20 m/s that edge lies on a line of the fine grid: a change of speed
// carries it across, and the expectation has to follow without a jump. 1e-9 of speed may move it by 1e-9 times what a
// log-derivative can be (some hundreds near the edge).
TEST(Expectation, ContinuousInSpeedWhereABandOfTheIrregularityEnds) {
    Synthesised made = synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {20.0}, 60.0, {"wheel_1"}, kSmall);
    made.draw(1);
    const auto at = [&](double factor) {
        Trial trial = made.truth;
        trial.speed_m_per_s[0] *= factor;
        return predict(trial, made.context());
    };
    const Predictions slower = at(1.0 - 1e-9), faster = at(1.0 + 1e-9);
    for (std::size_t i = 0; i < slower[0].values.size(); ++i)
        EXPECT_NEAR(faster[0].values[i].real() / slower[0].values[i].real(), 1.0, 1e-6);
}

// What a derivative does not hold is zero: the same sums, to the last bit, as with zeros written out.
TEST(LikelihoodSlope, ADerivativeMayHoldTheBinsThatItMoves) {
    Synthesised made = small({"body", "bogie_1", "wheel_2"});
    made.draw(6);
    const Point point = point_of(made, made.context(), 0.2);
    std::vector<PredictionDerivative> whole = differentiate(point.trial, point.unknowns, point.values,
                                                            point.predictions, made.context()),
                                      part = whole;
    const std::size_t elements = 9, first = 5, last = made.observations[0].bins() - 7;
    ASSERT_LT(first, last);
    std::fill_n(whole[0].values.begin(), first * elements, 0.0);
    std::fill(whole[0].values.begin() + static_cast<long>(last * elements), whole[0].values.end(), 0.0);
    part[0].first_bin = first;
    part[0].values.assign(whole[0].values.begin() + static_cast<long>(first * elements),
                          whole[0].values.begin() + static_cast<long>(last * elements));
    const auto slope = [&](const std::vector<PredictionDerivative>& derivatives) {
        return likelihood_slope(point.trial, point.unknowns, point.predictions, derivatives, made.context());
    };
    const LikelihoodSlope zeros = slope(whole), held = slope(part);
    EXPECT_NE(zeros.gradient(whole[0].unknown), 0.0);
    EXPECT_EQ(held.gradient, zeros.gradient);
    EXPECT_EQ(held.information, zeros.information);
}

TEST(LikelihoodSlope, SameBitsForAnyNumberOfThreads) {
    Synthesised made = small({"body", "bogie_1", "wheel_2"});
    made.draw(6);
    std::vector<LikelihoodSlope> slopes;
    std::vector<double> values;
    for (const int threads : {1, 2}) {
        const LikelihoodContext context = made.context(Part::fitted, threads);
        const Point point = point_of(made, context, 0.2);
        slopes.push_back(likelihood_slope(
            point.trial, point.unknowns, point.predictions,
            differentiate(point.trial, point.unknowns, point.values, point.predictions, context), context));
        values.push_back(log_likelihood(point.trial, point.predictions, context));
    }
    EXPECT_EQ(values[0], values[1]);
    EXPECT_EQ(slopes[0].log_likelihood, slopes[1].log_likelihood);
    EXPECT_EQ(slopes[0].gradient, slopes[1].gradient);
    EXPECT_EQ(slopes[0].information, slopes[1].information);
}

}  // namespace
}  // namespace railpem::diagnosis
