#include "pem/passing_modulation.hpp"

#include <algorithm>
#include <cmath>

#include "pem/solution.hpp"
#include "pem/wheel_transfers.hpp"
#include "track/seat_stiffness.hpp"

namespace railpem::pem {

namespace {

using Phasor = std::complex<double>;

double strength(const std::array<Phasor, 4>& under_wheels) {
    double sum = 0.0;
    for (const Phasor& own : under_wheels) sum += std::norm(own);
    return std::sqrt(sum);
}

std::size_t period_of(const CaseParameters& parameters) {
    const auto& failed = parameters.track.failed_fasteners;
    return failed.empty() ? 1 : static_cast<std::size_t>(std::max(1, failed.front().every));
}

/// What the lines say of the track: m per N of constant load, without the factor by which the case has the lines of whole bays.
std::vector<std::array<Phasor, 4>> compliances(const CaseParameters& parameters, const TrackExcitation& track) {
    const std::size_t period = period_of(parameters);
    std::vector<std::array<Phasor, 4>> result;
    for (std::size_t line = 0; line < track.deflection.size(); ++line) {
        const bool whole_bay = (line + 1) % period == 0;
        const double scale = 0.5 / (track.wheel_load_n * (whole_bay && track.amplitude_factor != 0.0 ? track.amplitude_factor : 1.0));
        result.push_back(track.deflection[line].amplitude_m);
        for (Phasor& own : result.back()) own *= scale;
    }
    return result;
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

Phasor between(const std::vector<Phasor>& values, const Place& at) { return at.between(values[at.below], values[at.below + 1]); }

/// How strongly a force at one frequency is heard at another.
Phasor passed_on(const ModulationTransfers& transfers, bool of_differing_seats, double from, double to) {
    const Place in(transfers, from), out(transfers, to);
    const Phasor share_in = between(transfers.seat_share, in), share_out = between(transfers.seat_share, out);
    if (!of_differing_seats) return share_in + share_out;
    return 0.5 * (share_in * between(transfers.receptance, out) + share_out * between(transfers.receptance, in));
}

/// Forces under the wheels for given irregularities under them.
std::array<Phasor, 4> forces_of(const ModulationTransfers& transfers, double frequency, const std::array<Phasor, 4>& irregularity) {
    const Place at(transfers, frequency);
    const std::array<Phasor, 16>&low = transfers.force[at.below], &high = transfers.force[at.below + 1];
    // Below the first line a vehicle that rises and falls with the track has forces with the square of the frequency, and the irregularity has most of its power.
    const double rise = std::min(1.0, std::pow(frequency / ModulationTransfers::kStep_hz, 2));
    std::array<Phasor, 4> result{};
    for (std::size_t wheel = 0; wheel < 4; ++wheel)
        for (std::size_t j = 0; j < 4; ++j) result[wheel] += rise * at.between(low[wheel * 4 + j], high[wheel * 4 + j]) * irregularity[j];
    return result;
}

/// Forces under the wheels per unit of a source that the wheels meet one after the other.
std::array<Phasor, 4> delayed_forces(const ModulationTransfers& transfers, const DelayedSpectrum& source, const std::vector<double>& wheels, double speed, double frequency) {
    std::array<Phasor, 4> delay;
    for (std::size_t j = 0; j < 4; ++j) delay[j] = source.share[j] * delay_phase(wheels, j, frequency, speed);
    return forces_of(transfers, frequency, delay);
}

}  // namespace

ModulationTransfers modulation_transfers(const CaseParameters& parameters, const CoupledModel& model) {
    constexpr double step = ModulationTransfers::kStep_hz;
    const auto lines = std::max<std::size_t>(2, static_cast<std::size_t>(parameters.frequency.to_hz / step));
    std::vector<std::size_t> responses;
    for (const char* wheel : {"contact_1", "contact_2", "contact_3", "contact_4"}) responses.push_back(response_index(wheel));
    std::vector<RailGroup> rails = rail_groups(model, step, step, lines, 1, 1);
    const WheelTransfers solved = wheel_transfers(model, step, step, lines, responses, 1, &rails);
    const track::PadParameters& pads = parameters.track.pads;
    const double pad_n_per_m = pads.dynamic_to_static_ratio * pads.static_stiffness_n_per_m;
    ModulationTransfers transfers{.force = std::vector<std::array<Phasor, 16>>(lines), .receptance = {}, .seat_share = {}};
    for (std::size_t line = 0; line < lines; ++line) {
        std::copy_n(solved.at(line), 16, transfers.force[line].begin());
        const Phasor receptance = rails[line / lanes::width].rail[0][0][static_cast<int>(line % lanes::width)];
        transfers.receptance.push_back(receptance);
        transfers.seat_share.push_back(receptance * track::seat_stiffness(parameters.track, pad_n_per_m, 1.0, static_cast<double>(line + 1) * step));
    }
    return transfers;
}

std::vector<Modulation> modulations(const CaseParameters& parameters, const TrackExcitation& track, const ModulationTransfers& transfers, double least) {
    const std::vector<std::array<Phasor, 4>> compliance = compliances(parameters, track);
    double strongest = 0.0;
    for (const auto& own : compliance) strongest = std::max(strongest, strength(own));
    std::vector<Modulation> both_sides;
    for (std::size_t line = 0; line < compliance.size(); ++line) {
        if (strongest == 0.0 || strength(compliance[line]) < least * strongest) continue;
        const double shift_hz = track.deflection[line].frequency_hz;
        const bool differ = (line + 1) % period_of(parameters) != 0;
        const Phasor share = passed_on(transfers, differ, differ ? shift_hz : 0.0, shift_hz);
        Modulation up{.shift_hz = shift_hz, .of_differing_seats = differ}, down{.shift_hz = -shift_hz, .of_differing_seats = differ};
        for (std::size_t wheel = 0; wheel < 4; ++wheel) {
            up.compliance_m_per_n[wheel] = compliance[line][wheel] / share;
            down.compliance_m_per_n[wheel] = std::conj(up.compliance_m_per_n[wheel]);
        }
        both_sides.push_back(up);
        both_sides.push_back(down);
    }
    return both_sides;
}

void feed_back_lines(const CaseParameters& parameters, const ModulationTransfers& transfers, TrackExcitation& track, int sweeps) {
    const std::vector<Modulation> orders = modulations(parameters, track, transfers, 0.0);  // +1, −1, +2, −2, …
    const int highest = static_cast<int>(track.passing.size());
    if (orders.size() != 2 * track.passing.size()) return;
    const bool sound = parameters.track.failed_fasteners.empty();
    const double line_hz = highest > 0 ? track.passing.front().frequency_hz : 0.0;
    const std::vector<SpectralLine> alone = track.passing;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        std::vector<std::array<Phasor, 4>> force;  // of the lines 1, 2, …
        for (const SpectralLine& line : track.passing) force.push_back(forces_of(transfers, line.frequency_hz, line.amplitude_m));
        for (int m = 1; m <= highest; ++m) {
            std::array<Phasor, 4> sum = alone[static_cast<std::size_t>(m - 1)].amplitude_m;
            for (int n = -highest; n <= highest; ++n) {
                const int order = m - n;
                if (n == 0 || order == 0 || std::abs(order) > highest || (sound && n == 1)) continue;
                const Modulation& modulation = orders[static_cast<std::size_t>(2 * (std::abs(order) - 1) + (order < 0 ? 1 : 0))];
                const Phasor share = passed_on(transfers, modulation.of_differing_seats, n * line_hz, m * line_hz);
                for (std::size_t wheel = 0; wheel < 4; ++wheel) {
                    const Phasor own = force[static_cast<std::size_t>(std::abs(n) - 1)][wheel];
                    sum[wheel] += share * modulation.compliance_m_per_n[wheel] * (n < 0 ? std::conj(own) : own);
                }
            }
            track.passing[static_cast<std::size_t>(m - 1)].amplitude_m = sum;
        }
    }
}

LineSet sidebands(const std::vector<Modulation>& orders, const ModulationTransfers& transfers, const LineSet& lines) {
    LineSet beside{.name = lines.name, .lines = {}};
    for (const SpectralLine& line : lines.lines) {
        const std::array<Phasor, 4> force = forces_of(transfers, line.frequency_hz, line.amplitude_m);
        for (const Modulation& order : orders) {
            const double to = line.frequency_hz + order.shift_hz;
            const Phasor share = passed_on(transfers, order.of_differing_seats, line.frequency_hz, to);
            SpectralLine own{.frequency_hz = std::abs(to), .amplitude_m = {}};
            for (std::size_t wheel = 0; wheel < 4; ++wheel) {
                const Phasor felt = share * order.compliance_m_per_n[wheel] * force[wheel];
                own.amplitude_m[wheel] = to < 0.0 ? std::conj(felt) : felt;
            }
            beside.lines.push_back(own);
        }
    }
    return beside;
}

std::array<Phasor, 4> modulated_irregularity(const Modulation& modulation, const ModulationTransfers& transfers, const DelayedSpectrum& source,
                                             const std::vector<double>& wheels, double speed, double frequency) {
    const double from = frequency - modulation.shift_hz;
    if (from == 0.0) return {};
    std::array<Phasor, 4> felt = delayed_forces(transfers, source, wheels, speed, from);
    const Phasor factor = std::sqrt(source.psd_m2_per_hz(std::abs(from))) * passed_on(transfers, modulation.of_differing_seats, from, frequency);
    for (std::size_t wheel = 0; wheel < 4; ++wheel) felt[wheel] *= factor * modulation.compliance_m_per_n[wheel];
    return felt;
}

}  // namespace railpem::pem
