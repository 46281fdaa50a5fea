#include "pem/distortion/passing_modulation.hpp"

#include <algorithm>
#include <cmath>

#include "pem/coupling/wheel_transfers.hpp"
#include "pem/response_names.hpp"
#include "track/statics/seat_stiffness.hpp"

namespace railpem::pem {

namespace {

using Phasor = std::complex<double>;

/// shifts by v over that; seats that failed show over some two metres
constexpr double kRandomStep_m = 6.0, kLeastRandom = 0.05;
constexpr int kMostRandom = 16;
constexpr int kOrdersUnled = 2;  ///< of the modulation, where no lines say which count

double strength(const std::array<Phasor, 4>& under_wheels) {
    double sum = 0.0;
    for (const Phasor& own : under_wheels) sum += std::norm(own);
    return std::sqrt(sum);
}

std::size_t period_of(const CaseParameters& parameters) {
    const auto& failed = parameters.track.failed_fasteners;
    return failed.empty() ? 1 : static_cast<std::size_t>(std::max(1, failed.front().every));
}

/// What the lines say of the track: m per N of constant load, without the factor by which the case has the lines of
/// whole bays.
std::vector<std::array<Phasor, 4>> compliances(const CaseParameters& parameters, const TrackExcitation& track) {
    const std::size_t period = period_of(parameters);
    std::vector<std::array<Phasor, 4>> result;
    for (std::size_t line = 0; line < track.deflection.size(); ++line) {
        const bool whole_bay = (line + 1) % period == 0;
        const double scale =
            0.5 / (track.wheel_load_n * (whole_bay && track.amplitude_factor != 0.0 ? track.amplitude_factor : 1.0));
        result.push_back(track.deflection[line].amplitude_m);
        for (Phasor& own : result.back()) own *= scale;
    }
    return result;
}

/// By how much a line is more than equal linear seats make of constant loads.
std::array<Phasor, 4> over_linear(const ModulationTransfers& transfers, int bays,
                                  const std::array<Phasor, 4>& compliance) {
    if (bays > transfers.rolling.at.front().highest) return {};
    const std::array<Phasor, 16> linear = rolling_at(transfers.rolling, bays, 0.0);
    std::array<Phasor, 4> ratio;
    for (std::size_t i = 0; i < 4; ++i)
        ratio[i] = -compliance[i] / (linear[i * 4] + linear[i * 4 + 1] + linear[i * 4 + 2] + linear[i * 4 + 3]);
    return ratio;
}

/// Where a frequency of either sign lies between the lines.
struct Place {
    std::size_t below;
    double share;
    bool conjugate;

