#include "pem/coupling/rolling_table.hpp"

#include <algorithm>
#include <cmath>

#include "pem/angular_frequency.hpp"
#include "pem/coupling/wheel_transfers.hpp"
#include "pem/lagrange.hpp"
#include "track/pads/pad_law.hpp"

namespace railpem::pem {

namespace {

using Phasor = std::complex<double>;

constexpr double kRest_hz = 0.01;
constexpr double kOrdinaryLoss = 0.4, kFinest = 0.125;
constexpr double kResonance_hz = 150.0;  ///< about where the rail resonates on pads that let it

double table_step(const EqualSeats& seats) {
    const Phasor pad = seats.pad_stiffness_n_per_m * track::pad_shape(seats.track.pads, kResonance_hz) +
                       Phasor(0.0, kTwoPi * kResonance_hz * track::pad_damping(seats.track.pads));
    return 4.0 * std::clamp(std::exp2(std::ceil(std::log2(std::max(1e-3, pad.imag() / pad.real()) / kOrdinaryLoss))),
                            kFinest, 1.0);
}

/// A line that is told by its neighbours: in the middle of six of every second line, and above the octaves that have
/// few lines each.
bool is_between(std::size_t line, std::size_t lines) {
    constexpr std::size_t kFirst = 15;
    return line % 2 == 1 && line >= kFirst && line + kLagrangePoints - 1 < lines;
}

/// The lines between, by how the others differ from `near`.
void fill_between(const RollingTable& near, RollingTable& table) {
    constexpr std::size_t reach = kLagrangePoints - 1;
    const std::array<double, kLagrangePoints> weights = lagrange(0.5 * reach);
    for (std::size_t line = 0; line < table.at.size(); ++line) {
        if (!is_between(line, table.at.size())) continue;
        table.at[line] = near.at[line];
        for (std::size_t i = 0; i < table.at[line].values.size(); ++i)
            for (std::size_t k = 0; k < kLagrangePoints; ++k) {
                const std::size_t other = line - reach + 2 * k;
                table.at[line].values[i] += weights[k] * (table.at[other].values[i] - near.at[other].values[i]);
            }
    }
}

}  // namespace

RollingTable rolling_table(const CoupledModel& model, double speed, double to_hz, const RollingTable* near) {
    RollingTable table;
    const EqualSeats* seats = model.rail->equal_seats();
    if (!seats) return table;
    table.step_hz = table_step(*seats);
    const auto lines = std::max<std::size_t>(kLagrangePoints, static_cast<std::size_t>(to_hz / table.step_hz) + 4);
    const int highest = seats->track.rail.beam == track::Beam::timoshenko ? 3 : 2;
    const bool alike =
        near && near->step_hz == table.step_hz && near->at.size() == lines && near->at.front().highest == highest;
    table.at.resize(lines);
    for (std::size_t line = 0; line < lines; ++line) {
        if (alike && is_between(line, lines)) continue;
        table.at[line] = track::rolling_receptance(seats->track, seats->pad_stiffness_n_per_m, model.wheels_m, speed,
                                                   std::max(kRest_hz, static_cast<double>(line) * table.step_hz),
                                                   highest, seats->modifiers);
    }
    if (alike) fill_between(*near, table);
    return table;
}

std::array<Phasor, 16> rolling_at(const RollingTable& table, int order, double frequency) {
    const double place = std::abs(frequency) / table.step_hz;
    // Below zero the other side's conjugate: the window stays in the middle.
    const long base = std::min(static_cast<long>(place) - kLagrangePoints / 2 + 1,
                               static_cast<long>(table.at.size()) - kLagrangePoints);
    const double t = std::min(place - static_cast<double>(base), kLagrangePoints - 1.0);
    const int own_order = frequency < 0.0 ? -order : order;
    if (std::abs(order) > table.at.front().highest) return {};
    std::array<Phasor, 16> result{};
    const std::array<double, kLagrangePoints> weights = lagrange(t);
    for (int k = 0; k < kLagrangePoints; ++k) {
        const double weight = weights[static_cast<std::size_t>(k)];
        const long line = base + k;
        const Phasor* values =
            &table.at[static_cast<std::size_t>(std::abs(line))].at(line < 0 ? -own_order : own_order, 0, 0);
        for (std::size_t pair = 0; pair < 16; ++pair)
            result[pair] += weight * (line < 0 ? std::conj(values[pair]) : values[pair]);
    }
    if (frequency < 0.0)
        for (Phasor& own : result) own = std::conj(own);
    return result;
}

namespace {

void add_others(const CoupledModel& model, const RailModel& others, double from_hz, double step_hz, std::size_t lines,
                int every, int threads, std::vector<RailGroup>& rails) {
    CoupledModel alone = model;
    alone.rail = std::shared_ptr<const RailModel>(model.rail, &others);
    const std::vector<RailGroup> added = rail_groups(alone, from_hz, step_hz, lines, every, threads);
    for (std::size_t group = 0; group < rails.size(); ++group)
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 4; ++j) rails[group].rail[i][j] += added[group].rail[i][j];
            rails[group].trackbed[i] += added[group].trackbed[i];
        }
}

}  // namespace

std::vector<RailGroup> rolling_rails(const RollingTable& table, const CoupledModel& model, double from_hz,
                                     double step_hz, std::size_t lines, int every, int threads) {
    const EqualSeats& seats = *model.rail->equal_seats();
    std::vector<RailGroup> rails((lines + lanes::width - 1) / lanes::width);
    for (std::size_t group = 0; group < rails.size(); ++group) {
        RailGroup& own = rails[group];
        for (int lane = 0; lane < lanes::width; ++lane) {
            const double frequency = from_hz + static_cast<double>(std::min(
                                                   group * lanes::width + static_cast<std::size_t>(lane), lines - 1)) *
                                                   step_hz;
            own.omega[lane] = kTwoPi * frequency;
            const std::array<Phasor, 16> receptance = rolling_at(table, 0, frequency);
            for (std::size_t pair = 0; pair < 16; ++pair) own.rail[pair / 4][pair % 4].set(lane, receptance[pair]);
        }
        own.trackbed.fill(
            track::rolling_trackbed(seats.track, seats.pad_stiffness_n_per_m, own.omega, seats.modifiers));
    }
    if (const RailModel* others = model.rail->beside_equal_seats())
        add_others(model, *others, from_hz, step_hz, lines, every, threads, rails);
    return rails;
}

}  // namespace railpem::pem
