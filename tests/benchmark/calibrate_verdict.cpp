// What diagnose() says of recordings in which nothing is missing. One CSV row per synthesised null:
//   calibrate_verdict CASE FIRST_SEED COUNT SECONDS PAYLOAD_KG SPEED_M_PER_S...
// Rows come as they are done and depend on their seed only, so that ranges of seeds can be run apart, stopped and continued.
// Truths are drawn as the beliefs of the fit have them: numbers, irregularity, speeds and widths of lines Gaussian (a tolerance is a standard deviation), within what
// a case may state.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>

#include "app/diagnosis_inputs.hpp"
#include "app/case_schema.hpp"
#include "diagnosis/diagnose.hpp"
#include "diagnosis/synthesis.hpp"

namespace {

using namespace railpem;

struct Truth {
    diagnosis::Trial trial;
    std::map<std::string, double> factors;  ///< of the believed numbers, by key
};

Truth truth_of(const diagnosis::BelievedCase& believed, const std::vector<diagnosis::Observation>& shapes, std::mt19937_64& random) {
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

void one(const diagnosis::BelievedCase& believed, const std::vector<diagnosis::Observation>& shapes, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const Truth truth = truth_of(believed, shapes, random);
    std::vector<diagnosis::Observation> drawn;
    for (std::size_t o = 0; o < shapes.size(); ++o) drawn.push_back(diagnosis::synthesise(shapes[o], o, truth.trial, believed, seed));
    const diagnosis::Diagnosis result = diagnosis::diagnose(believed, drawn, {});
    std::string named;
    for (const diagnosis::NamedEffect& effect : result.omitted) named += (named.empty() ? "" : "+") + effect.instance.effect;
    long covered = 0;
    for (const diagnosis::RetunedNumber& number : result.numbers) {
        const double value = number.believed * truth.factors.at(number.key);
        covered += number.low <= value && value <= number.high;
    }
    std::printf("%llu,%s,%s,%.3f,%.3f,%.3f,%ld,%zu,%.1f\n", static_cast<unsigned long long>(seed), diagnosis::verdict_name(result.verdict).c_str(),
                named.c_str(), result.margins.score, result.margins.held_out, result.margins.place, covered, result.numbers.size(), result.seconds_taken);
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
    if (count < 7) {
        std::fprintf(stderr, "usage: %s CASE FIRST_SEED COUNT SECONDS PAYLOAD_KG SPEED_M_PER_S...\n", words[0]);
        return 2;
    }
    const diagnosis::BelievedCase believed = app::believed_case(app::read_case(words[1], {}));
    const std::uint64_t first = std::strtoull(words[2], nullptr, 10), nulls = std::strtoull(words[3], nullptr, 10);
    std::vector<diagnosis::Observation> shapes;
    for (int i = 6; i < count; ++i) {
        const std::vector<std::string> channels = {"body_front", "body", "body_rear", "bogie_1", "bogie_2", "wheel_1", "wheel_2", "wheel_3", "wheel_4"};
        shapes.push_back(diagnosis::observation_shape(std::atof(words[i]), std::atof(words[5]), std::atof(words[4]), channels, believed.numbers, {}));
        shapes.back().name = std::string("at ") + words[i];
    }
    std::printf("seed,verdict,named,best_score_gain_nats,held_out_gain_nats,best_free_correction_nats,numbers_in_90_percent,numbers,seconds\n");
    for (std::uint64_t seed = first; seed < first + nulls; ++seed) one(believed, shapes, seed);
    return 0;
}
