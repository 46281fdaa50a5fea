#include "diagnosis/findings/write_up.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnosis/findings/decay_rate_reference.hpp"
#include "diagnosis/findings/fit_figures.hpp"
#include "diagnosis/findings/imperfections.hpp"
#include "diagnosis/findings/inferred_curve.hpp"
#include "diagnosis/findings/rivals.hpp"
#include "diagnosis/findings/statement.hpp"
#include "diagnosis/fit/interval.hpp"
#include "diagnosis/judge/belief_kept.hpp"
#include "diagnosis/judge/compare_channels.hpp"
#include "diagnosis/judge/posterior.hpp"
#include "diagnosis/model/friction_levels.hpp"
#include "diagnosis/model/wheel_unloading.hpp"
#include "diagnosis/observations/shows.hpp"

namespace railpem::diagnosis {

namespace {

class WritingUp {
  public:
    WritingUp(const Findings& found, Diagnosis& result)
        : found_(found),
          believed_(found.believed),
          observations_(found.observations),
          context_(found.context),
          thresholds_(found.thresholds),
          naming_(found.naming),
          study_(found.study),
          decision_(found.decision),
          baseline_(found.kept ? *found.study.belief_kept : found.naming.retuned),
          retuned_(found.kept ? *found.kept : found.retuned),
          named_(found.named),
          result_(result) {}

    void run() {
        const Decision& decision = decision_;
        result_.verdict = decision.verdict;
        result_.posterior = posterior_of(naming_, decision);
        result_.places = place_probabilities(naming_, study_, decision, thresholds_);
        report_figures(decision);
        report_margins();
        const bool names =
            decision.named && decision.verdict != Verdict::ambiguous && decision.verdict != Verdict::consistent;
        if (names) report_omitted(decision);
        result_.rivals = rivals_of(found_);
        report_numbers();
        report_curve();
        for (const NotTested& not_tested : naming_.not_tested)
            result_.not_tested.push_back(not_tested.effect + ": " + not_tested.why);
        report_recordings();
        report_basis();
        const Fit& diagnosed = names ? named_.fit : found_.retuned.fit;
        result_.imperfections = imperfections(diagnosed, observations_);
        result_.diagnosed_numbers = diagnosed.trial.numbers;
        result_.diagnosed_numbers.decay_rate_reference =
            decay_rate_reference(diagnosed.trial, diagnosed.predictions, observations_);
        result_.diagnosed_effects = diagnosed.trial.effects;
        result_.statement = statement_of(result_);
    }

  private:
    void report_margins() {
        if (!naming_.sets.empty()) {
            result_.margins.score = naming_.sets.front().score() - naming_.retuned.score();
            result_.margins.held_out = naming_.sets.front().held_out - naming_.retuned.held_out;
        }
        if (!study_.at_retuned.empty()) result_.margins.place = study_.at_retuned.front().nats;
    }

    void report_figures(const Decision& decision) {
        Trial believed = believed_trial(believed_, observations_);
        believed.noise_psd = naming_.retuned.fit.trial.noise_psd;
        believed.flicker_psd = naming_.retuned.fit.trial.flicker_psd;
        believed.floor = naming_.retuned.fit.trial.floor;
        believed.discrepancy = naming_.retuned.fit.trial.discrepancy;
        believed.numbers.modifiers.met_alone = naming_.retuned.fit.trial.numbers.modifiers.met_alone;
        for (std::size_t o = 0; o < observations_.size(); ++o)
            for (std::size_t c = 0; c < believed.log_gain[o].size(); ++c)
                if (observations_[o].unknown_scale[c])
                    believed.log_gain[o][c] = naming_.retuned.fit.trial.log_gain[o][c];
        const Predictions before = predict(believed, context_);
        const FittedSet& after = decision.named ? *decision.named : naming_.retuned;
        const FigureScale scale(after.fit, context_);
        result_.before = scale.of(believed, before, Part::fitted);
        result_.retuned = scale.of(baseline_.fit, Part::fitted);
        result_.after = scale.of(after.fit, Part::fitted);
        result_.held_out_before = scale.of(believed, before, Part::held_out);
        result_.held_out_retuned = scale.of(baseline_.fit, Part::held_out);
        result_.held_out_after = scale.of(after.fit, Part::held_out);
        FitFigures freely = result_.retuned;
        if (found_.kept) {
            freely = scale.of(naming_.retuned.fit, Part::fitted);
            result_.freely_retuned = FreelyRetuned{freely, scale.of(naming_.retuned.fit, Part::held_out)};
        }
        const double deficit = result_.after.log_likelihood_per_second - result_.before.log_likelihood_per_second;
        const double removed = freely.log_likelihood_per_second - result_.before.log_likelihood_per_second;
        result_.hidden_by_retuning = deficit > 0.0 ? std::clamp(removed / deficit, 0.0, 1.0) : 1.0;
        std::optional<Predictions> made;
        const Predictions& before_on_all = predictions_of(believed, before, context_, Part::all, made);
        const Stages stages{&believed,         &before_on_all,         &retuned_.fit.trial, &retuned_.fit.predictions,
                            &named_.fit.trial, &named_.fit.predictions};
        result_.channels = compare_channels(stages, observations_, Part::all);
        result_.mismatch = mismatches(retuned_.fit.trial, retuned_.fit.predictions, observations_, Part::all);
        for (Mismatch& mismatch : result_.mismatch)
            mismatch.element = result_.places.empty() ? Element::body : result_.places.front().element;
    }

