// Expected spectra with friction that is not linearised.

#include "diagnosis/expectation/friction_spectra.hpp"
#include "pem/coupling/excite.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "pem/coupling/linearise.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

constexpr double kSlow = 22.2;

struct Asked {
    pem::CaseParameters parameters = tests::paper_case(1);
    Observation shape =
        observation_shape(kSlow, 0.0, 60.0, {"wheel_1", "bogie_1", "bogie_2", "body"}, tests::paper_case(1), kSmall);

    ExpectedSpectra expected(std::shared_ptr<const StageFriction> realised) const {
        ExpectationOptions options = shape.expectation;
        options.realised_friction = std::move(realised);
        return expected_spectra(parameters, kSlow, shape.kernel, shape.channels, {}, options);
    }
};

std::shared_ptr<StageFriction> with_curves(double damping, double power) {
    const pem::RealisedFriction own{.damping = {{1.0}, {damping}}, .power = {{1.0}, {power}}};
    return std::make_shared<StageFriction>(StageFriction{own, own});
}

double distance(const ExpectedSpectra& a, const ExpectedSpectra& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i) sum += std::norm(a.values[i] - b.values[i]);
    return std::sqrt(sum);
}

TEST(FrictionSpectra, OfNothingBeyondTheLinearisationAreThoseOfIt) {
    Asked asked;
    asked.parameters.vehicle.primary.friction_force_n = 1000.0;
    const ExpectedSpectra plain = asked.expected(nullptr);
    EXPECT_LT(distance(asked.expected(with_curves(0.0, 1.0)), plain),
              1e-12 * distance(plain, {.values = std::vector<std::complex<double>>(plain.values.size())}));
}

// So little friction that ten times its damping is a small change of the damper, and its own forces nothing.
TEST(FrictionSpectra, FollowDampingAsADamperDoes) {
    for (const bool primary : {true, false}) {
        Asked asked;
        vehicle::SuspensionParameters& stage =
            primary ? asked.parameters.vehicle.primary : asked.parameters.vehicle.secondary;
        stage.friction_force_n = 0.1;
        const ExpectedSpectra plain = asked.expected(nullptr), followed = asked.expected(with_curves(10.0, 1.0));
        pem::CoupledModel model = pem::coupled_model(asked.parameters, kSlow);
        pem::linearise(asked.parameters, pem::excitation_sources(asked.parameters, model.wheels_m, kSlow), model);
        stage.damping_n_s_per_m += 10.0 * (primary ? model.car.friction.primary[0] : model.car.friction.secondary[0]);
        const ExpectedSpectra damped = asked.expected(nullptr);
        // Elements differ by some per cent from the first, and the change is followed to first order.
        EXPECT_LT(distance(followed, damped), 0.1 * distance(plain, damped)) << primary;
    }
}

TEST(FrictionSpectra, TakeThePowerOfTheRest) {
    Asked asked;
    asked.parameters.vehicle.primary.friction_force_n = 1000.0;
    const ExpectedSpectra none = asked.expected(with_curves(0.0, 0.0)), once = asked.expected(with_curves(0.0, 1.0)),
                          twice = asked.expected(with_curves(0.0, 2.0));
    for (std::size_t i = 0; i < none.values.size(); ++i)
        EXPECT_NEAR(std::abs(twice.values[i] - none.values[i] - 2.0 * (once.values[i] - none.values[i])), 0.0,
                    1e-9 * std::abs(twice.values[i]));
    EXPECT_GT(distance(once, none), 0.0);
}

}  // namespace
}  // namespace railpem::diagnosis
