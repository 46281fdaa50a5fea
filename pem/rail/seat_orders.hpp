#pragma once
// How the rail under the wheels gives way from one failed seat to the next, order by order of their period.

#include <array>
#include <complex>
#include <vector>

#include "pem/rail/rail_model.hpp"

namespace railpem::pem {

using WheelPairs = std::array<std::complex<double>, 16>;  ///< [felt at·4 + force at]

/// The receptances at every place of a period of failed seats less their mean, m/N, at 0, kStep_hz, 2·kStep_hz, …
struct SeatPlaceReceptances {
    static constexpr double kStep_hz = 4.0;
    SeatPlaces places;
    std::vector<std::vector<WheelPairs>> at;  ///< [line][place]; empty: no seats differ
};

/// Up to `to_hz`. Nothing where model.seat_places() is nothing.
SeatPlaceReceptances seat_place_receptances(const RailModel& model, double to_hz);

/// Fourier coefficients over the period of something that every place has, x the place of wheel 1: C(x) = Σ_m
/// C_m·e^{2πimx/(n·spacing)}; on the lines of SeatPlaceReceptances.
struct SeatOrders {
    int highest = 0;                          ///< orders −highest to highest; 0: no seats differ
    std::vector<std::vector<WheelPairs>> at;  ///< [line][m + highest]

    bool has(int order) const { return order != 0 && order <= highest && -order <= highest; }
};

/// All orders that the places tell apart. The mean is order 0.
SeatOrders seat_orders(const SeatPlaceReceptances& receptances);

/// C_m at a frequency of either sign, straight between the lines. `order` has to be known, or 0.
WheelPairs order_at(const SeatOrders& orders, int order, double frequency_hz);

}  // namespace railpem::pem
