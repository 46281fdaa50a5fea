// Corrections of contact and sensors, and all of them in a whole case.

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "pem/contact.hpp"
#include "pem/coupling/coupled_model.hpp"
#include "pem/coupling/sensor_chain.hpp"
#include "pem/response_names.hpp"
#include "tests/unit/lanes/in_turn.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::pem {
namespace {

using Complex = std::complex<double>;
const lanes::Real omega = lanes::tests::in_turn({6.0, 60.0, 360.0, 1200.0});

lanes::FactorCurve constant(Complex value) {
    return {.frequency_hz = {30.0}, .value = {value}};
}

/// Responses to a unit irregularity under each wheel.
std::vector<Complex> responses_of(const CaseParameters& parameters) {
    const CoupledModel model = coupled_model(parameters, tests::kPaperSpeed);
    CoupledWorkspace work(model);
    const GroupSolution& solution = solve_group(model, omega, work);
    std::vector<Complex> values;
    for (std::size_t wheel = 0; wheel < 4; ++wheel) {
        WheelVector unit;
        unit[wheel] = lanes::Complex(1.0);
        std::vector<lanes::Complex> all(response_names().size());
        responses(solution, unit, all.data());
        for (const lanes::Complex& value : all)
            for (int lane = 0; lane < lanes::width; ++lane) values.push_back(value[lane]);
    }
    return values;
}

CaseParameters exact_case() {
    return tests::paper_case(2);
}

CaseParameters modal_case() {
    CaseParameters c = tests::paper_case(2);
    c.solver = {.rail = RailSolution::modal, .modes = 60, .pads = 45};
    return c;
}

CaseParameters moving_case() {
    CaseParameters c = tests::paper_case(2);
    c.solver.moving = true;
    return c;
}

struct Correction {
    const char* name;
    std::function<void(CaseParameters&)> correct, reference;
};

class CaseCorrection : public testing::TestWithParam<Correction> {};

TEST_P(CaseCorrection, EqualsTheScaledParameter) {
    for (const auto make : {exact_case, modal_case, moving_case}) {
        const CaseParameters plain = make();
        CaseParameters corrected = make(), scaled = make();
        GetParam().correct(corrected);
        GetParam().reference(scaled);
        const std::vector<Complex> found = responses_of(corrected), expected = responses_of(scaled),
                                   before = responses_of(plain);
        // Rounding times the condition of the modal stiffness, 1e5.
        const double tolerance = make == modal_case ? 1e-10 : 1e-12;
        double change = 0.0;
        // Against the strongest of the four wheels: what hardly arrives from a far wheel is a difference of large
        // numbers.
        const std::size_t period = found.size() / 4;
        for (std::size_t i = 0; i < found.size(); ++i) {
            double size = 0.0;
            for (std::size_t k = i % period; k < found.size(); k += period)
                size = std::max(size, std::abs(expected[k]));
            EXPECT_NEAR(std::abs(found[i] - expected[i]) / size, 0.0, tolerance) << i;
            change = std::max(change, std::abs(before[i] - expected[i]) / size);
        }
        EXPECT_GT(change, 0.01) << "the correction must be felt";
    }
}

INSTANTIATE_TEST_SUITE_P(
    Places, CaseCorrection,
    testing::Values(Correction{"contact", [](CaseParameters& c) { c.modifiers.contact = constant(1.2); },
                               [](CaseParameters& c) {
                                   c.contact.constant_m_per_n23 =
                                       contact_constant(c.contact, c.vehicle.wheel_radius_m) / 1.2;
                               }},
                    Correction{"pads", [](CaseParameters& c) { c.modifiers.track.pads = constant(1.2); },
                               [](CaseParameters& c) {
                                   c.track.pads.dynamic_to_static_ratio *= 1.2;
                                   c.track.pads.damping_n_s_per_m *= 1.2;
                               }},
                    Correction{"rail", [](CaseParameters& c) { c.modifiers.track.rail = constant(1.2); },
                               // its weight is stated apart
                               [](CaseParameters& c) { c.track.rail.mass_kg_per_m *= 1.2; }},
                    Correction{"primary", [](CaseParameters& c) { c.modifiers.vehicle.primary = constant(1.2); },
                               [](CaseParameters& c) {
                                   c.vehicle.primary.stiffness_n_per_m *= 1.2;
                                   c.vehicle.primary.damping_n_s_per_m *= 1.2;
                               }},
                    Correction{"wheel", [](CaseParameters& c) { c.modifiers.vehicle.wheelsets = constant(1.2); },
                               // the wheel load is stated
                               [](CaseParameters& c) { c.vehicle.wheelset_mass_kg *= 1.2; }}),
    [](const auto& tested) { return std::string(tested.param.name); });

/// P = (1/(K_h·c) + V + R)⁻¹·r: the inverse of the forces differs from the uncorrected one on its diagonal only.
TEST(ContactCorrection, ComplexComplianceOnTheDiagonal) {
    CaseParameters corrected = exact_case();
    corrected.modifiers.contact = {.frequency_hz = {5.0, 150.0}, .value = {{0.8, 0.1}, {0.5, 0.4}}};
    const CoupledModel model = coupled_model(corrected, tests::kPaperSpeed);
    CoupledWorkspace work(model);
    const GroupSolution& solution = solve_group(model, omega, work);
    for (int lane = 0; lane < lanes::width; ++lane)
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) {
                Complex product = 0.0;  // (1/(K_h·c) + V + R)·P
                for (int k = 0; k < 4; ++k) {
                    Complex entry = (solution.car.wheel(i, k) + solution.rail[i][k])[lane];
                    if (i == k) entry += model.contact_compliance[i] / corrected.modifiers.contact.at(omega[lane]);
                    product += entry * solution.forces[k][j][lane];
                }
                EXPECT_NEAR(std::abs(product - Complex(i == j)), 0.0, 1e-12);
            }
}

TEST(SensorCorrection, IsThatOfTheChannelThatMeasuresTheResponse) {
    CaseParameters parameters;
    parameters.modifiers.sensors["axlebox_1"] = {.frequency_hz = {4.0, 64.0}, .value = {{1.0, 0.2}, {2.0, -0.6}}};
    const Complex correction(1.5, -0.2);
    EXPECT_NEAR(std::abs(channel_transfer(parameters, "wheel_1", 16.0) - correction), 0.0, 1e-14);
    EXPECT_EQ(channel_transfer(parameters, "wheel_2", 16.0), Complex(1.0));
    // Beside two sensors of the channel it counts once.
    parameters.sensors = {{.channel = "axlebox_1", .gain = 2.0}, {.channel = "axlebox_1", .gain = 3.0}};
    EXPECT_NEAR(std::abs(channel_transfer(parameters, "wheel_1", 16.0) - 6.0 * correction), 0.0, 1e-13);
}

}  // namespace
}  // namespace railpem::pem
