// Forces inside the suspension: a slightly stiffer element is the old one with a force of the difference across it.

#include "pem/inner_transfers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pem/solution.hpp"
#include "pem/wheel_transfers.hpp"
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
    std::vector<std::pair<const char*, const char*>> elongation;  ///< upper and lower response of each element
};

class InnerTransfer : public testing::TestWithParam<Stage> {};

TEST_P(InnerTransfer, IsTheDerivativeWithTheStiffness) {
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
        for (std::size_t wheel = 0; wheel < 4; ++wheel)
            for (std::size_t r = 0; r < count; ++r) {
                const std::complex<double> slope = (up.at(line)[r * 4 + wheel] - down.at(line)[r * 4 + wheel]) / (2.0 * change);
                std::complex<double> by_forces;
                double size = 0.0;
                for (std::size_t e = 0; e < inner.elements; ++e) {
                    const auto& [upper, lower] = GetParam().elongation[e];
                    std::complex<double> u = before.at(line)[response_index(upper) * 4 + wheel] - before.at(line)[response_index(lower) * 4 + wheel];
                    u /= -omega * omega;
                    by_forces -= inner.at(line)[r * inner.elements + e] * u;
                    size += std::abs(inner.at(line)[r * inner.elements + e] * u);
                }
                EXPECT_NEAR(std::abs(slope - by_forces), 0.0, 1e-6 * size) << GetParam().name << line << response_names()[r].where;
            }
    }
}

INSTANTIATE_TEST_SUITE_P(Stages, InnerTransfer,
                         testing::Values(Stage{"secondary", vehicle::Law::secondary, [](CaseParameters& c) -> vehicle::SuspensionParameters& { return c.vehicle.secondary; },
                                               {{"body_front", "bogie_1"}, {"body_rear", "bogie_2"}}}),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace railpem::pem
