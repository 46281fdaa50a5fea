#include "spectra/validity.hpp"

#include <fmt/format.h>

#include "spectra/spectrum_families.hpp"

namespace railpem::spectra {

std::vector<std::string> validity_warnings(const IrregularityParameters& irregularity) {
    constexpr double rounding = 1e-6;  // a limit typed with six digits is the limit
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < irregularity.bands.size(); ++i) {
        const IrregularityBand& band = irregularity.bands[i];
        const WavelengthRange valid = valid_wavelengths(band);
        if (band.shortest_wavelength_m >= valid.shortest_m * (1.0 - rounding) &&
            band.longest_wavelength_m <= valid.longest_m * (1.0 + rounding))
            continue;
        const char* beyond =
            band.family == Family::table ? "beyond them there is no irregularity" : "beyond them it is extrapolated";
        warnings.push_back(fmt::format(
            "{} goes from {:g} to {:g} m, its family was measured for wavelengths of {:.4g} to {:.4g} m; {}",
            element_key("band", i), band.shortest_wavelength_m, band.longest_wavelength_m, valid.shortest_m,
            valid.longest_m, beyond));
    }
    return warnings;
}

}  // namespace railpem::spectra
