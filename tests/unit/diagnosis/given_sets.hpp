#pragma once
// Sets whose evidences are given: what the tests of verdicts and of posteriors share.

#include <cmath>

#include "diagnosis/effects/effect.hpp"
#include "diagnosis/judge/verdict.hpp"

namespace railpem::diagnosis {

inline const VerdictThresholds thresholds{};

inline Candidate given_member(const std::string& effect) {
    Candidate own{.instance = {.effect = effect, .values = {}, .choices = {}}};
    if (effect == "sensor-gain") own.instance.choices["channel"] = "bogie_1";
    if (effect == "suspension-friction") own.instance.choices["stage"] = "primary";
    return own;
}

inline FittedSet given_set(const std::vector<std::string>& effects, const std::vector<std::string>& released,
                           double score, double held_out) {
    FittedSet set{.released = released, .held_out = held_out};
    for (const std::string& effect : effects) set.effects.push_back(given_member(effect));
    set.fit.log_evidence = score;
    return set;
}

/// The one parameter of a set's effect lies on its upper bound and would gain so many nats beyond.
inline FittedSet leaning_set(FittedSet set, double nats) {
    set.fit.unknowns = {{.kind = UnknownKind::effect, .name = "rail-shear.shear_coefficient", .low = 0.0, .high = 1.0}};
    set.fit.values = {1.0};
    set.fit.gradient = Eigen::VectorXd::Constant(1, std::sqrt(2.0 * nats) / 0.1);
    set.fit.covariance = Eigen::MatrixXd::Constant(1, 1, 0.01);
    return set;
}

/// The one released number of a set lies on the end of what a wrong number is and would gain so many nats beyond.
inline FittedSet leaning_number(FittedSet set, double nats) {
    set = leaning_set(std::move(set), nats);
    set.fit.unknowns.front() = {.kind = UnknownKind::number,
                                .name = set.released.front(),
                                .deviation = kReleasedDeviation,
                                .low = -std::log(4.0),
                                .high = std::log(4.0)};
    set.fit.values.front() = set.fit.unknowns.front().high;
    return set;
}

inline NamingResult given_naming(std::vector<FittedSet> sets) {
    NamingResult naming;
    naming.retuned = given_set({}, {}, 0.0, 0.0);
    naming.sets = std::move(sets);
    return naming;
}

/// A contact at the top of its range that would gain 10 nats, of the 30 that its approximation may leave, `beyond`
/// times as far from Hertz's as that.
inline FittedSet contact_beyond(double beyond) {
    const EffectParameter& factor = find_effect("contact-nonlinearity")->parameters.front();
    FittedSet strong = leaning_set(given_set({"contact-nonlinearity"}, {}, 1000.0, 300.0), 10.0);
    Unknown& unknown = strong.fit.unknowns.front();
    unknown = {.kind = UnknownKind::effect,
               .name = "contact-nonlinearity.factor",
               .low = to_coordinate(factor, factor.low),
               .high = to_coordinate(factor, factor.high)};
    strong.fit.values.front() = unknown.high;
    const double step = to_coordinate(factor, factor.nothing + beyond * (factor.high - factor.nothing)) - unknown.high;
    strong.fit.covariance(0, 0) = step * step / (2.0 * 10.0);
    strong.fit.gradient(0) = step / strong.fit.covariance(0, 0);
    return strong;
}

}  // namespace railpem::diagnosis
