#include "track/elements/static_beam_element.hpp"

namespace railpem::track {

Eigen::Matrix4d element_stiffness(const StaticBeamElement& element) {
    const double h = element.length_m, phi = element.shear_parameter;
    Eigen::Matrix4d k;
    k << 12.0, 6.0 * h, -12.0, 6.0 * h,                               //
        6.0 * h, (4.0 + phi) * h * h, -6.0 * h, (2.0 - phi) * h * h,  //
        -12.0, -6.0 * h, 12.0, -6.0 * h,                              //
        6.0 * h, (2.0 - phi) * h * h, -6.0 * h, (4.0 + phi) * h * h;
    return k * (element.bending_stiffness_n_m2 / ((1.0 + phi) * h * h * h));
}

Eigen::Vector4d element_shape(const StaticBeamElement& element, double share) {
    const double h = element.length_m, phi = element.shear_parameter, x = share, y = 1.0 - share;
    const Eigen::Vector4d shape(y * y * (1.0 + 2.0 * x) + phi * y, h * x * y * (y + 0.5 * phi),
                                x * x * (1.0 + 2.0 * y) + phi * x, -h * x * y * (x + 0.5 * phi));
    return shape / (1.0 + phi);
}

Eigen::Vector4d element_uniform_load(const StaticBeamElement& element) {
    const double h = element.length_m;
    return {h / 2.0, h * h / 12.0, h / 2.0, -h * h / 12.0};
}

}  // namespace railpem::track
