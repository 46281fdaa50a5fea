// Forces inside the suspension: a slightly stiffer element is the old one with a force of the difference across it.

#include "pem/coupling/inner_transfers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "pem/coupling/wheel_transfers.hpp"
#include "pem/response_names.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::pem {
namespace {

constexpr double kFrom = 2.0, kStep = 1.5;
constexpr std::size_t kLines = 60;
constexpr double kSpeed = 22.0;

struct Stage {
    const char* name;
    vehicle::Law law;
    vehicle::SuspensionParameters& (*of)(CaseParameters&);
};

/// What each element of a stage elongates by per unit irregularity under each wheel, [element][wheel].
std::vector<std::array<std::complex<double>, 4>> elongations(const CoupledModel& model, vehicle::Law law,
                                                             double omega) {
    CoupledWorkspace workspace(model);
    const GroupSolution& solution = solve_group(model, lanes::broadcast(omega), workspace);
    std::vector<std::array<std::complex<double>, 4>> list(law == vehicle::Law::primary ? 4 : 2);
    for (std::size_t e = 0; e < list.size(); ++e)
        for (std::size_t wheel = 0; wheel < 4; ++wheel)
            for (std::size_t j = 0; j < 4; ++j)
                list[e][wheel] +=
                    (law == vehicle::Law::primary ? solution.car.primary[e][j] : solution.car.secondary[e][j])[0] *
                    solution.forces[j][wheel][0];
    return list;
}

/// The same of the secondary stage, from the motions at its ends.
TEST(InnerTransfer, AnElongationIsTheDifferenceOfItsEnds) {
    const CoupledModel model = coupled_model(tests::paper_case(1), kSpeed);
    std::vector<std::size_t> all;
    for (std::size_t r = 0; r < response_names().size(); ++r) all.push_back(r);
    const WheelTransfers transfers = wheel_transfers(model, kFrom, kStep, 4, all, 1);
    const double omega = 2.0 * std::numbers::pi * kFrom;
    const auto found = elongations(model, vehicle::Law::secondary, omega);
    const std::pair<const char*, const char*> ends[] = {{"body_front", "bogie_1"}, {"body_rear", "bogie_2"}};
    for (std::size_t e = 0; e < 2; ++e)
        for (std::size_t wheel = 0; wheel < 4; ++wheel) {
            const std::complex<double> upper =
                transfers.at(0)[response_index(ends[e].first) * 4 + wheel] / (-omega * omega);
            const std::complex<double> lower =
                transfers.at(0)[response_index(ends[e].second) * 4 + wheel] / (-omega * omega);
            EXPECT_NEAR(std::abs(found[e][wheel] - (upper - lower)), 0.0, 1e-12 * (std::abs(upper) + std::abs(lower)));
        }
}

class InnerTransferOfStage : public testing::TestWithParam<Stage> {};

TEST_P(InnerTransferOfStage, IsTheDerivativeWithTheStiffness) {
    CaseParameters parameters = tests::paper_case(1);
    std::vector<std::size_t> all;
    for (std::size_t r = 0; r < response_names().size(); ++r) all.push_back(r);
    const CoupledModel model = coupled_model(parameters, kSpeed);
    std::vector<RailGroup> rails;
    const WheelTransfers before = wheel_transfers(model, kFrom, kStep, kLines, all, 1, &rails);
    const InnerTransfers inner = inner_transfers(model, GetParam().law, kFrom, kStep, kLines, all, rails);
    const double change = 1e-5 * GetParam().of(parameters).stiffness_n_per_m;
    const auto changed = [&](double sign) {
        CaseParameters other = parameters;
        GetParam().of(other).stiffness_n_per_m += sign * change;
        return wheel_transfers(coupled_model(other, kSpeed), kFrom, kStep, kLines, all, 1, &rails);
    };
    const WheelTransfers up = changed(1.0), down = changed(-1.0);
    const std::size_t count = all.size();
    for (std::size_t line = 0; line < kLines; line += 7) {
        const double omega = 2.0 * std::numbers::pi * (kFrom + kStep * static_cast<double>(line));
        const auto elongation = elongations(model, GetParam().law, omega);
        for (std::size_t wheel = 0; wheel < 4; ++wheel)
            for (std::size_t r = 0; r < count; ++r) {
                const std::complex<double> slope =
                    (up.at(line)[r * 4 + wheel] - down.at(line)[r * 4 + wheel]) / (2.0 * change);
                std::complex<double> by_forces;
                double size = 0.0;
                for (std::size_t e = 0; e < inner.elements; ++e) {
                    const std::complex<double> u = elongation[e][wheel];
                    by_forces -= inner.at(line)[r * inner.elements + e] * u;
                    size += std::abs(inner.at(line)[r * inner.elements + e] * u);
                }
                EXPECT_NEAR(std::abs(slope - by_forces), 0.0, 1e-6 * size)
                    << GetParam().name << line << response_names()[r].where;
            }
    }
}

// A slightly stiffer stage is the old one with forces of the difference in its elements, whose velocities the
// mobilities then tell.
TEST_P(InnerTransferOfStage, MovesTheElementsAsTheyAreMovedByTheStiffness) {
    CaseParameters parameters = tests::paper_case(1);
    const CoupledModel model = coupled_model(parameters, kSpeed);
    const std::vector<RailGroup> rails = rail_groups(model, kFrom, kStep, kLines, 1, 1);
    const ElementTransfers own = element_transfers(model, GetParam().law, kFrom, kStep, kLines, rails);
    const double change = 1e-5 * GetParam().of(parameters).stiffness_n_per_m;
    const auto changed = [&](double sign) {
        CaseParameters other = parameters;
        GetParam().of(other).stiffness_n_per_m += sign * change;
        return coupled_model(other, kSpeed);
    };
    const CoupledModel up = changed(1.0), down = changed(-1.0);
    for (std::size_t line = 0; line < kLines; line += 7) {
        const std::complex<double> s(0.0, 2.0 * std::numbers::pi * (kFrom + kStep * static_cast<double>(line)));
        const auto before = elongations(model, GetParam().law, s.imag()),
                   more = elongations(up, GetParam().law, s.imag()), less = elongations(down, GetParam().law, s.imag());
        for (std::size_t i = 0; i < before.size(); ++i)
            for (std::size_t wheel = 0; wheel < 4; ++wheel) {
                std::complex<double> by_forces;
                for (std::size_t e = 0; e < before.size(); ++e)
                    by_forces -= own.mobility[(line * before.size() + i) * before.size() + e] * before[e][wheel];
                const std::complex<double> slope = s * (more[i][wheel] - less[i][wheel]) / (2.0 * change),
                                           velocity = own.by_wheel[(line * before.size() + i) * 4 + wheel];
                EXPECT_NEAR(std::abs(velocity - s * before[i][wheel]), 0.0, 1e-9 * std::abs(velocity));
                EXPECT_NEAR(std::abs(slope - by_forces), 0.0, 1e-5 * std::abs(by_forces)) << GetParam().name << line;
            }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Stages, InnerTransferOfStage,
    testing::Values(Stage{"secondary", vehicle::Law::secondary,
                          [](CaseParameters& c) -> vehicle::SuspensionParameters& { return c.vehicle.secondary; }},
                    Stage{"primary", vehicle::Law::primary,
                          [](CaseParameters& c) -> vehicle::SuspensionParameters& { return c.vehicle.primary; }}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace railpem::pem