    void report_omitted(const Decision& decision) {
        const std::size_t own = believed_.effects.size();
        for (std::size_t i = 0; i < named_.effects.size(); ++i) {
            const EffectInstance& instance = named_.fit.trial.effects[own + i];
            const Effect& effect = *find_effect(instance.effect);
            NamedEffect named{.instance = instance,
                              .element = element_of(effect, instance),
                              .says = effect.says,
                              .source = effect.source};
            named.probability = probability_with(naming_, decision, [&](const FittedSet& set) {
                return std::any_of(set.effects.begin(), set.effects.end(),
                                   [&](const Candidate& member) { return same_variant(member.instance, instance); });
            });
            for (std::size_t u = 0; u < named_.fit.unknowns.size(); ++u) {
                const Unknown& unknown = named_.fit.unknowns[u];
                if (unknown.kind != UnknownKind::effect || unknown.index != static_cast<int>(own + i)) continue;
                const EffectParameter& parameter = *parameter_of(unknown);
                const double reach = kNinety * named_.fit.deviation(u), x = named_.fit.values[u];
                const double low = from_coordinate(parameter, std::max(unknown.low, x - reach)),
                             high = from_coordinate(parameter, std::min(unknown.high, x + reach));
                named.parameters.push_back({parameter.name, from_coordinate(parameter, x), low, high, parameter.unit});
                report_by_recording(u, named.parameters.back());
            }
            share_of(named, i, decision);
            result_.omitted.push_back(std::move(named));
        }
        for (const std::string& key : named_.released) report_released(key, decision);
    }

    /// The named fit has the unknowns of the best set in the same order.
    void report_by_recording(std::size_t unknown, FittedParameter& parameter) const {
        for (const ParameterByRecording& own : study_.by_recording) {
            if (own.unknown != unknown) continue;
            parameter.nats_against_one_value = own.nats;
            for (std::size_t i = 0; i < own.value.size(); ++i)
                parameter.by_recording.push_back({observations_[own.observation[i]].name, own.value[i]});
        }
    }

    void report_released(const std::string& key, const Decision& decision) {
        std::size_t u = 0;
        named_.fit.find(key, &u);
        const double reach = kNinety * named_.fit.deviation(u), x = named_.fit.values[u];
        NamedEffect named{.instance = wrong_number(key, std::exp(x)), .element = element_of_key(key)};
        named.says = find_effect(named.instance.effect)->says;
        named.source = find_effect(named.instance.effect)->source;
        named.parameters.push_back({"factor", std::exp(x), std::exp(x - reach), std::exp(x + reach), "1"});
        named.probability = probability_with(naming_, decision, [&](const FittedSet& set) {
            return std::find(set.released.begin(), set.released.end(), key) != set.released.end();
        });
        named.nats_fitted = decision.named->fit.log_likelihood - baseline_.fit.log_likelihood;
        named.nats_held_out = decision.named->held_out - baseline_.held_out;
        result_.omitted.push_back(std::move(named));
    }

    /// The best fitted set without a member, or what the verdict is held against. Beliefs are given up together:
    /// retuning has moved each of them in the others' place.
    const FittedSet& without(std::size_t member, const FittedSet& best) const {
        const FittedSet* found = &baseline_;
        if (found_.kept) return *found;
        const auto times = [&](const FittedSet& one) {
            return std::count_if(one.effects.begin(), one.effects.end(), [&](const Candidate& own) {
                return same_variant(own.instance, best.effects[member].instance);
            });
        };
        for (const FittedSet& set : naming_.sets)
            if (set.members() + 1 == best.members() && set.released == best.released && times(set) < times(best) &&
                set.fit.log_likelihood > found->fit.log_likelihood)
                found = &set;
        return *found;
    }

    /// What a member explains.
    void share_of(NamedEffect& named, std::size_t member, const Decision& decision) {
        const FittedSet &best = *decision.named, &rest = without(member, best);
        named.nats_fitted = best.fit.log_likelihood - rest.fit.log_likelihood;
        named.nats_held_out = best.held_out - rest.held_out;
    }

