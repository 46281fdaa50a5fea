#include "diagnosis/judge/friction_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "diagnosis/hypotheses/screen.hpp"
#include "diagnosis/judge/constant_friction.hpp"

namespace railpem::diagnosis {

namespace {

// docs/theory/diagnosis.md
// a constant force has 0.75 to 0.99, one that holds 1.4 to 2 times as much at rest 1.05 to 1.15
constexpr double kConstant = 1.04;
constexpr double kRealised = 0.01;  // scatter of what is expected with the seed of its realisations
// expected of a force that holds its stage for most of the time: one of twice as much at rest had 1.03 to 1.12 there;
// at one speed one of 1.4 times as much had 1.00
constexpr double kStrong = 1.5, kUntold = 0.05;
constexpr double kSameSpeed = 0.05;              // relative
constexpr double kAgainst = 3.0, kWithin = 2.0;  // deviations

bool are_at_one_speed(const LikelihoodContext& context, const std::vector<PredictionDerivative>& derivatives) {
    double slowest = std::numeric_limits<double>::infinity(), fastest = 0.0;
    for (const PredictionDerivative& own : derivatives) {
        const double speed = (*context.observations)[static_cast<std::size_t>(own.observation)].speed_m_per_s;
        slowest = std::min(slowest, speed), fastest = std::max(fastest, speed);
    }
    return fastest < (1.0 + kSameSpeed) * slowest;
}

FrictionLaw law_with(const Fit& fit, const LikelihoodContext& context,
                     const std::vector<PredictionDerivative>& derivatives) {
    const FreedomPromise promise =
        promises_of(fit, {{power_of_friction()}}, context, [&](std::size_t) { return derivatives; }).front();
    return {.power = 1.0 + promise.values(0),
            .deviation = std::sqrt(promise.covariance(0, 0)),
            .at_one_speed = are_at_one_speed(context, derivatives)};
}

}  // namespace

std::optional<FrictionLaw> friction_power(const Fit& fit, const LikelihoodContext& context) {
    const std::vector<PredictionDerivative> derivatives = derivatives_with_power(fit, context);
    if (derivatives.empty()) return std::nullopt;
    return law_with(fit, context, derivatives);
}

std::optional<FrictionLaw> friction_law(const Fit& fit, const LikelihoodContext& context) {
    const std::vector<PredictionDerivative> derivatives = derivatives_with_power(fit, context);
    if (derivatives.empty()) return std::nullopt;
    FrictionLaw law = law_with(fit, context, derivatives);
    // else the fit bends so far that nothing is expected of it
    if (const double expected = power_of_constant(fit, context, derivatives); expected > 0.0) law.expected = expected;
    return law;
}

double FrictionLaw::ratio() const {
    return power / expected;
}

double FrictionLaw::uncertainty() const {
    return std::hypot(deviation / expected, kRealised);
}

double FrictionLaw::untold() const {
    return expected > kStrong || at_one_speed ? std::hypot(deviation / expected, kUntold) : uncertainty();
}

bool is_another(const FrictionLaw& law) {
    return law.ratio() - kAgainst * law.uncertainty() > 1.0;
}

bool is_open(const FrictionLaw& law) {
    return !is_another(law) && law.ratio() + kWithin * law.untold() > kConstant;
}

double probability_of_another(const FrictionLaw& law) {
    const double middle = 0.5 * (1.0 + kConstant), reach = 0.5 * (kConstant - 1.0);
    return 0.5 * std::erfc((middle - law.ratio()) / (std::hypot(law.untold(), reach) * std::numbers::sqrt2));
}

std::string said_of(const FrictionLaw& law) {
    const char* meaning =
        is_another(law) ? "it is not constant, and sticks harder than it slides or follows another law of the velocity"
        : is_open(law)  ? "it may be constant, or stick harder than it slides"
                        : "within what a constant force has";
    return fmt::format(
        "friction: the forces that it has beside its damping have {:.2f} +- {:.2f} times the power that a constant "
        "force has where velocities are Gaussian, where one that is realised in time would seem to have {:.2f}: {}",
        law.power, law.deviation, law.expected, meaning);
}

}  // namespace railpem::diagnosis
