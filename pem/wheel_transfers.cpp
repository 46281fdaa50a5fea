#include "pem/wheel_transfers.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "pem/solution.hpp"

namespace railpem::pem {

WheelTransfers wheel_transfers(const CoupledModel& model, double from_hz, double step_hz, std::size_t lines, std::vector<std::size_t> responses, int threads,
                               std::vector<RailGroup>* rails) {
    WheelTransfers transfers{.from_hz = from_hz, .step_hz = step_hz, .lines = lines, .responses = std::move(responses), .values = {}};
    const std::size_t kept = transfers.responses.size();
    transfers.values.resize(lines * kept * 4);
    const std::size_t groups = (lines + lanes::width - 1) / lanes::width;
    const bool known = rails && rails->size() == groups;
    if (rails && !known) rails->resize(groups);
#pragma omp parallel num_threads(threads > 0 ? threads : omp_get_max_threads())
    {
        CoupledWorkspace workspace(model);
        std::vector<lanes::Complex> all(response_names().size());
#pragma omp for schedule(dynamic, 4)
        for (std::size_t group = 0; group < groups; ++group) {
            lanes::Real omega;
            const std::size_t first = group * lanes::width;
            for (int lane = 0; lane < lanes::width; ++lane)
                omega[lane] = 2.0 * std::numbers::pi * (from_hz + static_cast<double>(std::min(first + static_cast<std::size_t>(lane), lines - 1)) * step_hz);
            const RailGroup rail = known ? (*rails)[group] : rail_group(model, omega, workspace);
            if (rails && !known) (*rails)[group] = rail;
            const GroupSolution& solution = solve_group(model, rail, workspace);
            for (std::size_t wheel = 0; wheel < 4; ++wheel) {
                WheelVector unit;
                unit[wheel] = lanes::Complex(1.0);
                pem::responses(solution, unit, all.data());
                for (std::size_t lane = 0; lane < lanes::width && first + lane < lines; ++lane)
                    for (std::size_t r = 0; r < kept; ++r)
                        transfers.values[((first + lane) * kept + r) * 4 + wheel] = all[transfers.responses[r]][static_cast<int>(lane)];
            }
        }
    }
    return transfers;
}

void interpolate(const WheelTransfers& transfers, double frequency_hz, std::complex<double>* result) {
    assert(transfers.lines >= 4);
    const double place = (frequency_hz - transfers.from_hz) / transfers.step_hz;
    const long base = std::clamp(static_cast<long>(std::floor(place)) - 1, 0L, static_cast<long>(transfers.lines) - 4);
    const double t = place - static_cast<double>(base);
    const std::array<double, 4> weight{-(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0, t * (t - 2.0) * (t - 3.0) / 2.0, -t * (t - 1.0) * (t - 3.0) / 2.0,
                                       t * (t - 1.0) * (t - 2.0) / 6.0};
    const std::size_t size = transfers.responses.size() * 4;
    const std::complex<double>* row = transfers.at(static_cast<std::size_t>(base));
    for (std::size_t i = 0; i < size; ++i)
        result[i] = weight[0] * row[i] + weight[1] * row[size + i] + weight[2] * row[2 * size + i] + weight[3] * row[3 * size + i];
}

}  // namespace railpem::pem