    std::vector<RetunedNumber> numbers_of(const Fit& fit) const {
        std::vector<RetunedNumber> numbers;
        for (std::size_t u = 0; u < fit.unknowns.size(); ++u) {
            if (fit.unknowns[u].kind != UnknownKind::number) continue;
            const auto number =
                std::find_if(believed_.uncertain.begin(), believed_.uncertain.end(),
                             [&](const BelievedNumber& own) { return own.key == fit.unknowns[u].name; });
            const double reach = kNinety * fit.deviation(u), x = fit.values[u];
            RetunedNumber own{.key = number->key,
                              .unit = number->unit,
                              .believed = number->value,
                              .value = number->value * std::exp(x),
                              .low = number->value * std::exp(std::max(fit.unknowns[u].low, x - reach)),
                              .high = number->value * std::exp(std::min(fit.unknowns[u].high, x + reach)),
                              .tolerance = number->tolerance,
                              .tolerances_away = x / number->tolerance};
            own.outside = std::abs(own.tolerances_away) > kKeptTolerances;
            numbers.push_back(own);
        }
        return numbers;
    }

    void report_numbers() {
        result_.retuned_numbers = numbers_of(found_.retuned.fit);
        result_.numbers = numbers_of(named_.fit);
    }

    void report_curve() {
        for (const FittedSet& set : study_.anonymous) {
            const Element element = set.anonymous.front().element;
            const bool has_law =
                element != Element::irregularity && element != Element::sensor && !is_wheels_own(set.anonymous.front());
            if (!has_law || set.beyond) continue;
            InferredCurve curve = inferred_curve(set.fit, set.anonymous.front(), believed_, observations_);
            curve.retuned = law_of(retuned_.fit, curve, believed_, observations_);
            curve.diagnosed = law_of(named_.fit, curve, believed_, observations_);
            result_.curves.push_back(std::move(curve));
        }
    }

    /// What no wrong number is and still helps most.
    void report_no_wrong_number() {
        if (naming_.sets.empty() || decision_.verdict != Verdict::unexplained) return;
        const FittedSet& best = naming_.sets.front();
        if (const std::string key = no_wrong_number(best, naming_.retuned.score()); !key.empty())
            result_.remains.push_back(
                fmt::format("{} would have to be further off than by a factor of {:.0f}, more than a wrong number is: "
                            "it stands in for what is missing",
                            key, std::exp(best.fit.find(key)->high - best.fit.find(key)->mean)));
    }

    /// What the best unknown is like, where it is an effect beyond the range of its physics.
    void report_beyond_range() {
        const auto lower = [](const FittedSet& a, const FittedSet& b) { return a.score() < b.score(); };
        const auto best = std::max_element(study_.anonymous.begin(), study_.anonymous.end(), lower);
        if (best == study_.anonymous.end() || !best->beyond || decision_.verdict != Verdict::unexplained) return;
        const EffectInstance& instance = best->fit.trial.effects.back();
        result_.remains.push_back(
            fmt::format("something at the {} acts like {} with {}, which that physics cannot have",
                        element_name(best->anonymous.front().element), instance.effect, values_in_words(instance)));
    }

    void report_recordings() {
        for (std::size_t o = 0; o < observations_.size(); ++o) {
            const Observation& observation = observations_[o];
            UsedRecording used{.name = observation.name,
                               .observed_speed = observation.observed_speed,
                               .stated_speed_m_per_s = observation.speed_m_per_s,
                               .payload_kg = observation.payload_kg,
                               .seconds = observation.all.seconds,
                               .held_out_seconds = observation.held_out.seconds,
                               .low_hz = observation.expectation.low_hz,
                               .high_hz = observation.expectation.high_hz,
                               .window_s = observation.scalar ? 0.0 : 1.0 / observation.kernel.bin_hz(),
                               .averages = observation.all.averages};
            used.channels = observation.channel_names;
            std::size_t u = 0;
            if (named_.fit.find("speed of " + observation.name, &u)) {
                const double reach = kNinety * named_.fit.deviation(u);
                used.speed_m_per_s = observation.speed_m_per_s * std::exp(named_.fit.values[u]);
                used.speed_low = used.speed_m_per_s * std::exp(-reach);
                used.speed_high = used.speed_m_per_s * std::exp(reach);
            }
            result_.recordings.push_back(std::move(used));
        }
    }

