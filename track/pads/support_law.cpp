#include "track/pads/support_law.hpp"

#include <cassert>
#include <numbers>

namespace railpem::track {

namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

}  // namespace

std::complex<double> support_receptance(const SupportParameters& support, double frequency_hz,
                                        const lanes::FactorCurve& factor) {
    assert(frequency_hz > 0.0);
    if (support.model == SupportModel::rigid) return 0.0;
    const double omega = two_pi * frequency_hz;
    std::complex<double> spring(support.stiffness_n_per_m,
                                support.stiffness_n_per_m * support.loss_factor + omega * support.damping_n_s_per_m);
    if (!factor.empty()) spring *= factor.at(omega);
    std::complex<double> receptance = 1.0 / (spring - omega * omega * support.mass_kg);
    for (const SleeperMode& mode : support.bending_modes) {
        const double omega_n = two_pi * mode.frequency_hz;
        const std::complex<double> beam = omega_n * omega_n * std::complex<double>(1.0, mode.loss_factor);
        receptance +=
            1.0 / (mode.modal_mass_kg * (beam - omega * omega) + spring * (mode.modal_mass_kg / support.mass_kg));
    }
    return receptance;
}

lanes::Complex support_receptance(const SupportParameters& support, lanes::Real omega,
                                  const lanes::FactorCurve& factor) {
    if (support.model == SupportModel::rigid) return {};
    const lanes::Real omega2 = omega * omega;
    lanes::Complex spring(lanes::broadcast(support.stiffness_n_per_m),
                          support.stiffness_n_per_m * support.loss_factor + omega * support.damping_n_s_per_m);
    if (!factor.empty()) spring = spring * factor.at(omega);
    lanes::Complex receptance = lanes::reciprocal(spring + (-omega2 * support.mass_kg));
    for (const SleeperMode& mode : support.bending_modes) {
        const double natural2 = two_pi * mode.frequency_hz * two_pi * mode.frequency_hz;
        const lanes::Complex beam(natural2 - omega2, lanes::broadcast(natural2 * mode.loss_factor));
        receptance += lanes::reciprocal(beam * mode.modal_mass_kg + spring * (mode.modal_mass_kg / support.mass_kg));
    }
    return receptance;
}

double static_support_compliance(const SupportParameters& support) {
    if (support.model == SupportModel::rigid) return 0.0;
    double compliance = 1.0 / support.stiffness_n_per_m;
    for (const SleeperMode& mode : support.bending_modes) {
        const double omega_n = two_pi * mode.frequency_hz;
        compliance += 1.0 / (mode.modal_mass_kg * (omega_n * omega_n + support.stiffness_n_per_m / support.mass_kg));
    }
    return compliance;
}

std::complex<double> support_stiffness(std::complex<double> pad_stiffness_n_per_m,
                                       std::complex<double> below_pad_m_per_n) {
    return pad_stiffness_n_per_m / (1.0 + pad_stiffness_n_per_m * below_pad_m_per_n);
}

}  // namespace railpem::track
