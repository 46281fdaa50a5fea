#pragma once

#include "parameters/field.hpp"

namespace railpem::pem {

/// Hertzian contact of wheel and rail, P = (δ/G)^{3/2} (Wei et al. 2016, eqs. 4 to 8).
struct ContactParameters {
    /// G; 0: worn tread, G = 3.86e-8·R^(−0.115) m/N^(2/3).
    double constant_m_per_n23 = 0.0;
    /// Share of the contact's nonlinearity that is felt: 0 linear with K_h = 3/2·P0^{1/3}/G, 1 the Hertz law itself.
    double nonlinearity_factor = 0.0;
    /// Half length of the contact patch that averages short waves (Remington 1987); 0: a point.
    double patch_half_length_m = 0.0;
};

parameters::Fields<ContactParameters> contact_fields();

}  // namespace railpem::pem
