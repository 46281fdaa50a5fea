// From which strength on an effect shows, once the believed case has been retuned. One CSV row per effect and
// condition:
//   smallest_strengths CASE SECONDS [EFFECT or CONDITION...]     conditions: "one speed", "three speeds", "three speeds
//   and irregularity"
// The recordings are what the case with the effect predicts, without scatter: the log-evidence by which the effect then
// leads the retuned case is what a drawn recording gives on average. The smallest strength is where it leads by
// VerdictThresholds::least_gain. Everything that an effect has beside its strength is as the catalogue's typical
// instance, and known when its fit begins.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "app/schema/believed_case.hpp"
#include "app/schema/case_file.hpp"
#include "diagnosis/diagnose.hpp"
#include "diagnosis/hypotheses/fitted_set.hpp"
#include "spectra/irregularity_spectrum.hpp"
#include "tests/benchmark/typical_effects.hpp"

namespace {

using namespace railpem;

struct Condition {
    std::string name;
    std::vector<double> speeds_m_per_s;
    bool irregularity_measured = false;
};

const std::vector<Condition> kConditions = {{"one speed", {22.2222}},
                                            {"three speeds", {15.0, 22.2222, 33.0}},
                                            {"three speeds and irregularity", {15.0, 22.2222, 33.0}, true}};
constexpr int kMostSteps = 7;
constexpr double kNearEnough = 1.0;  // nats

/// A measured spectrum that says what is believed, at 20 values per octave.
recordings::MeasuredIrregularity measured_as_believed(const spectra::IrregularityParameters& irregularity) {
    recordings::MeasuredIrregularity measured{.file = "as believed"};
    for (double n = 0.01; n < 12.0; n *= std::exp2(0.05)) {
        const double psd = spectra::irregularity_psd_m3(irregularity, n);
        if (psd <= 0.0) continue;
        measured.cycles_per_m.push_back(n);
        measured.psd_m3.push_back(psd);
    }
    return measured;
}

/// The instance at a share of the way from nothing to its typical values.
diagnosis::EffectInstance at_share(const diagnosis::Effect& effect, diagnosis::EffectInstance instance, double share) {
    for (const diagnosis::EffectParameter& parameter : effect.parameters) {
        if (!parameter.strength || !instance.values.count(parameter.name)) continue;
        double& value = instance.values[parameter.name];
        value =
            std::isfinite(parameter.nothing) ? parameter.nothing + share * (value - parameter.nothing) : value / share;
    }
    return instance;
}

class Detecting {
  public:
    Detecting(diagnosis::BelievedCase believed, const Condition& condition, double seconds)
        : believed_(std::move(believed)) {
        if (condition.irregularity_measured)
            believed_.measured_irregularity = {measured_as_believed(believed_.numbers.irregularity)};
        observations_ = tests::nine_channel_shapes(believed_, condition.speeds_m_per_s, seconds);
    }

    std::vector<diagnosis::Candidate> typical() const { return tests::typical_effects(believed_, observations_); }

    /// Nats of log-evidence by which the effect leads the retuned case.
    double lead(diagnosis::Candidate candidate, double share) {
        candidate.instance = at_share(*diagnosis::find_effect(candidate.instance.effect), candidate.instance, share);
        diagnosis::Trial truth = diagnosis::believed_trial(believed_, observations_);
        truth.effects.push_back(candidate.instance);
        const diagnosis::LikelihoodContext context{.believed = &believed_,
                                                   .observations = &observations_,
                                                   .part = diagnosis::Part::fitted,
                                                   .least_floor = 0.0,
                                                   .threads = 0};
        expect(truth, context);
        diagnosis::Fit near;
        near.unknowns = diagnosis::nuisance_unknowns(believed_, observations_);
        near.values = diagnosis::means(near.unknowns);
        const diagnosis::FittedSet named =
            diagnosis::fit_set(believed_, near, {candidate}, {}, {}, context, {.from_far = false});
        return named.score() - retuned(candidate, share, near, context).score();
    }

  private:
    /// The case retuned to hide the candidate: from afar at first, then from where the last strength left it, moved in
    /// proportion.
    diagnosis::FittedSet retuned(const diagnosis::Candidate& candidate, double share, diagnosis::Fit near,
                                 const diagnosis::LikelihoodContext& context) {
        const std::string label = diagnosis::label_of(candidate.instance);
        const bool known = label == last_label_;
        for (std::size_t u = 0; known && u < near.values.size(); ++u)
            near.values[u] = std::clamp(near.values[u] + share / last_share_ * (last_values_[u] - near.values[u]),
                                        near.unknowns[u].low, near.unknowns[u].high);
        diagnosis::FittedSet set = diagnosis::fit_set(believed_, near, {}, {}, {}, context, {.from_far = !known});
        last_label_ = label;
        last_share_ = share;
        last_values_ = set.fit.values;
        return set;
    }

