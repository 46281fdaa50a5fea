#include "simulate/vehicle/contact_law.hpp"

#include <algorithm>
#include <cmath>

namespace railpem::simulate {

double worn_tread_constant(double wheel_radius_m) {
    return 3.86e-8 * std::pow(wheel_radius_m, -0.115);
}

double static_approach(const ContactLaw& law) {
    return law.constant_m_per_n23 * std::cbrt(law.static_load_n * law.static_load_n);
}

double contact_stiffness(const ContactLaw& law) {
    return 1.5 * std::cbrt(law.static_load_n) / law.constant_m_per_n23;
}

ForceAndSlope contact_force(const ContactLaw& law, double approach_m) {
    const double approach_0 = static_approach(law);
    const double stiffness = contact_stiffness(law);
    const double linear = law.static_load_n + stiffness * (approach_m - approach_0);
    if (law.nonlinearity == 0.0) return {linear, stiffness};
    if (approach_m <= 0.0) return {0.0, 0.0};
    const double phi = law.nonlinearity;
    const double y = approach_m / approach_0;
    const auto blended = [&](double at) {  // P/P0 at δ = at·δ0
        return phi * at * std::sqrt(at) + (1.0 - phi) * (1.5 * at - 0.5);
    };
    if (phi > 1.0) {
        const double flat = (phi - 1.0) * (phi - 1.0) / (phi * phi);  // where 3/2·(φ·√y + 1 − φ) vanishes
        if (y < flat) {
            const double slope = law.static_load_n * blended(flat) / (flat * approach_0);
            return {slope * approach_m, slope};
        }
    }
    const double force = law.static_load_n * blended(y);
    if (force <= 0.0) return {0.0, 0.0};
    return {force, stiffness * (phi * std::sqrt(y) + 1.0 - phi)};
}

}  // namespace railpem::simulate
