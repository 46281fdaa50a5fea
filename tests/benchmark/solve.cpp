// How long a frequency line takes, and against what. Ratios within one run are what counts; run with
//   build/release/tests/benchmark_solve
// items_per_second is frequency lines per second.

#include <benchmark/benchmark.h>

#include <algorithm>

#include <array>
#include <numbers>

#include "../verification/pem/every_track_effect.hpp"
#include "pem/coupling/coupled_model.hpp"
#include "pem/coupling/passing_lines.hpp"
#include "pem/coupling/solve_case.hpp"
#include "pem/coupling/track_response.hpp"
#include "pem/coupling/wheel_transfers.hpp"
#include "pem/rail/case_equilibrium.hpp"
#include "pem/response_names.hpp"
#include "track/rail/exact_rail.hpp"

namespace {

using namespace railpem;

lanes::Real lines_from(double frequency) {
    lanes::Real omega;
    for (int lane = 0; lane < lanes::width; ++lane) omega[lane] = 2.0 * std::numbers::pi * (frequency + 0.1 * lane);
    return omega;
}

pem::CaseParameters uic60() {
    pem::CaseParameters c = tests::paper_case(1);
    c.track.rail = {.beam = track::Beam::timoshenko,
                    .youngs_modulus_pa = 210e9,
                    .second_moment_of_area_m4 = 3038.3e-8,
                    .mass_kg_per_m = 60.2,
                    .loss_factor = 0.02,
                    .shear_modulus_pa = 81e9,
                    .shear_coefficient = 0.4,
                    .cross_section_m2 = 60.2 / 7850.0};
    c.track.pads = {.static_stiffness_n_per_m = 300e6, .loss_factor = 0.25, .loss_law = track::LossLaw::constant};
    c.track.support = {
        .model = track::SupportModel::two_layer, .mass_kg = 162.0, .stiffness_n_per_m = 50e6, .loss_factor = 1.0};
    return c;
}

/// Floating-point operations per node and line of track::rail_receptance, counted in its source (complex product 6, sum
/// 2, reciprocal 6). Condensation: block plus stretch 8, inverse 44, product with the stretch 56, sign 8, next block
/// 68, pad-sum load 60. Selected inversion: two products 112, sum 8, pad sum 32, columns of the points met 56 (two on
/// average).
constexpr double kFlopPerNode = 244.0 + 208.0;

/// What the core can do: independent chains of multiply-add in lanes, as the compiler writes them for everything else.
void core_peak_multiply_add(benchmark::State& state) {
    constexpr int kChains = 12, kSteps = 1000;  // more chains than latency times units
    std::array<lanes::Real, kChains> x;
    for (int c = 0; c < kChains; ++c) x[static_cast<std::size_t>(c)] = lanes::broadcast(1.0 + c);
    lanes::Real factor = lanes::broadcast(0.999), summand = lanes::broadcast(1e-3);
    benchmark::DoNotOptimize(factor);
    benchmark::DoNotOptimize(summand);
    for (auto _ : state) {
        for (int i = 0; i < kSteps; ++i)
            for (lanes::Real& value : x) value = value * factor + summand;
        benchmark::DoNotOptimize(x);
    }
    state.counters["flop_per_s"] =
        benchmark::Counter(2.0 * kChains * kSteps * lanes::width, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(core_peak_multiply_add)->Unit(benchmark::kMicrosecond);

/// One coupled line: vehicle, contact, exact rail of case 3, all responses to one source. One core.
void coupled_line_exact(benchmark::State& state) {
    const pem::CoupledModel model = pem::coupled_model(tests::paper_case(3), 22.2222);
    pem::CoupledWorkspace workspace(model);
    pem::WheelVector r{lanes::Complex(1.0), lanes::Complex(0.5), lanes::Complex(0.2), lanes::Complex(0.1)};
    std::vector<lanes::Complex> response(pem::response_names().size());
    for (auto _ : state) {
        pem::responses(pem::solve_group(model, lines_from(60.0), workspace), r, response.data());
        benchmark::DoNotOptimize(response.data());
    }
    state.SetItemsProcessed(state.iterations() * lanes::width);
}
BENCHMARK(coupled_line_exact)->Unit(benchmark::kMicrosecond);

/// The rail alone: what the exact solution of case 3 costs.
void rail_receptance_exact(benchmark::State& state) {
    const pem::CaseParameters c = tests::paper_case(3);
    const auto wheels = vehicle::wheel_positions(c.vehicle);
    const track::ExactRail rail = track::exact_rail(c.track, wheels, pem::case_equilibrium(c));
    track::ExactRailWorkspace workspace(rail);
    for (auto _ : state) benchmark::DoNotOptimize(&track::rail_receptance(rail, lines_from(60.0), workspace));
    state.SetItemsProcessed(state.iterations() * lanes::width);
    const double nodes = static_cast<double>(rail.nodes.size());
    state.counters["nodes"] = nodes;
    state.counters["flop_per_s"] =
        benchmark::Counter(kFlopPerNode * nodes * lanes::width, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(rail_receptance_exact)->Unit(benchmark::kMicrosecond);

void vehicle_receptance(benchmark::State& state) {
    const vehicle::HalfVehicle car = vehicle::half_vehicle(tests::paper_case(3).vehicle);
    vehicle::Workspace workspace(car);
    for (auto _ : state) benchmark::DoNotOptimize(vehicle::wheel_receptance(car, lines_from(60.0), workspace));
    state.SetItemsProcessed(state.iterations() * lanes::width);
}
BENCHMARK(vehicle_receptance)->Unit(benchmark::kMicrosecond);

/// The baseline: the design's dense modal rail, 200 modes, 61 pads.
void coupled_line_modal_200(benchmark::State& state) {
    pem::CaseParameters c = tests::paper_case(3);
    c.solver = {.rail = pem::RailSolution::modal, .modes = 200, .pads = 61};
    const pem::CoupledModel model = pem::coupled_model(c, 22.2222);
    pem::CoupledWorkspace workspace(model);
    for (auto _ : state) benchmark::DoNotOptimize(&pem::solve_group(model, lines_from(60.0), workspace));
    state.SetItemsProcessed(state.iterations() * lanes::width);
}
BENCHMARK(coupled_line_modal_200)->Unit(benchmark::kMillisecond)->Iterations(2);

/// 2000 lines of case 1, whose pads know neither load nor frequency: no effect at all.
void case_1_all_outputs(benchmark::State& state) {
    const pem::CaseParameters c = tests::paper_case(1);
    for (auto _ : state) benchmark::DoNotOptimize(pem::solve_case(c, 22.2222, {.threads = 1}));
    state.SetItemsProcessed(state.iterations() * 1998);
}
BENCHMARK(case_1_all_outputs)->Unit(benchmark::kMillisecond);

/// Two lines of case 1: the model more than they. What scripts/benchmark_python.py calls from Python; as there, the
/// least of 2000 calls counts.
void case_1_two_lines(benchmark::State& state) {
    pem::CaseParameters c = tests::paper_case(1);
    c.frequency = {.from_hz = 22.0, .to_hz = 23.0, .step_hz = 1.0};
    for (auto _ : state) benchmark::DoNotOptimize(pem::solve_case(c, 22.2222, {.threads = 1}));
}
double least(const std::vector<double>& times) {
    return *std::min_element(times.begin(), times.end());
}

BENCHMARK(case_1_two_lines)
    ->Unit(benchmark::kMicrosecond)
    ->Iterations(1)
    ->Repetitions(2000)
    ->ComputeStatistics("least", least)
    ->ReportAggregatesOnly();

/// 2000 lines of case 3, all responses, static equilibrium included; threads as argument.
void case_3_all_outputs(benchmark::State& state) {
    const pem::CaseParameters c = tests::paper_case(3);
    for (auto _ : state)
        benchmark::DoNotOptimize(pem::solve_case(c, 22.2222, {.threads = static_cast<int>(state.range(0))}));
    state.SetItemsProcessed(state.iterations() * 1998);
}
BENCHMARK(case_3_all_outputs)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Case 3, whose pads stiffen under load and with frequency, with all other effects of the catalogue whose place is
/// rail, pad or support, and the irregularities that make lines.
pem::CaseParameters every_effect_of_track_and_surface() {
    pem::CaseParameters c = tests::every_track_effect();
    c.irregularity.corrugation = {{.wavelength_m = 0.3, .relative_bandwidth = 0.1, .rms_m = 20e-6}};
    c.irregularity.joints = {{.spacing_m = 12.0, .depth_m = 1e-3, .length_m = 0.5}};
    return c;
}

/// The same 2000 lines with every effect of the track: to be compared with case_1_all_outputs, which has none, and
/// case_3_all_outputs/1. Argument 0: every 8th fastener has failed; 1: one in eight, drawn.
void case_3_every_track_effect(benchmark::State& state) {
    pem::CaseParameters c = every_effect_of_track_and_surface();
    if (state.range(0) != 0) c.track.failed_fasteners = {{.fraction = 0.125}};
    for (auto _ : state) benchmark::DoNotOptimize(pem::solve_case(c, 22.2222, {.threads = 1}));
    state.SetItemsProcessed(state.iterations() * 1998);
}
BENCHMARK(case_3_every_track_effect)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// The lines of sleeper passing of case 1; with regular failures in case 3; of case 1 with pads that load stiffens.
void passing_lines(benchmark::State& state) {
    pem::CaseParameters c = tests::paper_case(1);
    c.sleeper_passing.amplitude_factor = 1.0;
    if (state.range(0) == 1) c = every_effect_of_track_and_surface();
    if (state.range(0) == 2) c.track.pads.preload_strength = 1.0;
    const std::vector<double> wheels = vehicle::wheel_positions(c.vehicle);
    for (auto _ : state) benchmark::DoNotOptimize(pem::passing_lines(c, wheels, 22.2222));
}
BENCHMARK(passing_lines)->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

/// What the diagnosis evaluates: the transfers of 350 lines, wheels at rest or in motion; model included.
void wheel_transfers_350(benchmark::State& state) {
    pem::CaseParameters c = tests::paper_case(static_cast<int>(state.range(0)));
    c.solver.moving = state.range(1) != 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(
            pem::wheel_transfers(pem::coupled_model(c, 22.2222), 0.5, 0.5, 350, {0, 1, 2, 3, 4, 5, 6, 7, 8}, 1));
    state.SetItemsProcessed(state.iterations() * 350);
}
BENCHMARK(wheel_transfers_350)->Args({1, 0})->Args({1, 1})->Args({3, 0})->Args({3, 1})->Unit(benchmark::kMillisecond);

/// The same lines of wheels in motion on case 1, all fasteners sound (0) and every 8th failed (1): 3 and 24 positions
/// of the wheels.
void moving_failed_350(benchmark::State& state) {
    pem::CaseParameters c = tests::paper_case(1);
    c.solver.moving = true;
    if (state.range(0) != 0) c.track.failed_fasteners = {{.every = 8}};
    for (auto _ : state)
        benchmark::DoNotOptimize(
            pem::wheel_transfers(pem::coupled_model(c, 22.2222), 0.5, 0.5, 350, {0, 1, 2, 3, 4, 5, 6, 7, 8}, 1));
    state.SetItemsProcessed(state.iterations() * 350);
}
BENCHMARK(moving_failed_350)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// UIC60 on ballast: receptance over a pad and mid-bay, 1500 lines 20–3000 Hz.
void receptance_uic60(benchmark::State& state) {
    const pem::CaseParameters c = uic60();
    const std::vector<double> lines = pem::geometric_lines(20.0, 3000.0, 1500);
    for (auto _ : state) benchmark::DoNotOptimize(pem::track_response(c, lines, state.range(0) != 0));
    state.SetItemsProcessed(state.iterations() * 1500);
}
BENCHMARK(receptance_uic60)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