    /// Estimates that are what `truth` predicts.
    void expect(const diagnosis::Trial& truth, const diagnosis::LikelihoodContext& context) {
        diagnosis::Trial sound = truth;
        std::fill(sound.floor.begin(), sound.floor.end(), 0.0);
        const diagnosis::Predictions exact = diagnosis::predict(truth, context);
        for (std::size_t o = 0; o < observations_.size(); ++o) {
            diagnosis::MeasuredSpectra& fitted = observations_[o].fitted;
            fitted.values.clear();
            for (std::size_t bin = 0; bin < observations_[o].bins(); ++bin) {
                const Eigen::MatrixXcd model =
                    diagnosis::complete_prediction(sound, observations_[o], o, exact[o], bin);
                fitted.values.insert(fitted.values.end(), model.data(), model.data() + model.size());
            }
            diagnosis::set_log_determinants(fitted, observations_[o].channels.size(), fitted.averages);
            observations_[o].held_out.values = fitted.values;
            observations_[o].held_out.log_determinant = fitted.log_determinant;
        }
    }

    diagnosis::BelievedCase believed_;
    std::vector<diagnosis::Observation> observations_;
    std::string last_label_;
    double last_share_ = 1.0;
    std::vector<double> last_values_;
};

double largest_share(const diagnosis::Candidate& candidate) {
    double largest = 1e300;
    for (const diagnosis::EffectParameter& parameter : diagnosis::find_effect(candidate.instance.effect)->parameters)
        if (parameter.strength && candidate.instance.values.count(parameter.name)) {
            const double value = candidate.instance.values.at(parameter.name);
            largest = std::min(largest, std::isfinite(parameter.nothing)
                                            ? (parameter.high - parameter.nothing) / (value - parameter.nothing)
                                            : value / parameter.low);
        }
    return largest;
}

/// The share of the typical strength at which the effect leads by `least` nats: what freedom costs apart, the lead
/// grows with a power of the strength.
std::optional<double> smallest_share(Detecting& detecting, const diagnosis::Candidate& candidate, double at_typical,
                                     double least) {
    const double most = largest_share(candidate);
    double low = 0.0, high = -1.0, share = 1.0, lead = at_typical;
    for (int step = 0; step < kMostSteps && std::abs(lead - least) > kNearEnough; ++step) {
        (lead > least ? high : low) = share;
        if (lead <= least && share >= most) return std::nullopt;
        constexpr double kCost = 15.0;  // of its freedom: only guides the steps
        const double guess = share * std::sqrt((least + kCost) / std::max(lead + kCost, 1.0));
        const bool inside = guess > 1.05 * low && (high < 0.0 || guess < 0.95 * high);
        share = std::min(inside       ? guess
                         : high < 0.0 ? 3.0 * share
                         : low > 0.0  ? std::sqrt(low * high)
                                      : high / 5.0,
                         most);
        lead = detecting.lead(candidate, share);
    }
    return share;
}

void row(Detecting& detecting, const Condition& condition, const diagnosis::Candidate& candidate) {
    const diagnosis::Effect& effect = *diagnosis::find_effect(candidate.instance.effect);
    const double at_typical = detecting.lead(candidate, 1.0);
    const bool has_strength = std::any_of(effect.parameters.begin(), effect.parameters.end(), [&](const auto& own) {
        return own.strength && candidate.instance.values.count(own.name);
    });
    const std::optional<double> share =
        has_strength ? smallest_share(detecting, candidate, at_typical, diagnosis::VerdictThresholds{}.least_gain)
                     : std::nullopt;
    std::string smallest;
    if (share) {
        const diagnosis::EffectInstance instance = at_share(effect, candidate.instance, *share);
        for (const diagnosis::EffectParameter& parameter : effect.parameters)
            if (parameter.strength && instance.values.count(parameter.name)) {
                char text[96];
                std::snprintf(text, sizeof text, "%s%s=%.6g", smallest.empty() ? "" : " ", parameter.name.c_str(),
                              instance.values.at(parameter.name));
                smallest += text;
            }
    }
    std::string label = diagnosis::label_of(candidate.instance);
    std::printf("\"%s\",%s,%.1f,%s,%s\n", label.c_str(), condition.name.c_str(), at_typical,
                share ? std::to_string(*share).c_str() : "", smallest.c_str());
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
    if (count < 3) {
        std::fprintf(stderr, "usage: %s CASE SECONDS [EFFECT or CONDITION...]\n", words[0]);
        return 2;
    }
    const diagnosis::BelievedCase believed = app::believed_case(app::read_case(words[1], {}));
    std::vector<std::string> wanted, conditions;
    for (int i = 3; i < count; ++i)
        (std::any_of(kConditions.begin(), kConditions.end(), [&](const Condition& own) { return own.name == words[i]; })
             ? conditions
             : wanted)
            .emplace_back(words[i]);
    std::printf("effect,recordings,lead_at_typical_nats,smallest_over_typical,smallest\n");
    for (const Condition& condition : kConditions) {
        if (!conditions.empty() && std::find(conditions.begin(), conditions.end(), condition.name) == conditions.end())
            continue;
        Detecting detecting(believed, condition, std::atof(words[2]));
        for (const diagnosis::Candidate& candidate : detecting.typical())
            if (wanted.empty() || std::find(wanted.begin(), wanted.end(), candidate.instance.effect) != wanted.end())
                row(detecting, condition, candidate);
    }
    return 0;
}
