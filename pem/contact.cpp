#include "pem/contact.hpp"

#include <algorithm>
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

double contact_approach(double nonlinearity, double load_ratio) {
    const double load = std::max(0.0, load_ratio);
    if (nonlinearity == 0.0) return (2.0 * load + 1.0) / 3.0;
    if (nonlinearity == 1.0) return std::cbrt(load * load);
    const auto carried = [&](double y) {
        return nonlinearity * y * std::sqrt(y) + (1.0 - nonlinearity) * 0.5 * (3.0 * y - 1.0);
    };
    if (nonlinearity > 1.0) {
        const double turn = std::pow((nonlinearity - 1.0) / nonlinearity, 2);  // where the slope vanishes
        if (load < carried(turn)) return turn * load / carried(turn);
    }
    // on the tangent at rest, beyond the root: the law bends upwards, and Newton's steps come down to it
    double y = (2.0 * load + 1.0) / 3.0;
    for (int i = 0; i < 50; ++i) {
        const double step = (carried(y) - load) / (1.5 * (nonlinearity * std::sqrt(y) + 1.0 - nonlinearity));
        y -= step;
        if (std::abs(step) < 1e-14) break;
    }
    return y;
}

double contact_filter(double patch_half_length_m, double wavenumber_rad_per_m) {
    const double x = patch_half_length_m * wavenumber_rad_per_m;
    return 1.0 / std::sqrt(1.0 + 0.25 * std::numbers::pi * x * x * x);
}

}  // namespace railpem::pem
