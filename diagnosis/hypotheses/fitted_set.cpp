#include "diagnosis/hypotheses/fitted_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace railpem::diagnosis {

namespace {

constexpr double kLogPriorOfSomething = -0.7;  ///< something is missing as often as not
constexpr double kLogPriorOfAnother = -2.3;    ///< and one time in ten another thing beside it
constexpr double kLogPriorOfUnknown = -3.0;    ///< and one time in twenty something without a name

double prior_of(const FittedSet& set, std::size_t numbers) {
    double sum = 0.0;
    for (const Candidate& candidate : set.effects) sum += candidate.log_prior;
    // a case has a wrong number as often as it lacks physics
    for (std::size_t i = 0; i < set.released.size(); ++i) sum -= std::log(static_cast<double>(numbers));
    if (set.members() > 0 || !set.anonymous.empty()) sum += kLogPriorOfSomething;
    if (set.members() > 1) sum += kLogPriorOfAnother * static_cast<double>(set.members() - 1);
    if (!set.anonymous.empty()) sum += kLogPriorOfUnknown;
    return sum;
}

/// The value that a near fit has for an unknown, or its mean.
double start_of(const Unknown& unknown, const Fit& near) {
    std::size_t index = 0;
    return near.find(unknown.name, &index) ? near.values[index] : unknown.mean;
}

/// Where the near fit has a member: the second of two alike is the second there. −1: nowhere.
int counterpart(const std::vector<EffectInstance>& near, const std::vector<EffectInstance>& before,
                const EffectInstance& member) {
    const auto alike = [&](const EffectInstance& instance) { return same_variant(instance, member); };
    auto left = std::count_if(before.begin(), before.end(), alike);
    for (std::size_t i = 0; i < near.size(); ++i)
        if (alike(near[i]) && left-- == 0) return static_cast<int>(i);
    return -1;
}

/// A member of the near fit starts where that fit left it (or where its values were moved to), a new one at its own
/// strength.
void add_member(const Candidate& member, const Fit& near, Supposition& own) {
    const Effect& effect = *find_effect(member.instance.effect);
    const int index = counterpart(near.trial.effects, own.trial.effects, member.instance);
    for (const Unknown& unknown : effect_unknowns(member.instance, own.trial.effects.size())) {
        const std::string name = unknown.name.substr(unknown.name.find('.') + 1);
        const auto parameter = std::find_if(effect.parameters.begin(), effect.parameters.end(),
                                            [&](const EffectParameter& one) { return one.name == name; });
        double value =
            to_coordinate(*parameter, member.instance.values.count(name) ? member.instance.values.at(name)
                                                                         : value_of(effect, member.instance, name));
        for (std::size_t u = 0; u < near.unknowns.size(); ++u)
            if (near.unknowns[u].kind == UnknownKind::effect && near.unknowns[u].index == index &&
                near.unknowns[u].name == unknown.name)
                value = near.values[u];
        own.start.push_back(std::clamp(value, unknown.low, unknown.high));
        own.unknowns.push_back(unknown);
    }
    own.trial.effects.push_back(member.instance);
}

bool is_released(const Unknown& unknown, const std::vector<std::string>& released) {
    return unknown.kind == UnknownKind::number &&
           std::find(released.begin(), released.end(), unknown.name) != released.end();
}

/// The parameter or number that would gain most beyond its range.
struct Furthest {
    double nats = 0.0;
    std::size_t unknown = 0;
};

Furthest furthest_beyond(const FittedSet& set) {
    Furthest most;
    for (std::size_t u = 0; u < set.fit.unknowns.size(); ++u) {
        const Unknown& unknown = set.fit.unknowns[u];
        if (unknown.kind != UnknownKind::effect && !is_released(unknown, set.released)) continue;
        const double x = set.fit.values[u];
        if (x > unknown.low && x < unknown.high) continue;
        const double slope = set.fit.gradient(static_cast<long>(u));
        if ((x >= unknown.high && slope > 0.0) || (x <= unknown.low && slope < 0.0)) {
            const double deviation = set.fit.deviation(u), nats = 0.5 * slope * slope * deviation * deviation;
            if (nats > most.nats) most = {nats, u};
        }
    }
    return most;
}

/// By the range either way; nothing that is positive falls below a fifth of its least.
void widen(const EffectParameter& parameter, Unknown& unknown) {
    constexpr double kLeast = 0.2;
    const double width = unknown.high - unknown.low;
    unknown.low =
        std::max(unknown.low - width, parameter.low > 0.0 ? to_coordinate(parameter, kLeast * parameter.low) : -1e300);
    unknown.high += width;
    unknown.mean = 0.5 * (unknown.low + unknown.high);
    unknown.deviation = 0.5 * (unknown.high - unknown.low);
}

}  // namespace

