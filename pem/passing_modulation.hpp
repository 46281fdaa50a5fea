#pragma once
// What the supports make of the irregularity's forces: the rail under a rolling wheel gives way by more and by less, bay by bay.

#include <array>
#include <complex>
#include <vector>

#include "pem/excitation.hpp"

namespace railpem::pem {

/// What of the linear response the modulation asks for, at kStep_hz, 2·kStep_hz, …: smooth, straight between the lines. Near the modes of body and bogie, where the forces are not, they are small.
struct ModulationTransfers {
    static constexpr double kStep_hz = 2.0;
    std::vector<std::array<std::complex<double>, 16>> force;  ///< contact forces (compression) per unit irregularity under each of the four wheels, N/m; [wheel·4 + source]
    std::vector<std::complex<double>> receptance;             ///< C: of the rail under wheel 1, m/N
    std::vector<std::complex<double>> seat_share;             ///< K·C: stiffness of a seat times that

    bool empty() const { return force.empty(); }
};

/// Up to the end of the case's frequencies. `model` is linearised; one thread.
ModulationTransfers modulation_transfers(const CaseParameters& parameters, const CoupledModel& model);

/// One order of the periodic deflection, on one side.
///
/// A wheel that rolls over supports feels r(t) = γ(t)·P0, γ(t) = Σ_m γ_m·e^{imΩt} what the rail gives way per unit of force, Ω = 2πv/spacing; passing_lines() has 2·P0·γ_m. The forces F of
/// irregularity meet the same γ: F at f' is heard at f = f' + mv/spacing. Irregularity being stationary, what comes from different frequencies is independent: every order and either side of it is a
/// source of its own, with the power |γ_m|²·S_F(f') and the phases of the wheels.
/// γ_m comes about twice: the rail moves with F at f', and its shape between the seats, which carry K·C(f') of it, is read by the wheel; and the force between the seats moves the rail at f, by
/// K·C(f). So γ_m(f', f) = γ_m·[K·C(f') + K·C(f)]/[K·C(0) + K·C(mv/spacing)].
/// Where seats differ, at fasteners that have failed, the rail scatters there: γ_m(f', f) = γ_m·½[K·C(f')·C(f) + K·C(f)·C(f')]/[K·C²(mv/spacing)], as passing_lines() has the standing load at the frequency
/// of the line.
/// This is parametric excitation to first order (Sheng, Jones & Thompson 2005, J. Sound Vib. 282, have the whole). Left out are what the modulated forces do in their turn and what those of the neighbouring
/// wheel do.
struct Modulation {
    double shift_hz = 0.0;                                ///< mv/spacing, of either sign
    bool of_differing_seats = false;
    std::array<std::complex<double>, 4> compliance_m_per_n{};  ///< γ_m under each wheel, without the brackets above
};

/// Both sides of every line of `track` that is at least `least` of the strongest. The amplitude factor of the case does not count: it is the lines' alone.
std::vector<Modulation> modulations(const CaseParameters& parameters, const TrackExcitation& track, const ModulationTransfers& transfers, double least);

/// The pseudo-irregularity under the four wheels at a frequency that a modulation makes of a broadband source, m/√Hz.
std::array<std::complex<double>, 4> modulated_irregularity(const Modulation& modulation, const ModulationTransfers& transfers, const DelayedSpectrum& source,
                                                           const std::vector<double>& wheels_m, double speed_m_per_s, double frequency_hz);

/// What a modulation makes of the lines of a wheel out of round: beside each of them one at f + mv/spacing for every order and either side, 40 dB below a line that may itself stand 30 dB above all else.
/// A frequency below zero is its conjugate above.
LineSet sidebands(const std::vector<Modulation>& orders, const ModulationTransfers& transfers, const LineSet& lines);

/// Adds to the lines of passing supports what the forces of the lines make of each other: r_m += Σ_n γ_{m−n}·F_n, in sweeps. Of sound fasteners without what feed_back() has more exactly, the
/// first line's share in the higher ones.
void feed_back_lines(const CaseParameters& parameters, const ModulationTransfers& transfers, TrackExcitation& track, int sweeps = 6);

}  // namespace railpem::pem
