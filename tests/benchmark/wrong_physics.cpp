// What wrong physics of equal freedom gains on data that no fit has seen. One CSV row per effect that is hidden:
//   wrong_physics CASE SECONDS SEED [EFFECT...]
// Three runs with nine channels are drawn from the case with the effect at its typical strength and with its numbers
// off as they are believed. The right effect and the eight others of at most as many parameters that promise most are
// fitted to three quarters, each to its end and without a rival (not what retuning moves, the level of the irregularity
// and the passing of supports), from where screening leads, and bluntly at first where that does not reach the retuned
// case. Gains are nats of log-likelihood over the retuned case on the last quarter.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>

#include "app/schema/believed_case.hpp"
#include "app/schema/case_file.hpp"
#include "diagnosis/hypotheses/best_start.hpp"
#include "diagnosis/hypotheses/screen.hpp"
#include "tests/benchmark/typical_effects.hpp"

namespace {

using namespace railpem;

constexpr std::size_t kMostWrong = 8;  ///< a minute of one core for each effect that is hidden
constexpr int kStageIterations = 6;    ///< from afar; the search takes four, but nothing has to be quick here

std::size_t freedom(const diagnosis::EffectInstance& instance) {
    return diagnosis::effect_unknowns(instance, 0).size();
}

class Comparing {
  public:
    Comparing(const diagnosis::BelievedCase& believed, std::vector<diagnosis::Observation> shapes)
        : believed_(believed), shapes_(std::move(shapes)) {}

    void row(const diagnosis::Candidate& hidden, std::uint64_t seed) {
        draw(hidden, seed);
        retuned_ = diagnosis::fit_set(believed_, {}, {}, {}, {}, context(), {});
        const diagnosis::FittedSet right = diagnosis::fit_set(believed_, retuned_.fit, {hidden}, {}, {}, context(), {});
        const double gain = right.held_out - retuned_.held_out;
        std::string best = "nothing";
        double most = 0.0;
        const std::map<std::string, double> wrong = wrong_gains(hidden);
        for (const auto& [effect, own] : wrong)
            if (own > most) best = effect, most = own;
        std::printf("%s,%llu,%.4g,%s,%.4g,%.4f,%zu\n", hidden.instance.effect.c_str(),
                    static_cast<unsigned long long>(seed), gain, best.c_str(), most, most / gain, wrong.size());
        std::fflush(stdout);
    }

  private:
    diagnosis::LikelihoodContext context() const {
        return {.believed = &believed_,
                .observations = &observations_,
                .part = diagnosis::Part::fitted,
                .least_floor = 0.0,
                .threads = 0};
    }

    void draw(const diagnosis::Candidate& hidden, std::uint64_t seed) {
        diagnosis::Trial truth = diagnosis::believed_trial(believed_, shapes_);
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        for (const diagnosis::Unknown& unknown : diagnosis::nuisance_unknowns(believed_, shapes_))
            if (unknown.kind == diagnosis::UnknownKind::number) unknown.set(truth, unknown.deviation * normal(random));
        truth.effects.push_back(hidden.instance);
        observations_.clear();
        for (std::size_t o = 0; o < shapes_.size(); ++o)
            observations_.push_back(diagnosis::synthesise(shapes_[o], o, truth, believed_, seed));
    }

    /// By effect, of its variant that promises most.
    std::map<std::string, double> wrong_gains(const diagnosis::Candidate& hidden) {
        std::map<std::string, double> gains;
        const std::vector<diagnosis::Candidate> all =
            diagnosis::candidates(believed_, retuned_.fit.trial, observations_).candidates;
        for (const diagnosis::Promise& promise : diagnosis::screen(retuned_.fit, all, context())) {
            if (gains.size() == kMostWrong) break;
            const diagnosis::EffectInstance& instance = all[promise.candidate].instance;
            if (instance.effect == hidden.instance.effect || freedom(instance) > freedom(hidden.instance) ||
                gains.count(instance.effect))
                continue;
            diagnosis::Started start =
                diagnosis::best_start(believed_, retuned_.fit, {promise}, all, {}, {}, context());
            gains[instance.effect] = fitted(start).held_out - retuned_.held_out;
            std::fprintf(stderr, "  %s: %.4g\n", diagnosis::label_of(instance).c_str(), gains[instance.effect]);
        }
        return gains;
    }

    /// From near, and where that does not reach the retuned case (what replaces a law begins far below it) from afar,
    /// too.
    diagnosis::FittedSet fitted(const diagnosis::Started& start) const {
        diagnosis::FittedSet near =
            diagnosis::fit_set(believed_, start.near, {start.candidate}, {}, {}, context(), {.from_far = false});
        if (near.fit.log_posterior > retuned_.fit.log_posterior) return near;
        diagnosis::FittedSet far = diagnosis::fit_set(believed_, start.near, {start.candidate}, {}, {}, context(),
                                                      {.stage_iterations = kStageIterations});
        return far.fit.log_posterior > near.fit.log_posterior ? far : near;
    }

    const diagnosis::BelievedCase& believed_;
    std::vector<diagnosis::Observation> shapes_, observations_;
    diagnosis::FittedSet retuned_;
};

}  // namespace

int main(int count, char** words) {
    if (count < 4) {
        std::fprintf(stderr, "usage: %s CASE SECONDS SEED [EFFECT...]\n", words[0]);
        return 2;
    }
    const diagnosis::BelievedCase believed = app::believed_case(app::read_case(words[1], {}));
    const std::vector<diagnosis::Observation> shapes =
        tests::nine_channel_shapes(believed, {15.0, 22.2222, 33.0}, std::atof(words[2]));
    const std::vector<std::string> wanted(words + 4, words + count);
    Comparing comparing(believed, shapes);
    std::printf("hidden,seed,right_nats,wrong_of_equal_freedom,wrong_nats,share,effects_fitted\n");
    for (const diagnosis::Candidate& hidden : tests::typical_effects(believed, shapes))
        if (!diagnosis::find_effect(hidden.instance.effect)->retuned &&
            (wanted.empty() || std::find(wanted.begin(), wanted.end(), hidden.instance.effect) != wanted.end()))
            comparing.row(hidden, static_cast<std::uint64_t>(std::atoll(words[3])));
    return 0;
}