Unknown released(Unknown number) {
    using parameters::Nature;
    const auto is = [&](Nature nature) { return number.nature == nature; };
    const double reach =
        std::max(is(Nature::stiffness) || is(Nature::damping) || is(Nature::loss) ? std::log(10.0) : std::log(4.0),
                 2.0 * number.deviation);
    number.deviation = std::max(number.deviation, kReleasedDeviation);
    number.low = std::max(number.low, number.mean - reach);
    number.high = std::min(number.high, number.mean + reach);
    return number;
}

double nats_beyond_range(const FittedSet& set) {
    return furthest_beyond(set).nats;
}

std::string number_beyond_range(const FittedSet& set) {
    const Furthest most = furthest_beyond(set);
    return most.nats > 0.0 && set.fit.unknowns[most.unknown].kind == UnknownKind::number
               ? set.fit.unknowns[most.unknown].name
               : "";
}

bool is_too_strong(const FittedSet& set) {
    constexpr double kInexact = 3.0;
    const Furthest most = furthest_beyond(set);
    if (most.nats == 0.0) return false;
    if (set.fit.unknowns[most.unknown].kind == UnknownKind::number) return true;
    const double x = set.fit.values[most.unknown], deviation = set.fit.deviation(most.unknown);
    const EffectParameter* parameter = parameter_of(set.fit.unknowns[most.unknown]);
    if (!parameter || !parameter->strength || parameter->nothing >= parameter->high ||
        x < set.fit.unknowns[most.unknown].high)
        return false;
    const double beyond =
        from_coordinate(*parameter, x + set.fit.gradient(static_cast<long>(most.unknown)) * deviation * deviation);
    return beyond - parameter->nothing > (1.0 + kInexact * parameter->inexact) * (parameter->high - parameter->nothing);
}

double part_log_likelihood(const Fit& fit, const LikelihoodContext& context, Part part) {
    if (fit.predictions.spectra.empty()) return -std::numeric_limits<double>::infinity();
    LikelihoodContext other = context;
    other.part = part;
    std::optional<Predictions> made;
    return log_likelihood(fit.trial, predictions_of(fit.trial, fit.predictions, context, part, made), other);
}

bool has_members(const FittedSet& set, const std::vector<Candidate>& effects,
                 const std::vector<std::string>& released) {
    return set.released == released &&
           std::equal(set.effects.begin(), set.effects.end(), effects.begin(), effects.end(),
                      [](const Candidate& a, const Candidate& b) { return same_variant(a.instance, b.instance); });
}

Supposition suppose(const BelievedCase& believed, const Fit& near, const std::vector<Candidate>& members,
                    const std::vector<std::string>& released, const std::vector<CorrectionPlace>& anonymous,
                    const LikelihoodContext& context) {
    Supposition own{.trial = believed_trial(believed, *context.observations),
                    .unknowns = nuisance_unknowns(believed, *context.observations),
                    .start = {}};
    for (Unknown& unknown : own.unknowns)
        if (is_released(unknown, released)) unknown = diagnosis::released(std::move(unknown));
    for (const Unknown& unknown : own.unknowns)
        own.start.push_back(std::clamp(start_of(unknown, near), unknown.low, unknown.high));
    for (const Candidate& member : members) add_member(member, near, own);
    for (const CorrectionPlace& place : anonymous)
        for (Unknown& unknown : correction_unknowns(place, *context.observations)) {
            own.start.push_back(start_of(unknown, near));
            own.unknowns.push_back(std::move(unknown));
        }
    return own;
}