    void report_basis() {
        result_.per_value = std::all_of(observations_.begin(), observations_.end(),
                                        [](const Observation& own) { return own.scalar.has_value(); });
        for (const std::string& basis : scalar_basis(observations_)) result_.rests_on.push_back(basis);
        std::map<long, int> speeds;
        for (const Observation& observation : observations_)
            if (observation.speed_m_per_s > 0.0) ++speeds[std::lround(10.0 * observation.speed_m_per_s)];
        if (speeds.empty())
            result_.rests_on.push_back("the track alone, without a vehicle");
        else if (speeds.size() > 1)
            result_.rests_on.push_back(std::to_string(speeds.size()) +
                                       " speeds: irregularity keeps its wavelength, structure its frequency");
        else
            result_.rests_on.push_back(std::string("one speed: what lies below the wheels shows only through the "
                                                   "coupling of neighbouring wheels and the ") +
                                       (believed_.measured_irregularity.empty() ? "believed" : "measured") +
                                       " irregularity");
        if (!result_.per_value)
            result_.rests_on.push_back("ratios between the channels, which do not care what the irregularity is");
        for (const RetunedNumber& number : result_.numbers)
            if (number.outside)
                result_.remains.push_back(number.key + " ends " +
                                          std::to_string(std::abs(number.tolerances_away)).substr(0, 4) +
                                          " tolerances away from what was believed");
        const double off = decision_.named ? study_.named_level_db : study_.retuned_level_db;
        if (off > thresholds_.level_db)
            result_.remains.push_back(
                fmt::format("the levels are off by {:.1f} dB rms beyond chance and stated errors; {:g} dB is what a "
                            "case that explains may leave",
                            off, thresholds_.level_db));
        if (result_.retuned.rms_db > result_.before.rms_db + thresholds_.level_db)
            result_.remains.push_back(
                fmt::format("retuning failed: the retuned case is {:.1f} dB from the recorded levels, the believed one "
                            "{:.1f} dB; its numbers say nothing",
                            result_.retuned.rms_db, result_.before.rms_db));
        const double missed = decision_.named ? study_.by_named : study_.by_retuned;
        if (missed > thresholds_.residual)
            result_.remains.push_back(
                fmt::format("the unseen part repeats {:.0f} nats of what the fit misses, more than chance: something "
                            "of the recordings has no name here",
                            missed));
        if (decision_.named && !study_.at_named.empty() && study_.at_named.front().nats > thresholds_.residual)
            result_.remains.push_back(fmt::format("a free correction of the {} would still bring {:.0f} nats",
                                                  element_name(study_.at_named.front().element),
                                                  std::trunc(study_.at_named.front().nats)));
        if (decision_.verdict == Verdict::unexplained && decision_.named && !names_friction(*decision_.named) &&
            study_.named_level_db > thresholds_.level_db)
            result_.remains.push_back(
                fmt::format("third octaves stay off by {:.1f} dB, in the fitted part and in the unseen alike: what is "
                            "named stands in for something else",
                            study_.named_level_db));
        report_no_wrong_number();
        report_beyond_range();
        for (const std::string& belief : study_.unfounded)
            result_.remains.push_back(
                fmt::format("{} would be more probable than what it costs, but not on data that no fit has seen "
                            "against a case that keeps what was believed",
                            belief));
        const double bearable =
            decision_.named ? nats_left(*decision_.named, naming_.retuned.score(), thresholds_.residual) : 0.0;
        for (const NamedEffect& effect : result_.omitted)
            for (const FittedParameter& parameter : effect.parameters)
                if (parameter.nats_against_one_value > bearable)
                    result_.remains.push_back(
                        fmt::format("{} of {} would have to be another in each recording ({:.0f} nats): another "
                                    "physics imitates it, or something of it has no name here",
                                    parameter.name, effect.instance.effect, parameter.nats_against_one_value));
        for (const NamedEffect& effect : result_.omitted)
            if (const std::string& open = find_effect(effect.instance.effect)->not_told; !open.empty())
                result_.remains.push_back(effect.instance.effect + ": " + open);
        if (study_.friction) result_.remains.push_back(said_of(*study_.friction));
        for (const std::string& said : said_of_friction(friction_levels(named_.fit.trial, believed_, observations_)))
            result_.remains.push_back(said);
        for (const std::string& said : wheel_unloading(named_.fit.trial, believed_, observations_))
            result_.remains.push_back(said);
    }

    const Findings& found_;
    const BelievedCase& believed_;
    const std::vector<Observation>& observations_;
    const LikelihoodContext& context_;
    const VerdictThresholds& thresholds_;
    const NamingResult& naming_;
    const PlaceStudy& study_;
    const Decision& decision_;
    const FittedSet& baseline_;          ///< what the verdict is held against: retuned on the fitted part
    const FittedSet &retuned_, &named_;  ///< on all of the recordings
    Diagnosis& result_;
};

}  // namespace

void write_up(const Findings& findings, Diagnosis& result) {
    WritingUp(findings, result).run();
}

}  // namespace railpem::diagnosis
