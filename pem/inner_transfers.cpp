#include "pem/inner_transfers.hpp"

#include <algorithm>
#include <cassert>

#include "pem/solution.hpp"

namespace railpem::pem {

InnerTransfers inner_transfers(const CoupledModel& model, vehicle::Law law, double from_hz, double step_hz, std::size_t lines,
                               const std::vector<std::size_t>& kept, const std::vector<RailGroup>& rails) {
    assert(law == vehicle::Law::primary || law == vehicle::Law::secondary);
    const std::size_t elements = law == vehicle::Law::primary ? 4 : 2;
    InnerTransfers result{.from_hz = from_hz, .step_hz = step_hz, .lines = lines, .responses = kept.size(), .elements = elements, .values = {}};
    result.values.resize(lines * kept.size() * elements);
    CoupledWorkspace workspace(model);
    std::vector<lanes::Complex> all(response_names().size());
    for (std::size_t group = 0; group < rails.size(); ++group) {
        const GroupSolution& solution = solve_group(model, rails[group], workspace);
        for (std::size_t e = 0; e < elements; ++e) {
            const auto moved = vehicle::element_receptance(model.car, law, static_cast<int>(e), workspace.car);
            WheelVector away;
            for (std::size_t wheel = 0; wheel < 4; ++wheel) away[wheel] = -moved[static_cast<std::size_t>(vehicle::Place::wheel_1) + wheel];
            responses(solution, away, all.data());
            for (std::size_t place = 0; place < moved.size(); ++place) all[place] += moved[place] * (-solution.omega * solution.omega);
            for (std::size_t lane = 0; lane < lanes::width && group * lanes::width + lane < lines; ++lane)
                for (std::size_t r = 0; r < kept.size(); ++r)
                    result.values[((group * lanes::width + lane) * kept.size() + r) * elements + e] = all[kept[r]][static_cast<int>(lane)];
        }
    }
    return result;
}

}  // namespace railpem::pem
