#pragma once
// What a Hertzian contact adds to the linear response: it stiffens under the load of every moment.

#include <functional>

#include "pem/case_parameters.hpp"
#include "pem/second_order.hpp"

namespace railpem::pem {

/// Second-order distortion of the contacts. Under a load P0 + F(t) wheel and rail approach by δ = G·(P0 + F)^{2/3} = δ0 + F/K_H + ½κF² with κ = −(2/9)·G·P0^{−4/3} (Wei et al. 2016, (7)); the
/// last term acts like an irregularity under the wheel, sources as second_order.hpp has them. `force_power_ratio`: by how much more power the contact forces have at a frequency than
/// the case says; a recording knows. Third order is left out. Excitation above v/(shortest wave) is none.
std::vector<DelayedSpectrum> contact_distortion(const CaseParameters& parameters, double speed_m_per_s, const std::function<double(double frequency_hz)>& force_power_ratio);

/// rms of the contact force beyond its static part, over that, of the wheel where it is largest; of all waves to the shortest, by steps of 1 Hz. From about a quarter on wheels leave the rail now and then, and no order of
/// the contact's law describes that.
double contact_force_variation(const CaseParameters& parameters, double speed_m_per_s);

}  // namespace railpem::pem
