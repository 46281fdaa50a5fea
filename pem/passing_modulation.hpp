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
    std::vector<std::complex<double>> seat_share;             ///< K·C: stiffness of a seat times the rail's receptance under wheel 1

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
/// This is parametric excitation to first order (Sheng, Jones & Thompson 2005, J. Sound Vib. 282, have the whole). Left out are what the modulated forces do in their turn and what those of the neighbouring
/// wheel do; for fasteners that have failed the dependence on frequency is that of sound ones.
struct Modulation {
    double shift_hz = 0.0;                                ///< mv/spacing, of either sign
    std::array<std::complex<double>, 4> compliance_m_per_n{};  ///< γ_m/[K·C(0) + K·C(mv/spacing)] under each wheel
};

/// Both sides of every line of `track` that is at least `least` of the strongest. The amplitude factor of the case does not count: it is the lines' alone.
std::vector<Modulation> modulations(const CaseParameters& parameters, const TrackExcitation& track, const ModulationTransfers& transfers, double least);

/// The pseudo-irregularity under the four wheels at a frequency that a modulation makes of a broadband source, m/√Hz.
std::array<std::complex<double>, 4> modulated_irregularity(const Modulation& modulation, const ModulationTransfers& transfers, const DelayedSpectrum& source,
                                                           const std::vector<double>& wheels_m, double speed_m_per_s, double frequency_hz);

}  // namespace railpem::pem
