#pragma once

#include "simulate/vehicle/vehicle_model.hpp"

namespace railpem::simulate {

/// Wheel–rail contact P(δ), δ the approach of the two bodies (positive in compression).
///
/// Hertz: P = (δ/G)^{3/2}, nothing in tension. With another share φ of its nonlinearity P = L + φ·(H − L), H Hertz's
/// law and L its tangent at the static load P0; never tensile. For φ > 1 this would turn upwards again before the
/// contact opens: from where its slope vanishes down to δ = 0 it is replaced by the chord to zero.
struct ContactLaw {
    double constant_m_per_n23 = 0.0;  ///< G
    double static_load_n = 0.0;       ///< P0
    double nonlinearity = 1.0;        ///< φ; 0: linear and able to pull, as the frequency domain has it
};

/// δ at the static load, m.
double static_approach(const ContactLaw& law);

/// Stiffness at the static load, K_h = 3/2·P0^{1/3}/G, N/m (Wei et al. 2016, eq. 8).
double contact_stiffness(const ContactLaw& law);

ForceAndSlope contact_force(const ContactLaw& law, double approach_m);

/// G of a worn tread for the wheel's radius, m/N^(2/3).
double worn_tread_constant(double wheel_radius_m);

}  // namespace railpem::simulate
