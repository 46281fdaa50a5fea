#pragma once

#include "pem/contact_parameters.hpp"

namespace railpem::pem {

/// Contact constant G in m/N^(2/3): the stated one, or that of a worn tread, G = 3.86e-8·R^(−0.115) with the wheel
/// radius R in m (Zhai, Vehicle–Track Coupled Dynamics; new conical treads have 4.57e-8·R^(−0.149)).
double contact_constant(const ContactParameters& contact, double wheel_radius_m);

/// Linear contact stiffness K_h = 3/2·P0^{1/3}/G in N/m under the static load P0 in N (Wei et al. 2016, eq. 8).
double contact_stiffness(double constant_m_per_n23, double wheel_load_n);

/// Approach of wheel and rail over that under the static load, where the contact carries `load_ratio` of that load: the
/// inverse of P/P0 = φ·y^{3/2} + (1 − φ)·(3y − 1)/2, the Hertzian law with the share φ ≥ 0 of its nonlinearity (1:
/// Hertz, 0: linear). Where φ > 1 would turn it back at small loads it goes straight to nothing. Loads below none are
/// none.
double contact_approach(double nonlinearity, double load_ratio);

/// Factor by which a contact patch of half length a lowers the amplitude of waves of wavenumber κ (rad/m):
/// (1 + π/4·(κa)³)^{−1/2} (Remington 1987, circular patch).
double contact_filter(double patch_half_length_m, double wavenumber_rad_per_m);

}  // namespace railpem::pem
