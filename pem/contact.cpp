#include "pem/contact.hpp"

#include <cmath>
#include <numbers>

namespace railpem::pem {

double contact_constant(const ContactParameters& contact, double wheel_radius_m) {
    if (contact.constant_m_per_n23 > 0.0) return contact.constant_m_per_n23;
    return 3.86e-8 * std::pow(wheel_radius_m, -0.115);
}

double contact_stiffness(double constant_m_per_n23, double wheel_load_n) {
    return 1.5 * std::cbrt(wheel_load_n) / constant_m_per_n23;
}

double contact_filter(double patch_half_length_m, double wavenumber_rad_per_m) {
    const double x = patch_half_length_m * wavenumber_rad_per_m;
    return 1.0 / std::sqrt(1.0 + 0.25 * std::numbers::pi * x * x * x);
}

}  // namespace railpem::pem
