#pragma once
// What the supports make of the irregularity's forces: the rail under a rolling wheel gives way by more and by less,
// bay by bay.

#include <array>
#include <complex>
#include <vector>

#include "pem/coupling/excitation.hpp"
#include "pem/coupling/rolling_table.hpp"
#include "pem/rail/seat_orders.hpp"

namespace railpem::pem {

/// What the modulation asks of the linear response, at kStep_hz, 2·kStep_hz, …: smooth, straight between the lines.
/// Near the modes of body and bogie, where the forces are not, they are small.
struct ModulationTransfers {
    static constexpr double kStep_hz = 2.0;
    /// contact forces (compression) per unit irregularity under each of the four wheels, N/m; [wheel·4 + source]
    std::vector<std::array<std::complex<double>, 16>> force;
    std::vector<std::complex<double>> receptance;  ///< C: of the rail under wheel 1, m/N
    std::vector<std::complex<double>> seat_share;  ///< K·C: stiffness of a seat times that
    double bay_hz = 0.0;                           ///< v/spacing
    RollingTable rolling;
    std::vector<RailGroup> rails;    ///< on those lines
    SeatPlaceReceptances at_places;  ///< of regularly failed fasteners
    SeatOrders seats;                ///< their orders
};

/// How far the modulation looks: to the end of the case's frequencies and two bay frequencies beyond.
double modulation_end_hz(const CaseParameters& parameters, double speed_m_per_s);

/// `model` is linearised and in motion; one thread. `rolling` reaches as far. `known`: of the same track and speed,
/// with the same table.
ModulationTransfers modulation_transfers(const CaseParameters& parameters, const CoupledModel& model,
                                         double speed_m_per_s, RollingTable rolling,
                                         const ModulationTransfers* known = nullptr);

/// One order of the periodic deflection, on one side.
///
/// A wheel that rolls over supports feels what the rail gives way under each wheel's force, now more, now less, with
/// the period of the bays, Ω = 2πv/spacing: a force at f' is heard at f = f' + mv/spacing, by R_m(f') of
/// track::rolling_receptance(). Irregularity being stationary, what comes from different frequencies is independent:
/// every order and either side of it is a source of its own. Where load stiffens the pads, R_m is larger by the same as
/// the line of passing supports (passing_lines()), which is R_m(0) times the loads. Where every n-th fastener has
/// failed, by the orders of the receptances over their period at the frequency in the middle (SeatOrders,
/// scattered_orders()). Where seats differ at random the rail scatters there: γ_m(f', f) = γ_m·½[K·C(f')·C(f) +
/// K·C(f)·C(f')]/[K·C²(mv/spacing)], as passing_lines() has the standing load at the frequency of the line, 2·P0·γ_m;
/// what neighbouring wheels do there is left out. This is parametric excitation (Sheng, Jones & Thompson 2005, J. Sound
/// Vib. 282).
struct Modulation {
    double shift_hz = 0.0;  ///< of either sign
    int bays = 0;           ///< m; 0 of differing seats
    /// order of the period of regularly failed seats, where SeatOrders has it
    int failures = 0;
    /// of differing seats γ_m without the brackets, m/N; otherwise how many times R_m
    std::array<std::complex<double>, 4> under_wheel{};
};

/// Both sides of every line of `track` that is at least `least` of the strongest; of whole bays without pads that load
/// stiffens also where it has no lines, two on either side. The amplitude factor of the case does not count: it is the
/// lines' alone.
std::vector<Modulation> modulations(const CaseParameters& parameters, const TrackExcitation& track,
                                    const ModulationTransfers& transfers, double least);

/// What seats that failed at random make of the forces, to first order: the deflection r(t) that the standing load
/// leaves there (failed_fastener_amplitudes()) is P0·γ(t), and γ(t)·F(t) is felt, by shifts of any size. Shifts (k +
/// ½)·v/6 m stand for all of them, both sides; that the wheels meet the same seats one after the other is in the
/// phases.
std::vector<Modulation> random_modulations(const TrackExcitation& track, const ModulationTransfers& transfers,
                                           double speed_m_per_s);

/// Irregularity that forces under the wheels at `from_hz` are felt as at from_hz + shift.
std::array<std::complex<double>, 4> felt(const Modulation& modulation, const ModulationTransfers& transfers,
                                         const std::array<std::complex<double>, 4>& force_n, double from_hz);

/// Contact forces per unit irregularity, [wheel·4 + irregularity under], at a frequency of either sign.
std::array<std::complex<double>, 16> forces_at(const ModulationTransfers& transfers, double frequency_hz);

/// Contact forces for irregularities under the wheels, at a frequency of either sign.
std::array<std::complex<double>, 4> forces_of(const ModulationTransfers& transfers, double frequency_hz,
                                              const std::array<std::complex<double>, 4>& irregularity_m);

/// Adds to the lines of passing supports what the forces of the lines make of each other: r_m += Σ_n R_{m−n}·F_n, in
/// sweeps. Of sound fasteners without what feed_back() has more exactly, the first line's share in the higher ones.
void feed_back_lines(const CaseParameters& parameters, const ModulationTransfers& transfers, TrackExcitation& track,
                     int sweeps = 8);

}  // namespace railpem::pem
