#include "pem/distortion/modulated_forces.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "pem/distortion/scattered_forces.hpp"

namespace railpem::pem {

namespace {

using Phasor = std::complex<double>;

constexpr int kMostOrders = 3;  ///< either side
using Forces =
    Eigen::Matrix<Phasor, Eigen::Dynamic, Eigen::Dynamic, 0, 4 * (2 * kMostOrders + 1), 4 * (2 * kMostOrders + 1)>;
using Units = Eigen::Matrix<Phasor, Eigen::Dynamic, 4, 0, 4 * (2 * kMostOrders + 1), 4>;
using Block = Eigen::Matrix<Phasor, 4, 4>;

std::array<Phasor, 4> unit(std::size_t wheel) {
    std::array<Phasor, 4> one{};
    one[wheel] = 1.0;
    return one;
}

Block block_of(const WheelPairs& pairs) {
    return Eigen::Map<const Eigen::Matrix<Phasor, 4, 4, Eigen::RowMajor>>(pairs.data());
}

Block forces_per_irregularity(const ModulationTransfers& transfers, double frequency) {
    return block_of(forces_at(transfers, frequency));
}

Block felt_per_force(const Modulation& modulation, const ModulationTransfers& transfers, double from) {
    if (modulation.bays != 0) {
        const std::array<Phasor, 16> rolling = rolling_at(transfers.rolling, modulation.bays, from);
        const Eigen::Vector4cd times = -Eigen::Map<const Eigen::Vector4cd>(modulation.under_wheel.data());
        return times.asDiagonal() * Eigen::Map<const Eigen::Matrix<Phasor, 4, 4, Eigen::RowMajor>>(rolling.data());
    }
    Block block;
    for (std::size_t j = 0; j < 4; ++j) {
        const std::array<Phasor, 4> column = felt(modulation, transfers, unit(j), from);
        for (std::size_t i = 0; i < 4; ++i) block(static_cast<long>(i), static_cast<long>(j)) = column[i];
    }
    return block;
}

std::array<Phasor, 16> by_rows(const Block& block) {
    std::array<Phasor, 16> result;
    for (long i = 0; i < 4; ++i)
        for (long j = 0; j < 4; ++j) result[static_cast<std::size_t>(i * 4 + j)] = block(i, j);
    return result;
}

/// P = H·(r + M·P) at one f': what forces are felt as, at all orders m of either side.
struct Coupled {
    int highest;
    Forces coupling;  ///< M
    Units force;      ///< P per unit irregularity at f'

    long place(int m) const { return 4 * (m + highest); }

