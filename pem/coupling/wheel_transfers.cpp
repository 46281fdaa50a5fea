#include "pem/coupling/wheel_transfers.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

#include "pem/lagrange.hpp"
#include "pem/response_names.hpp"
#include "pem/threads.hpp"

namespace railpem::pem {

namespace {

lanes::Real omega_of(double from_hz, double step_hz, std::size_t first, std::size_t lines) {
    lanes::Real omega;
    for (int lane = 0; lane < lanes::width; ++lane)
        omega[lane] =
            2.0 * std::numbers::pi *
            (from_hz + static_cast<double>(std::min(first + static_cast<std::size_t>(lane), lines - 1)) * step_hz);
    return omega;
}

std::vector<RailGroup> solved_rails(const CoupledModel& model, double from_hz, double step_hz, std::size_t lines,
                                    int threads) {
    std::vector<RailGroup> rails((lines + lanes::width - 1) / lanes::width);
    TeamFailure failure;
#pragma omp parallel num_threads(thread_count(threads))
    {
        std::optional<CoupledWorkspace> workspace;
        failure.guard([&] { workspace.emplace(model); });
#pragma omp for schedule(dynamic, 4)
        for (std::size_t group = 0; group < rails.size(); ++group)
            failure.guard([&] {
                rails[group] = rail_group(omega_of(from_hz, step_hz, group * lanes::width, lines), *workspace);
            });
    }
    failure.rethrow();
    return rails;
}

/// Adds weight × line `from` of the coarse rails to lane `lane` of a group.
void add_line(const std::vector<RailGroup>& coarse, std::size_t from, double weight, int lane, RailGroup& group) {
    const RailGroup& source = coarse[from / lanes::width];
    const int at = static_cast<int>(from % lanes::width);
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j)
            group.rail[i][j].set(lane, group.rail[i][j][lane] + weight * source.rail[i][j][at]);
        group.trackbed[i].set(lane, group.trackbed[i][lane] + weight * source.trackbed[i][at]);
    }
}

}  // namespace

std::vector<RailGroup> rail_groups(const CoupledModel& model, double from_hz, double step_hz, std::size_t lines,
                                   int every, int threads) {
    const std::size_t coarse_lines =
        (lines + static_cast<std::size_t>(every) - 2) / static_cast<std::size_t>(every) + 1;
    if (every <= 1 || coarse_lines < kLagrangePoints) return solved_rails(model, from_hz, step_hz, lines, threads);
    const std::vector<RailGroup> coarse = solved_rails(model, from_hz, every * step_hz, coarse_lines, threads);
    std::vector<RailGroup> rails((lines + lanes::width - 1) / lanes::width);
    for (std::size_t line = 0; line < rails.size() * lanes::width; ++line) {
        const double place = static_cast<double>(std::min(line, lines - 1)) / every;
        const long base = std::clamp(static_cast<long>(place) - kLagrangePoints / 2 + 1, 0L,
                                     static_cast<long>(coarse_lines) - kLagrangePoints);
        const std::array<double, kLagrangePoints> weight = lagrange(place - static_cast<double>(base));
        for (int i = 0; i < kLagrangePoints; ++i)
            add_line(coarse, static_cast<std::size_t>(base + i), weight[static_cast<std::size_t>(i)],
                     static_cast<int>(line % lanes::width), rails[line / lanes::width]);
    }
    for (std::size_t group = 0; group < rails.size(); ++group)
        rails[group].omega = omega_of(from_hz, step_hz, group * lanes::width, lines);
    return rails;
}

WheelTransfers wheel_transfers(const CoupledModel& model, double from_hz, double step_hz, std::size_t lines,
                               std::vector<std::size_t> responses, int threads, std::vector<RailGroup>* rails) {
    WheelTransfers transfers{
        .from_hz = from_hz, .step_hz = step_hz, .lines = lines, .responses = std::move(responses), .values = {}};
    const std::size_t kept = transfers.responses.size();
    transfers.values.resize(lines * kept * 4);
    const std::size_t groups = (lines + lanes::width - 1) / lanes::width;
    const bool known = rails && rails->size() == groups;
    if (rails && !known) rails->resize(groups);
    TeamFailure failure;
#pragma omp parallel num_threads(thread_count(threads))
    {
        std::optional<CoupledWorkspace> workspace;
        std::vector<lanes::Complex> all;
        failure.guard([&] {
            workspace.emplace(model);
            all.resize(response_names().size());
        });
#pragma omp for schedule(dynamic, 4)
        for (std::size_t group = 0; group < groups; ++group)
            failure.guard([&] {
                const std::size_t first = group * lanes::width;
                const lanes::Real omega = omega_of(from_hz, step_hz, first, lines);
                const RailGroup rail = known ? (*rails)[group] : rail_group(omega, *workspace);
                if (rails && !known) (*rails)[group] = rail;
                const GroupSolution& solution = solve_group(model, rail, *workspace);
                for (std::size_t wheel = 0; wheel < 4; ++wheel) {
                    WheelVector unit;
                    unit[wheel] = lanes::Complex(1.0);
                    pem::responses(solution, unit, all.data());
                    for (std::size_t lane = 0; lane < lanes::width && first + lane < lines; ++lane)
                        for (std::size_t r = 0; r < kept; ++r)
                            transfers.values[((first + lane) * kept + r) * 4 + wheel] =
                                all[transfers.responses[r]][static_cast<int>(lane)];
                }
            });
    }
    failure.rethrow();
    return transfers;
}

void interpolate(const WheelTransfers& transfers, double frequency_hz, std::complex<double>* result) {
    assert(transfers.lines >= 4);
    const double place = (frequency_hz - transfers.from_hz) / transfers.step_hz;
    const long base = std::clamp(static_cast<long>(std::floor(place)) - 1, 0L, static_cast<long>(transfers.lines) - 4);
    const double t = place - static_cast<double>(base);
    const std::array<double, 4> weight{-(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0, t * (t - 2.0) * (t - 3.0) / 2.0,
                                       -t * (t - 1.0) * (t - 3.0) / 2.0, t * (t - 1.0) * (t - 2.0) / 6.0};
    const std::size_t size = transfers.responses.size() * 4;
    const std::complex<double>* row = transfers.at(static_cast<std::size_t>(base));
    for (std::size_t i = 0; i < size; ++i)
        result[i] = weight[0] * row[i] + weight[1] * row[size + i] + weight[2] * row[2 * size + i] +
                    weight[3] * row[3 * size + i];
}

}  // namespace railpem::pem
