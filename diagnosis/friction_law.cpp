#include "diagnosis/friction_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnosis/friction_levels.hpp"
#include "diagnosis/friction_spectra.hpp"
#include "diagnosis/screen.hpp"

namespace railpem::diagnosis {

namespace {

// docs/theory/diagnosis.md
constexpr double kConstant = 1.1, kPerOverViscous = 0.22, kUncertain = 0.25;
constexpr double kStrongest = 12.0;  // of docs/proof/friction_laws.csv; a stage without a damper is beyond it
constexpr double kAgainst = 3.0, kWithin = 2.0;  // deviations

/// The prediction is linear in the power: its derivative is the difference of the prediction with these forces and without.
std::vector<PredictionDerivative> derivatives_with_power(const Fit& fit, const LikelihoodContext& context) {
    std::vector<Observation> silenced = *context.observations;
    for (Observation& own : silenced) own.expectation.friction_power = 0.0;
    LikelihoodContext silent = context;
    silent.observations = &silenced;
    std::vector<PredictionDerivative> derivatives;
    for (std::size_t o = 0; o < silenced.size(); ++o) {
        if (silenced[o].scalar || !has_friction(case_of(fit.trial, *context.believed, silenced[o]))) continue;
        const ExpectedSpectra without = predict_like(fit.predictions, fit.trial, silent, o, Reuse::rail);
        PredictionDerivative own{.observation = static_cast<int>(o), .unknown = 0, .values = fit.predictions[o].values};
        for (std::size_t i = 0; i < own.values.size(); ++i) own.values[i] -= without.values[i];
        derivatives.push_back(std::move(own));
    }
    return derivatives;
}

}  // namespace

std::optional<FrictionLaw> friction_law(const Fit& fit, const LikelihoodContext& context) {
    const std::vector<PredictionDerivative> derivatives = derivatives_with_power(fit, context);
    if (derivatives.empty()) return std::nullopt;
    const Unknown power{.kind = UnknownKind::correction, .name = "power of friction's own forces", .mean = 0.0, .deviation = 1.0};
    const FreedomPromise promise = promises_of(fit, {{power}}, context, [&](std::size_t) { return derivatives; }).front();
    FrictionLaw law{.power = 1.0 + promise.values(0), .deviation = std::sqrt(promise.covariance(0, 0))};
    for (const FrictionLevel& level : friction_levels(fit.trial, *context.believed, *context.observations)) law.over_viscous = std::max(law.over_viscous, level.over_viscous);
    return law;
}

double FrictionLaw::constant_below() const { return kConstant + kPerOverViscous * std::min(over_viscous, 1.0); }

double FrictionLaw::another_above() const { return kConstant + kPerOverViscous * std::min(over_viscous, kStrongest) + kUncertain; }

bool is_another(const FrictionLaw& law) { return law.power - kAgainst * law.deviation > law.another_above(); }

bool is_open(const FrictionLaw& law) { return !is_another(law) && law.power + kWithin * law.deviation > law.constant_below(); }

double probability_of_another(const FrictionLaw& law) {
    const double middle = 0.5 * (law.constant_below() + law.another_above()), reach = 0.5 * (law.another_above() - law.constant_below());
    return 0.5 * std::erfc((middle - law.power) / (std::hypot(law.deviation, reach) * std::numbers::sqrt2));
}

std::string said_of(const FrictionLaw& law) {
    const char* meaning = is_another(law) ? "it is not constant, and sticks harder than it slides or follows another law of the velocity"
                          : is_open(law)  ? "it may be constant, or stick harder than it slides"
                                          : "within what a constant force has";
    return fmt::format("friction: the forces that it has beside its damping have {:.2f} +- {:.2f} times the power that a constant force has where velocities are Gaussian; as strong as here it has up to {:.2f}, and above {:.2f} another law: {}",
                       law.power, law.deviation, law.constant_below(), law.another_above(), meaning);
}

}  // namespace railpem::diagnosis