    Coupled(const std::vector<Modulation>& orders, const ModulationTransfers& transfers, double from, int highest_order)
        : highest(highest_order) {
        const long size = 4 * (2 * highest + 1);
        coupling = Forces::Zero(size, size);
        for (int n = -highest; n <= highest; ++n)
            for (const Modulation& order : orders)
                if (order.bays != 0 && std::abs(n + order.bays) <= highest)
                    coupling.block<4, 4>(place(n + order.bays), place(n)) =
                        felt_per_force(order, transfers, from + n * transfers.bay_hz);
        Forces system = Forces::Identity(size, size);
        force = Units::Zero(size, 4);
        for (int m = -highest; m <= highest; ++m) {
            const Block response = forces_per_irregularity(transfers, from + m * transfers.bay_hz);
            system.middleRows<4>(place(m)) -= response * coupling.middleRows<4>(place(m));
            if (m == 0) force.middleRows<4>(place(0)) = response;
        }
        force = system.partialPivLu().solve(force).eval();
    }
};

}  // namespace

std::vector<FeltOrder> felt_orders(const std::vector<Modulation>& orders, const ModulationTransfers& transfers) {
    std::vector<FeltOrder> all(1);
    int highest = 0;
    for (const Modulation& order : orders) {
        all.push_back({.shift_hz = order.shift_hz, .at = {}});
        highest = std::clamp(order.bays, highest, kMostOrders);
    }
    const SeatOrders scattered = scattered_orders(transfers);
    for (std::size_t line = 1; line <= transfers.force.size(); ++line) {
        const double from = static_cast<double>(line) * ModulationTransfers::kStep_hz;
        const Coupled coupled(orders, transfers, from, highest);
        const Units irregularity = coupled.coupling * coupled.force;
        const Block force = coupled.force.middleRows<4>(coupled.place(0));
        const auto scatter = [&](int order, double shift) -> Block {
            return -(block_of(order_at(scattered, order, from + 0.5 * shift)) * force);
        };
        Block back = irregularity.middleRows<4>(coupled.place(0));
        if (scattered.highest > 0) back += scatter(0, 0.0);
        all.front().at.push_back(by_rows(back));
        for (std::size_t k = 0; k < orders.size(); ++k) {
            const int m = orders[k].bays;
            if (m != 0 && std::abs(m) <= highest)
                all[k + 1].at.push_back(by_rows(irregularity.middleRows<4>(coupled.place(m))));
            else if (orders[k].failures != 0)
                all[k + 1].at.push_back(by_rows(scatter(orders[k].failures, orders[k].shift_hz)));
            else
                all[k + 1].at.push_back(by_rows(felt_per_force(orders[k], transfers, from) * force));
        }
    }
    return all;
}

std::array<Phasor, 16> at_frequency(const FeltOrder& order, double from) {
    const double place = from / ModulationTransfers::kStep_hz - 1.0;
    const std::size_t below = place <= 0.0 ? 0 : std::min(static_cast<std::size_t>(place), order.at.size() - 2);
    const double share = std::clamp(place - static_cast<double>(below), 0.0, 1.0);
    // Below the first line a vehicle that rises and falls with the track has forces with the square of the frequency,
    // and the irregularity has most of its power.
    const double rise = std::min(1.0, std::pow(from / ModulationTransfers::kStep_hz, 2));
    std::array<Phasor, 16> result;
    for (std::size_t i = 0; i < 16; ++i)
        result[i] = rise * ((1.0 - share) * order.at[below][i] + share * order.at[below + 1][i]);
    return result;
}

LineSet felt_lines(const std::vector<FeltOrder>& orders, const LineSet& lines) {
    LineSet result{.name = lines.name, .lines = {}};
    for (const SpectralLine& line : lines.lines)
        for (std::size_t k = 0; k < orders.size(); ++k) {
            const double to = line.frequency_hz + orders[k].shift_hz;
            const std::array<Phasor, 16> at = at_frequency(orders[k], line.frequency_hz);
            SpectralLine own{.frequency_hz = std::abs(to),
                             .amplitude_m = k == 0 ? line.amplitude_m : std::array<Phasor, 4>{}};
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j) own.amplitude_m[i] += at[i * 4 + j] * line.amplitude_m[j];
            if (to < 0.0)
                for (Phasor& one : own.amplitude_m) one = std::conj(one);
            result.lines.push_back(own);
        }
    return result;
}

std::array<Phasor, 4> felt_irregularity(const std::vector<FeltOrder>& orders, std::size_t which,
                                        const DelayedSpectrum& source, const std::vector<double>& wheels, double speed,
                                        double frequency) {
    const double from = frequency - orders[which].shift_hz, size = std::abs(from);
    if (from == 0.0) return {};
    // Of a negative frequency the conjugate of the other side, which is its neighbour.
    const std::array<Phasor, 16> at = at_frequency(orders[from > 0.0       ? which
                                                          : which % 2 == 1 ? which + 1
                                                                           : which - 1],
                                                   size);
    const double root = std::sqrt(source.psd_m2_per_hz(size));
    std::array<Phasor, 4> result{};
    for (std::size_t j = 0; j < 4; ++j) {
        const Phasor delay = root * source.share[j] * delay_phase(wheels, j, size, speed);
        for (std::size_t i = 0; i < 4; ++i) result[i] += at[i * 4 + j] * delay;
    }
    if (from < 0.0)
        for (Phasor& own : result) own = std::conj(own);
    return result;
}

}  // namespace railpem::pem