    Place(const ModulationTransfers& transfers, double frequency) : conjugate(frequency < 0.0) {
        const double place = std::abs(frequency) / ModulationTransfers::kStep_hz - 1.0;
        below = place <= 0.0 ? 0 : std::min(static_cast<std::size_t>(place), transfers.force.size() - 2);
        share = std::clamp(place - static_cast<double>(below), 0.0, 1.0);
    }
    Phasor between(Phasor low, Phasor high) const {
        const Phasor value = (1.0 - share) * low + share * high;
        return conjugate ? std::conj(value) : value;
    }
};

Phasor between(const std::vector<Phasor>& values, const Place& at) {
    return at.between(values[at.below], values[at.below + 1]);
}

/// How strongly seats that differ pass a force at one frequency on to another.
Phasor passed_on(const ModulationTransfers& transfers, double from, double to) {
    const Place in(transfers, from), out(transfers, to);
    return 0.5 * (between(transfers.seat_share, in) * between(transfers.receptance, out) +
                  between(transfers.seat_share, out) * between(transfers.receptance, in));
}

Modulation of_differing_seats(const ModulationTransfers& transfers, double shift_hz,
                              const std::array<Phasor, 4>& compliance) {
    Modulation own{.shift_hz = shift_hz};
    const Phasor share = passed_on(transfers, shift_hz, shift_hz);
    for (std::size_t wheel = 0; wheel < 4; ++wheel) own.under_wheel[wheel] = compliance[wheel] / share;
    return own;
}

void add_both_sides(const Modulation& up, std::vector<Modulation>& orders) {
    Modulation down{.shift_hz = -up.shift_hz, .bays = -up.bays, .failures = -up.failures};
    for (std::size_t wheel = 0; wheel < 4; ++wheel) down.under_wheel[wheel] = std::conj(up.under_wheel[wheel]);
    orders.push_back(up);
    orders.push_back(down);
}

}  // namespace

std::array<Phasor, 16> forces_at(const ModulationTransfers& transfers, double frequency) {
    const Place at(transfers, frequency);
    const std::array<Phasor, 16>&low = transfers.force[at.below], &high = transfers.force[at.below + 1];
    // Below the first line a vehicle that rises and falls with the track has forces with the square of the frequency,
    // and the irregularity has most of its power.
    const double rise = std::min(1.0, std::pow(frequency / ModulationTransfers::kStep_hz, 2));
    std::array<Phasor, 16> result;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = rise * at.between(low[i], high[i]);
    return result;
}

std::array<Phasor, 4> forces_of(const ModulationTransfers& transfers, double frequency,
                                const std::array<Phasor, 4>& irregularity) {
    const std::array<Phasor, 16> forces = forces_at(transfers, frequency);
    std::array<Phasor, 4> result{};
    for (std::size_t wheel = 0; wheel < 4; ++wheel)
        for (std::size_t j = 0; j < 4; ++j) result[wheel] += forces[wheel * 4 + j] * irregularity[j];
    return result;
}

double modulation_end_hz(const CaseParameters& parameters, double speed) {
    return parameters.frequency.to_hz + kOrdersUnled * speed / parameters.track.spacing_m;
}

ModulationTransfers modulation_transfers(const CaseParameters& parameters, const CoupledModel& model, double speed,
                                         RollingTable rolling, const ModulationTransfers* known) {
    constexpr double step = ModulationTransfers::kStep_hz;
    ModulationTransfers transfers{.force = {},
                                  .receptance = {},
                                  .seat_share = {},
                                  .bay_hz = speed / parameters.track.spacing_m,
                                  .rolling = std::move(rolling),
                                  .rails = {},
                                  .at_places = {},
                                  .seats = {}};
    const auto lines = std::max<std::size_t>(2, static_cast<std::size_t>(modulation_end_hz(parameters, speed) / step));
    std::vector<std::size_t> responses;
    for (const char* wheel : {"contact_1", "contact_2", "contact_3", "contact_4"})
        responses.push_back(response_index(wheel));
    if (known) {
        transfers.rails = known->rails, transfers.at_places = known->at_places, transfers.seats = known->seats;
    } else {
        transfers.rails = rolling_rails(transfers.rolling, model, step, step, lines);
        transfers.at_places = seat_place_receptances(*model.rail, modulation_end_hz(parameters, speed));
        transfers.seats = seat_orders(transfers.at_places);
    }
    const WheelTransfers solved = wheel_transfers(model, step, step, lines, responses, 1, &transfers.rails);
    const track::PadParameters& pads = parameters.track.pads;
    const double pad_n_per_m = pads.dynamic_to_static_ratio * pads.static_stiffness_n_per_m;
    transfers.force.resize(lines);
    for (std::size_t line = 0; line < lines; ++line) {
        std::copy_n(solved.at(line), 16, transfers.force[line].begin());
        const Phasor receptance =
            transfers.rails[line / lanes::width].rail[0][0][static_cast<int>(line % lanes::width)];
        transfers.receptance.push_back(receptance);
        transfers.seat_share.push_back(receptance * track::seat_stiffness(parameters.track, pad_n_per_m, 1.0,
                                                                          static_cast<double>(line + 1) * step,
                                                                          parameters.modifiers.track));
    }
    return transfers;
}

std::vector<Modulation> modulations(const CaseParameters& parameters, const TrackExcitation& track,
                                    const ModulationTransfers& transfers, double least) {
    constexpr std::array<Phasor, 4> kAsItIs{1.0, 1.0, 1.0, 1.0};
    const std::vector<std::array<Phasor, 4>> compliance = compliances(parameters, track);
    const int period = static_cast<int>(period_of(parameters));
    const bool led = track.amplitude_factor != 0.0, stiffens = led && parameters.track.pads.preload_strength > 0.0;
    std::vector<Modulation> orders;
    double strongest = 0.0;
    for (const auto& own : compliance) strongest = std::max(strongest, strength(own));
    for (int line = 1; line <= static_cast<int>(compliance.size()); ++line) {
        const std::array<Phasor, 4>& own = compliance[static_cast<std::size_t>(line - 1)];
        const double shift_hz = track.deflection[static_cast<std::size_t>(line - 1)].frequency_hz;
        const int bays = line % period == 0 ? line / period : 0;
        if (bays > 0 && !led ? bays > kOrdersUnled : strength(own) < least * strongest) continue;
        if (bays == 0) {
            Modulation differing = of_differing_seats(transfers, shift_hz, own);
            if (transfers.seats.has(line)) differing.failures = line;
            add_both_sides(differing, orders);
        } else
            add_both_sides({.shift_hz = shift_hz,
                            .bays = bays,
                            .under_wheel = stiffens ? over_linear(transfers, bays, own) : kAsItIs},
                           orders);
    }
    for (int bays = 1; compliance.empty() && bays <= kOrdersUnled; ++bays)
        add_both_sides({.shift_hz = bays * transfers.bay_hz, .bays = bays, .under_wheel = kAsItIs}, orders);
    return orders;
}

std::vector<Modulation> random_modulations(const TrackExcitation& track, const ModulationTransfers& transfers,
                                           double speed) {
    if (!track.failed) return {};
    const double step = speed / kRandomStep_m;
    std::vector<Modulation> orders;
    double strongest = 0.0;
    for (int k = 0; k < kMostRandom; ++k) {
        const double shift = (k + 0.5) * step;
        std::array<Phasor, 4> under_wheel = track.failed(shift);
        const double size = strength(under_wheel);
        strongest = std::max(strongest, size);
        if (size < kLeastRandom * strongest) break;
        // one-sided: half of the power on either side
        for (Phasor& own : under_wheel) own *= std::sqrt(0.5 * step) / track.wheel_load_n;
        add_both_sides(of_differing_seats(transfers, shift, under_wheel), orders);
    }
    return orders;
}

std::array<Phasor, 4> felt(const Modulation& modulation, const ModulationTransfers& transfers,
                           const std::array<Phasor, 4>& force, double from) {
    std::array<Phasor, 4> result{};
    if (modulation.failures != 0) {
        const std::array<Phasor, 16> between =
            order_at(transfers.seats, modulation.failures, from + 0.5 * modulation.shift_hz);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) result[i] -= between[i * 4 + j] * force[j];
        return result;
    }
    if (modulation.bays == 0) {
        const Phasor share = passed_on(transfers, from, from + modulation.shift_hz);
        for (std::size_t wheel = 0; wheel < 4; ++wheel)
            result[wheel] = share * modulation.under_wheel[wheel] * force[wheel];
        return result;
    }
    const std::array<Phasor, 16> rolling = rolling_at(transfers.rolling, modulation.bays, from);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) result[i] -= modulation.under_wheel[i] * rolling[i * 4 + j] * force[j];
    return result;
}

