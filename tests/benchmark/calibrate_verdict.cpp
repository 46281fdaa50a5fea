// What diagnose() says of recordings in which nothing is missing. One CSV row per synthesised null:
//   calibrate_verdict CASE FIRST_SEED COUNT SECONDS PAYLOAD_KG SPEED_M_PER_S...
//   calibrate_verdict --numbers CASE ...    retuned only, without a search: for the intervals of the numbers
// Rows come as they are done and depend on their seed only, so that ranges of seeds can be run apart, stopped and
// continued. Truths are drawn as the beliefs of the fit have them: numbers, irregularity, speeds and widths of lines
// Gaussian (a tolerance is a standard deviation), within what a case may state.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>

#include "app/schema/believed_case.hpp"
#include "app/schema/case_file.hpp"
#include "diagnosis/diagnose.hpp"
#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/interval.hpp"
#include "diagnosis/fit/synthesis.hpp"

namespace {

using namespace railpem;

struct Truth {
    diagnosis::Trial trial;
    std::map<std::string, double> factors;  ///< of the believed numbers, by key
};

Truth truth_of(const diagnosis::BelievedCase& believed, const std::vector<diagnosis::Observation>& shapes,
               std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    Truth truth{.trial = diagnosis::believed_trial(believed, shapes)};
    for (const diagnosis::Unknown& unknown : diagnosis::nuisance_unknowns(believed, shapes)) {
        if (unknown.kind == diagnosis::UnknownKind::floor || unknown.kind == diagnosis::UnknownKind::noise) continue;
        const double x = std::clamp(unknown.mean + unknown.deviation * normal(random), unknown.low, unknown.high);
        unknown.set(truth.trial, x);
        if (unknown.kind == diagnosis::UnknownKind::number) truth.factors[unknown.name] = std::exp(x);
    }
    return truth;
}

struct Drawn {
    Truth truth;
    std::vector<diagnosis::Observation> observations;
};

Drawn draw(const diagnosis::BelievedCase& believed, const std::vector<diagnosis::Observation>& shapes,
           std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Drawn drawn{.truth = truth_of(believed, shapes, random), .observations = {}};
    for (std::size_t o = 0; o < shapes.size(); ++o)
        drawn.observations.push_back(diagnosis::synthesise(shapes[o], o, drawn.truth.trial, believed, seed));
    return drawn;
}

/// What diagnose() does for the numbers of a case to which it adds nothing: retuned on the fitted part, then on
/// everything.
void numbers_of(const diagnosis::BelievedCase& believed, const std::vector<diagnosis::Observation>& shapes,
                std::uint64_t seed) {
    const auto [truth, observations] = draw(believed, shapes, seed);
    diagnosis::LikelihoodContext context{.believed = &believed,
                                         .observations = &observations,
                                         .part = diagnosis::Part::fitted,
                                         .least_floor = 0.0,
                                         .threads = 0};
    const std::vector<diagnosis::Unknown> unknowns = diagnosis::nuisance_unknowns(believed, observations);
    const diagnosis::Trial base = diagnosis::believed_trial(believed, observations);
    const diagnosis::Fit near = diagnosis::fit(base, unknowns, diagnosis::means(unknowns), context);
    context.part = diagnosis::Part::all;
    const diagnosis::Fit fit = diagnosis::fit(base, unknowns, near.values, context, {.from_far = false});
    long covered = 0, numbers = 0;
    for (std::size_t u = 0; u < unknowns.size(); ++u) {
        if (unknowns[u].kind != diagnosis::UnknownKind::number) continue;
        ++numbers;
        covered += std::abs(fit.values[u] - std::log(truth.factors.at(unknowns[u].name))) <=
                   diagnosis::kNinety * fit.deviation(u);
    }
    std::printf("%llu,%ld,%ld\n", static_cast<unsigned long long>(seed), covered, numbers);
    std::fflush(stdout);
}

void one(const diagnosis::BelievedCase& believed, const std::vector<diagnosis::Observation>& shapes,
         std::uint64_t seed) {
    const auto [truth, observations] = draw(believed, shapes, seed);
    const diagnosis::Diagnosis result = diagnosis::diagnose(believed, observations, {});
    std::string named;
    for (const diagnosis::NamedEffect& effect : result.omitted)
        named += (named.empty() ? "" : "+") + effect.instance.effect;
    long covered = 0;
    for (const diagnosis::RetunedNumber& number : result.numbers) {
        const double value = number.believed * truth.factors.at(number.key);
        covered += number.low <= value && value <= number.high;
    }
    std::printf("%llu,%s,%s,%.3f,%.3f,%.3f,%ld,%zu,%.1f\n", static_cast<unsigned long long>(seed),
                diagnosis::verdict_name(result.verdict).c_str(), named.c_str(), result.margins.score,
                result.margins.held_out, result.margins.place, covered, result.numbers.size(), result.seconds_taken);
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
    const bool numbers_only = count > 1 && std::string(words[1]) == "--numbers";
    if (numbers_only) --count, ++words;
    if (count < 7) {
        std::fprintf(
            stderr, "usage: calibrate_verdict [--numbers] CASE FIRST_SEED COUNT SECONDS PAYLOAD_KG SPEED_M_PER_S...\n");
        return 2;
    }
    const diagnosis::BelievedCase believed = app::believed_case(app::read_case(words[1], {}));
    const std::uint64_t first = std::strtoull(words[2], nullptr, 10), nulls = std::strtoull(words[3], nullptr, 10);
    std::vector<diagnosis::Observation> shapes;
    for (int i = 6; i < count; ++i) {
        const std::vector<std::string> channels = {"body_front", "body",    "body_rear", "bogie_1", "bogie_2",
                                                   "wheel_1",    "wheel_2", "wheel_3",   "wheel_4"};
        shapes.push_back(diagnosis::observation_shape(std::atof(words[i]), std::atof(words[5]), std::atof(words[4]),
                                                      channels, believed.numbers, {}));
        shapes.back().name = std::string("at ") + words[i];
    }
    if (numbers_only) {
        std::printf("seed,numbers_in_90_percent,numbers\n");
        for (std::uint64_t seed = first; seed < first + nulls; ++seed) numbers_of(believed, shapes, seed);
        return 0;
    }
    std::printf(
        "seed,verdict,named,best_score_gain_nats,held_out_gain_nats,best_free_correction_nats,numbers_in_90_percent,"
        "numbers,seconds\n");
    for (std::uint64_t seed = first; seed < first + nulls; ++seed) one(believed, shapes, seed);
    return 0;
}
