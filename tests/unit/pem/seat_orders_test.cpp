// Orders of a period of failed seats.

#include "pem/rail/seat_orders.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "pem/coupling/coupled_model.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::pem {
namespace {

using Phasor = std::complex<double>;

// Two waves of a period of three bays in nine places, the second twice as large from one line to the next.
TEST(SeatOrders, AreThoseOfAFourierSeries) {
    constexpr Phasor kFirst{2.0, -1.0}, kSecond{0.5, 3.0};
    SeatPlaceReceptances made{.places = {.period_bays = 3, .first_bay = 0.4}, .at = {}};
    for (int line = 0; line < 3; ++line) {
        made.at.emplace_back();
        for (int k = 0; k < 9; ++k) {
            const double turn = 2.0 * std::numbers::pi * (0.4 / 3.0 + k / 9.0);
            made.at.back().emplace_back().fill(kFirst * std::polar(1.0, turn) +
                                               kSecond * (1.0 + line) * std::polar(1.0, -2.0 * turn));
        }
    }
    const SeatOrders orders = seat_orders(made);
    EXPECT_TRUE(orders.has(4) && orders.has(-4) && !orders.has(5) && !orders.has(0));
    const auto expect = [&](int order, double frequency, Phasor value) {
        EXPECT_LT(std::abs(order_at(orders, order, frequency)[7] - value), 1e-12) << order << " at " << frequency;
    };
    expect(1, 6.0, kFirst);
    expect(-2, 6.0, 2.5 * kSecond);
    expect(2, 6.0, 0.0);
    expect(2, -6.0, std::conj(2.5 * kSecond));  // of what is real in time
    expect(1, 0.0, kFirst);
}

// Seats at rest know no direction: the rail under wheel i gives way to a force at wheel j as that under j to one at i,
// at every place, and the first order is no rounding error.
TEST(SeatOrders, OfFailedSeatsAreReciprocal) {
    CaseParameters c = tests::paper_case(1);
    c.solver.moving = true;
    c.track.failed_fasteners = {{.every = 4, .remaining_stiffness_fraction = 0.2}};
    const CoupledModel model = coupled_model(c, 20.0);
    ASSERT_NE(model.rail->seat_places(), nullptr);
    EXPECT_EQ(model.rail->seat_places()->period_bays, 4);
    const SeatOrders orders = seat_orders(seat_place_receptances(*model.rail, 40.0));
    ASSERT_EQ(orders.highest, 5);
    for (const double frequency : {3.0, 30.0}) {
        const WheelPairs own = order_at(orders, 1, frequency);
        EXPECT_GT(std::abs(own[0]), 1e-10);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                EXPECT_LT(std::abs(own[i * 4 + j] - own[j * 4 + i]), 1e-6 * std::abs(own[0]));
    }
    c.track.failed_fasteners.clear();
    EXPECT_TRUE(seat_place_receptances(*coupled_model(c, 20.0).rail, 40.0).at.empty());
}

}  // namespace
}  // namespace railpem::pem
