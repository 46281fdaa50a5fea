#include "pem/rail/seat_orders.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "pem/angular_frequency.hpp"

namespace railpem::pem {

namespace {

using Phasor = std::complex<double>;

constexpr double kAtRest_hz = 0.01;

void take_off_the_mean(std::vector<WheelPairs>& places) {
    for (std::size_t pair = 0; pair < 16; ++pair) {
        Phasor mean = 0.0;
        for (const WheelPairs& own : places) mean += own[pair] / static_cast<double>(places.size());
        for (WheelPairs& own : places) own[pair] -= mean;
    }
}

}  // namespace

SeatPlaceReceptances seat_place_receptances(const RailModel& model, double to_hz) {
    SeatPlaceReceptances result;
    const SeatPlaces* places = model.seat_places();
    if (!places) return result;
    result.places = *places;
    const RailModel& seats = *model.beside_equal_seats();
    const std::unique_ptr<RailEvaluator> evaluator = seats.evaluator();
    result.at.resize(static_cast<std::size_t>(to_hz / SeatPlaceReceptances::kStep_hz) + 2);
    for (std::size_t first = 0; first < result.at.size(); first += lanes::width) {
        lanes::Real omega;
        for (int lane = 0; lane < lanes::width; ++lane)
            omega[lane] =
                kTwoPi * std::max(kAtRest_hz, static_cast<double>(std::min(first + static_cast<std::size_t>(lane),
                                                                           result.at.size() - 1)) *
                                                  SeatPlaceReceptances::kStep_hz);
        for (int place = 0; place < seats.places(); ++place) {
            const track::RailReceptance& own = evaluator->at_place(place, omega);
            for (int lane = 0; lane < lanes::width && first + static_cast<std::size_t>(lane) < result.at.size();
                 ++lane) {
                WheelPairs& pairs = result.at[first + static_cast<std::size_t>(lane)].emplace_back();
                for (std::size_t pair = 0; pair < 16; ++pair) pairs[pair] = own.between[pair][lane];
            }
        }
    }
    for (std::vector<WheelPairs>& line : result.at) take_off_the_mean(line);
    return result;
}

SeatOrders seat_orders(const SeatPlaceReceptances& receptances) {
    SeatOrders result;
    if (receptances.at.empty()) return result;
    const std::size_t places = receptances.at.front().size();
    const double share = 1.0 / static_cast<double>(places);
    result.highest = (static_cast<int>(places) - 1) / 2;
    const auto orders = static_cast<std::size_t>(2 * result.highest + 1);
    Eigen::MatrixXcd turns(places, orders);
    for (std::size_t order = 0; order < orders; ++order)
        for (std::size_t k = 0; k < places; ++k) {
            const double m = static_cast<double>(order) - result.highest;
            turns(static_cast<long>(k), static_cast<long>(order)) = std::polar(
                share,
                -kTwoPi * m *
                    (receptances.places.first_bay / receptances.places.period_bays + static_cast<double>(k) * share));
        }
    result.at.assign(receptances.at.size(), std::vector<WheelPairs>(orders));
    using Pairs = Eigen::Matrix<Phasor, 16, Eigen::Dynamic>;
    for (std::size_t line = 0; line < receptances.at.size(); ++line)
        Eigen::Map<Pairs>(result.at[line].front().data(), 16, static_cast<long>(orders)).noalias() =
            Eigen::Map<const Pairs>(receptances.at[line].front().data(), 16, static_cast<long>(places)) * turns;
    return result;
}

WheelPairs order_at(const SeatOrders& orders, int order, double frequency) {
    const double place = std::abs(frequency) / SeatPlaceReceptances::kStep_hz;
    const std::size_t below = std::min(static_cast<std::size_t>(place), orders.at.size() - 2);
    const double share = std::min(1.0, place - static_cast<double>(below));
    const std::size_t m = static_cast<std::size_t>((frequency < 0.0 ? -order : order) + orders.highest);
    const WheelPairs &low = orders.at[below][m], &high = orders.at[below + 1][m];
    WheelPairs result;
    for (std::size_t pair = 0; pair < 16; ++pair) {
        const Phasor value = (1.0 - share) * low[pair] + share * high[pair];
        result[pair] = frequency < 0.0 ? std::conj(value) : value;
    }
    return result;
}

}  // namespace railpem::pem
