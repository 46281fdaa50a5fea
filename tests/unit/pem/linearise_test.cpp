// The iteration behind equivalent damping and stiffness: it settles, wherever it starts.

#include "pem/coupling/linearise.hpp"
#include "pem/coupling/excite.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pem/coupling/wheel_transfers.hpp"
#include "tests/verification/pem/paper_case.hpp"
#include "vehicle/vehicle_parameters.hpp"

namespace railpem::pem {
namespace {

constexpr double kRunning = 22.2222;  // m/s

Linearisation settled(const CaseParameters& parameters, CoupledModel& model) {
    return linearise(parameters, excitation_sources(parameters, vehicle::wheel_positions(parameters.vehicle), kRunning),
                     model);
}

CaseParameters coarse() {
    CaseParameters c = tests::paper_case(1);
    c.frequency = {.from_hz = 1.0, .to_hz = 120.0, .step_hz = 0.5};
    return c;
}

/// From a force that nobody feels to one that blocks the springs, in both stages, beside a contact that opens. 5 to 14
/// steps, 29 where nothing moves in the end. There what is left is rounding, 2e-9.
TEST(Linearise, SettlesWhateverTheForce) {
    for (const double force : {1.0, 100.0, 1000.0, 5e3, 3e4})
        for (const double share : {0.0, 1.0, 4.0}) {
            CaseParameters c = coarse();
            c.vehicle.primary.friction_force_n = force;
            c.vehicle.secondary.friction_force_n = 0.5 * force;
            c.contact.nonlinearity_factor = share;
            CoupledModel model = coupled_model(c, kRunning);
            const Linearisation found = settled(c, model);
            EXPECT_LT(found.iterations, 40) << force << ' ' << share;
            EXPECT_LT(found.change, force < 1e4 ? 1e-12 : 1e-8) << force << ' ' << share;
            // A stage that the force blocks moves by a nanometre a second at most, below which damping is no longer
            // raised.
            for (std::size_t e = 0; e < 4; ++e) {
                const double velocity = std::max(found.primary_velocity_m_per_s[e], 1e-9);
                EXPECT_NEAR(model.car.friction.primary[e] * velocity / (force * std::sqrt(2.0 / std::numbers::pi)), 1.0,
                            1e-8)
                    << force;
            }
        }
}

/// A start near by, as slopes by differences have it, ends where the start from nothing ends.
TEST(Linearise, EndsWhereItEndsFromAnyStart) {
    CaseParameters c = coarse();
    c.vehicle.primary.friction_force_n = 1000.0;
    CoupledModel from_nothing = coupled_model(c, kRunning), from_near = coupled_model(c, kRunning),
                 from_afar = coupled_model(c, kRunning);
    settled(c, from_nothing);
    for (std::size_t e = 0; e < 4; ++e) {
        from_near.car.friction.primary[e] = from_nothing.car.friction.primary[e] * (1.0 + 1e-4);
        from_afar.car.friction.primary[e] = 1e6;
    }
    EXPECT_LT(settled(c, from_near).iterations, 8);  // 5
    settled(c, from_afar);
    for (std::size_t e = 0; e < 4; ++e) {
        EXPECT_NEAR(from_near.car.friction.primary[e] / from_nothing.car.friction.primary[e], 1.0, 1e-11);
        EXPECT_NEAR(from_afar.car.friction.primary[e] / from_nothing.car.friction.primary[e], 1.0, 1e-11);
    }
}

}  // namespace
}  // namespace railpem::pem
