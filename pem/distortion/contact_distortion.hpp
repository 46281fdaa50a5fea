#pragma once
// What a Hertzian contact adds to the linear response: it stiffens under the load of every moment.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "pem/case_parameters.hpp"
#include "pem/distortion/second_order.hpp"

namespace railpem::pem {

/// where forces vary by a quarter of the static load, 0.3 % of what Hertz distorts lies beyond, 5 to 10 % of two to
/// five times that nonlinearity
inline constexpr int kHighestOrder = 6;
using ApproachOrders = Eigen::Array<double, kHighestOrder - 1, 1>;

/// What the contacts distort, all but the nonlinearity. Under a load P0 + F(t) with Gaussian F of deviation σ wheel and
/// rail approach by δ0·y(1 + F/P0) (contact_approach()) = Σ c_n·He_n(F/σ); the first two are the static approach and
/// the linearised compliance, the rest acts like an irregularity under the wheel, with cross-spectra n!·c_n² times
/// those of the n-th powers of the correlation (Mehler 1866).
struct ContactDistortion {
    double force_variation = 0.0;    ///< σ/P0, of the four wheels
    double static_approach_m = 0.0;  ///< δ0 = G·P0^{2/3} (Wei et al. 2016, (7))
    /// share of the Hertzian one that the case has; 0: linear, and Hertz is taken, because that is what real contacts
    /// are
    double nonlinearity = 0.0;
    /// [order − 2][contrast][Hz]: contrasts_of_powers() of the forces over σ; none: no distortion
    std::vector<std::vector<std::vector<double>>> power;
};

/// `force_power_ratio`: by how much more power the contact forces have at a frequency than the case says; a recording
/// knows. Excitation above v/(shortest wave) is none.
ContactDistortion contact_distortion(const CaseParameters& parameters, double speed_m_per_s,
                                     const std::function<double(double frequency_hz)>& force_power_ratio);

/// √n!·c_n/δ0 from n = 2 on: whose squares are what each order holds of the variance of the approach, over δ0².
ApproachOrders approach_orders(double nonlinearity, double force_variation);

/// The sources of the contacts of a case under these forces, as second_order.hpp has them. A case with another
/// nonlinearity has its own static approach, too. Otherwise that is held: a fit that could soften the contact had a
/// noise that explains anything (1.6 times the nonlinearity went into the contact's constant and the rail's numbers).
std::vector<DelayedSpectrum> distortion_sources(const ContactDistortion& distortion, const CaseParameters& parameters);

/// rms of the contact force beyond its static part, over that, of the wheel where it is largest; of all waves to the
/// shortest, by steps of 1 Hz. From about a quarter on wheels leave the rail now and then, and no order of the
/// contact's law describes that.
double contact_force_variation(const CaseParameters& parameters, double speed_m_per_s);

}  // namespace railpem::pem