FittedSet fit_set(const BelievedCase& believed, const Fit& near, std::vector<Candidate> members,
                  std::vector<std::string> released, std::vector<CorrectionPlace> anonymous,
                  const LikelihoodContext& context, const FitOptions& options) {
    FittedSet set{.effects = std::move(members), .released = std::move(released), .anonymous = std::move(anonymous)};
    Supposition own = suppose(believed, near, set.effects, set.released, set.anonymous, context);
    FitOptions from_near = options;
    from_near.near = near.derivatives;
    set.fit = fit(own.trial, std::move(own.unknowns), std::move(own.start), context, from_near);
    set.log_prior = prior_of(set, believed.uncertain.size());
    set.held_out = part_log_likelihood(set.fit, context, Part::held_out);
    return set;
}

FittedSet fit_correction(const BelievedCase& believed, const FittedSet& beside, const LocatedEvidence& located,
                         const LikelihoodContext& context, const FitOptions& options) {
    const Fit& near = beside.fit;
    const std::vector<Unknown> freedom = correction_unknowns(located.place, *context.observations);
    Fit best;
    double highest = -std::numeric_limits<double>::infinity();
    for (const double part : {1.0, 0.3, 0.1, 0.0}) {
        Fit moved{
            .trial = near.trial, .unknowns = near.unknowns, .values = near.values, .derivatives = near.derivatives};
        for (std::size_t u = 0; u < moved.values.size(); ++u)
            moved.values[u] += part * located.promise.move(static_cast<long>(u));
        for (std::size_t u = 0; u < freedom.size(); ++u) {
            moved.unknowns.push_back(freedom[u]);
            moved.values.push_back(freedom[u].mean + part * located.promise.values(static_cast<long>(u)));
        }
        for (std::size_t u = 0; u < moved.values.size(); ++u)
            moved.values[u] = std::clamp(moved.values[u], moved.unknowns[u].low, moved.unknowns[u].high);
        const Supposition supposition =
            suppose(believed, moved, beside.effects, beside.released, {located.place}, context);
        const double posterior = log_posterior_at(supposition.trial, supposition.unknowns, supposition.start, context);
        if (posterior > highest) highest = posterior, best = std::move(moved);
        if (highest > near.log_posterior) break;
    }
    return fit_set(believed, best, beside.effects, beside.released, {located.place}, context, options);
}

const Candidate* leaning_member(const BelievedCase& believed, const FittedSet& leaning) {
    const Unknown& furthest = leaning.fit.unknowns[furthest_beyond(leaning).unknown];
    if (furthest.kind != UnknownKind::effect) return nullptr;
    const Candidate& member = leaning.effects[static_cast<std::size_t>(furthest.index) - believed.effects.size()];
    return element_of(*find_effect(member.instance.effect), member.instance) == Element::contact ? nullptr : &member;
}

std::optional<FittedSet> fit_beyond_range(const BelievedCase& believed, const FittedSet& leaning,
                                          const LikelihoodContext& context, const FitOptions& options) {
    const Candidate* member = leaning_member(believed, leaning);
    if (!member) return std::nullopt;
    const Element element = element_of(*find_effect(member->instance.effect), member->instance);
    FittedSet set{.effects = {*member}, .beyond = true};
    Supposition own = suppose(believed, leaning.fit, set.effects, {}, {}, context);
    for (Unknown& unknown : own.unknowns)
        if (const EffectParameter* parameter = parameter_of(unknown)) widen(*parameter, unknown);
    set.fit = fit(own.trial, std::move(own.unknowns), std::move(own.start), context, options);
    set.fit.derivatives.reset();  // nothing starts from there
    set.anonymous = {{.element = element, .channel = {}}};
    set.log_prior = prior_of(set, believed.uncertain.size());
    set.held_out = part_log_likelihood(set.fit, context, Part::held_out);
    return set;
}

}  // namespace railpem::diagnosis
