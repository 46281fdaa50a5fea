#include "simulate/track/beam_element.hpp"

#include <array>
#include <cmath>

namespace railpem::simulate {

namespace {

/// Φ = 12·EI/(κGA·l²), the ratio of shear to bending flexibility.
double shear_ratio(const Section& section, double length) {
    return 12.0 * section.bending_rigidity_n_m2 * section.shear_flexibility_per_n / (length * length);
}

}  // namespace

Section section_of(const track::RailParameters& rail) {
    Section section{.bending_rigidity_n_m2 = rail.youngs_modulus_pa * rail.second_moment_of_area_m4,
                    .shear_flexibility_per_n = 0.0,
                    .mass_kg_per_m = rail.mass_kg_per_m,
                    .rotary_inertia_kg_m = 0.0};
    if (rail.beam == track::Beam::timoshenko) {
        section.shear_flexibility_per_n =
            1.0 / (rail.shear_coefficient * rail.shear_modulus_pa * rail.cross_section_m2);
        section.rotary_inertia_kg_m = rail.mass_kg_per_m * rail.second_moment_of_area_m4 / rail.cross_section_m2;
    }
    return section;
}

Eigen::Matrix4d element_stiffness(const Section& section, double l) {
    const double phi = shear_ratio(section, l);
    Eigen::Matrix4d k;
    k << 12.0, 6.0 * l, -12.0, 6.0 * l,                               //
        6.0 * l, (4.0 + phi) * l * l, -6.0 * l, (2.0 - phi) * l * l,  //
        -12.0, -6.0 * l, 12.0, -6.0 * l,                              //
        6.0 * l, (2.0 - phi) * l * l, -6.0 * l, (4.0 + phi) * l * l;
    return k * (section.bending_rigidity_n_m2 / (l * l * l * (1.0 + phi)));
}

Eigen::Vector4d displacement_shape(const Section& section, double l, double at) {
    const double phi = shear_ratio(section, l);
    const double x = at / l;
    const double x2 = x * x;
    const double x3 = x2 * x;
    const Eigen::Vector4d n(1.0 - 3.0 * x2 + 2.0 * x3 + phi * (1.0 - x), l * (x - 2.0 * x2 + x3 + 0.5 * phi * (x - x2)),
                            3.0 * x2 - 2.0 * x3 + phi * x, l * (x3 - x2 - 0.5 * phi * (x - x2)));
    return n / (1.0 + phi);
}

Eigen::Vector4d rotation_shape(const Section& section, double l, double at) {
    const double phi = shear_ratio(section, l);
    const double x = at / l;
    const double x2 = x * x;
    const Eigen::Vector4d n(6.0 / l * (x2 - x), 1.0 - 4.0 * x + 3.0 * x2 + phi * (1.0 - x), 6.0 / l * (x - x2),
                            3.0 * x2 - 2.0 * x + phi * x);
    return n / (1.0 + phi);
}

Eigen::Matrix4d element_mass(const Section& section, double l) {
    // Four Gauss points integrate the products of cubics (degree 6) exactly.
    constexpr std::array<double, 4> point{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                          0.8611363115940526};
    constexpr std::array<double, 4> weight{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                           0.3478548451374538};
    Eigen::Matrix4d mass = Eigen::Matrix4d::Zero();
    for (std::size_t i = 0; i < point.size(); ++i) {
        const double at = 0.5 * l * (1.0 + point[i]);
        const Eigen::Vector4d w = displacement_shape(section, l, at);
        const Eigen::Vector4d theta = rotation_shape(section, l, at);
        mass += 0.5 * l * weight[i] *
                (section.mass_kg_per_m * w * w.transpose() + section.rotary_inertia_kg_m * theta * theta.transpose());
    }
    return mass;
}

double compliance_between_nodes(const Section& section, double l, double at) {
    const double a = at;
    const double b = l - at;
    if (a < 1e-9 * l || b < 1e-9 * l) return 0.0;
    const double ei = section.bending_rigidity_n_m2;
    const double phi_a = shear_ratio(section, a);
    const double phi_b = shear_ratio(section, b);
    const double e_a = ei / (1.0 + phi_a);
    const double e_b = ei / (1.0 + phi_b);
    const double force = 12.0 * (e_a / (a * a * a) + e_b / (b * b * b));
    const double couple = 6.0 * (e_b / (b * b) - e_a / (a * a));
    const double moment = (4.0 + phi_a) * e_a / a + (4.0 + phi_b) * e_b / b;
    return moment / (force * moment - couple * couple);
}

}  // namespace railpem::simulate
