// How long the believed case takes to be retuned on three records of 60 s with nine channels, beside one prediction of
// them. Run with
//   build/release/tests/benchmark_retune
// Retuning may take 5 s on two threads. `predictions` is the ratio: what a retuning costs in predictions of the same
// run.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <chrono>
#include <string>
#include <vector>

#include "app/schema/believed_case.hpp"
#include "app/schema/case_file.hpp"
#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/synthesis.hpp"

namespace {

using namespace railpem;

struct Records {
    diagnosis::BelievedCase believed =
        app::believed_case(app::read_case(RAILPEM_SOURCE_DIR "/cases/wei2016/case1.toml", {}));
    std::vector<diagnosis::Observation> observations;

    /// Drawn from a case with a primary suspension that is stiffer by a tolerance.
    Records() {
        const std::vector<std::string> channels = {"body_front", "body",    "body_rear", "bogie_1", "bogie_2",
                                                   "wheel_1",    "wheel_2", "wheel_3",   "wheel_4"};
        std::vector<diagnosis::Observation> shapes;
        for (const double speed : {15.0, 22.2222, 33.0})
            shapes.push_back(diagnosis::observation_shape(speed, 0.0, 60.0, channels, believed.numbers, {}));
        diagnosis::Trial truth = diagnosis::believed_trial(believed, shapes);
        believed.access.set(truth.numbers, "vehicle.primary.stiffness_n_per_m",
                            1.1 * believed.numbers.vehicle.primary.stiffness_n_per_m);
        for (std::size_t o = 0; o < shapes.size(); ++o)
            observations.push_back(diagnosis::synthesise(shapes[o], o, truth, believed, 1));
    }
};

const Records& records() {
    static const Records made;
    return made;
}

diagnosis::LikelihoodContext context_of(int threads) {
    return {.believed = &records().believed,
            .observations = &records().observations,
            .part = diagnosis::Part::fitted,
            .least_floor = 0.0,
            .threads = threads};
}

double seconds_of_prediction(const diagnosis::LikelihoodContext& context) {
    const auto begin = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(
        diagnosis::predict(diagnosis::believed_trial(*context.believed, *context.observations), context));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void retune(benchmark::State& state) {
    const diagnosis::LikelihoodContext context = context_of(static_cast<int>(state.range(0)));
    const std::vector<diagnosis::Unknown> unknowns =
        diagnosis::nuisance_unknowns(*context.believed, *context.observations);
    const diagnosis::Trial base = diagnosis::believed_trial(*context.believed, *context.observations);
    double predicting = 0.0, retuning = 0.0;
    int steps = 0;
    for (auto _ : state) {
        predicting += seconds_of_prediction(context);
        const auto begin = std::chrono::steady_clock::now();
        steps = diagnosis::fit(base, unknowns, diagnosis::means(unknowns), context).iterations;
        retuning += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    state.counters["steps"] = steps;
    state.counters["unknowns"] = static_cast<double>(unknowns.size());
    state.counters["predictions"] = retuning / predicting;
    state.counters["peak_mb"] = static_cast<double>(used.ru_maxrss) / 1024.0;
}

BENCHMARK(retune)->Arg(1)->Arg(2)->ArgName("threads")->Unit(benchmark::kSecond)->UseRealTime()->MeasureProcessCPUTime();

}  // namespace

BENCHMARK_MAIN();