namespace {

/// Adds to `lines` what their forces make of each other.
void settle(std::vector<SpectralLine>& lines, const std::vector<Modulation>& orders,
            const ModulationTransfers& transfers, bool sound, int sweeps) {
    const int highest = static_cast<int>(lines.size());
    const double line_hz = lines.front().frequency_hz;
    const std::vector<SpectralLine> alone = lines;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        std::vector<std::array<Phasor, 4>> force;  // of the lines 1, 2, …
        for (const SpectralLine& line : lines)
            force.push_back(forces_of(transfers, line.frequency_hz, line.amplitude_m));
        for (int m = 1; m <= highest; ++m) {
            std::array<Phasor, 4> sum = alone[static_cast<std::size_t>(m - 1)].amplitude_m;
            for (int n = -highest; n <= highest; ++n) {
                const int order = m - n;
                if (n == 0 || order == 0 || std::abs(order) > highest || (sound && n == 1)) continue;
                std::array<Phasor, 4> own = force[static_cast<std::size_t>(std::abs(n) - 1)];
                if (n < 0)
                    for (Phasor& one : own) one = std::conj(one);
                const std::array<Phasor, 4> more =
                    felt(orders[static_cast<std::size_t>(2 * (std::abs(order) - 1) + (order < 0 ? 1 : 0))], transfers,
                         own, n * line_hz);
                for (std::size_t wheel = 0; wheel < 4; ++wheel) sum[wheel] += more[wheel];
            }
            lines[static_cast<std::size_t>(m - 1)].amplitude_m = sum;
        }
    }
}

}  // namespace

void feed_back_lines(const CaseParameters& parameters, const ModulationTransfers& transfers, TrackExcitation& track,
                     int sweeps) {
    const std::vector<Modulation> orders = modulations(parameters, track, transfers, 0.0);  // +1, −1, +2, −2, …
    const bool sound = parameters.track.failed_fasteners.empty();
    for (auto* lines : {&track.passing, &track.excess})
        if (!lines->empty() && orders.size() == 2 * lines->size()) settle(*lines, orders, transfers, sound, sweeps);
}

}  // namespace railpem::pem
