// How fast a record is made: seconds of computing per second of record, one core. Run with
//   build/release/tests/benchmark_march
// A record of 60 s may take 10 s (linear pads) and 20 s (nonlinear pads): ratios of 0.17 and 0.33.

#include <benchmark/benchmark.h>

#include "../verification/pem/paper_case.hpp"
#include "simulate/march/simulate.hpp"

namespace {

using namespace railpem;

void march(benchmark::State& state, const pem::CaseParameters& parameters) {
    simulate::Options options;
    options.seconds = 10.0;
    options.settling_s = 0.5;
    double solves = 0.0;
    for (auto _ : state) solves = simulate::simulate(parameters, options).making.solves_per_step;
    state.counters["track_solves_per_step"] = solves;
    state.counters["record_s_per_s"] =
        benchmark::Counter(10.5 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

pem::CaseParameters causal(int number) {
    auto c = tests::paper_case(number);
    c.track.pads.causal = true;
    return c;
}

pem::CaseParameters two_layers() {
    auto c = causal(2);
    c.track.support = {
        .model = track::SupportModel::two_layer, .mass_kg = 150, .stiffness_n_per_m = 8e7, .damping_n_s_per_m = 8e4};
    return c;
}

BENCHMARK_CAPTURE(march, case1_dashpots, tests::paper_case(1))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(march, case2_relaxing_pads, causal(2))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(march, case3_nonlinear_pads, causal(3))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(march, two_layer_support, two_layers())->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
