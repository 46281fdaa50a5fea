#pragma once

#include <array>

namespace railpem::pem {

/// How the equivalent linear elements were found.
struct Linearisation {
    int iterations = 0;
    double change = 0.0;  ///< largest relative change of an equivalent element in the last iteration
    std::array<double, 4> primary_velocity_m_per_s{};    ///< rms velocity across each primary element
    std::array<double, 2> secondary_velocity_m_per_s{};  ///< and each secondary
    std::array<double, 4> contact_compression_m{};       ///< rms of the contact compression about its mean
    /// share of time without contact under the Gaussian assumption
    std::array<double, 4> loss_of_contact_probability{};
};

}  // namespace railpem::pem
