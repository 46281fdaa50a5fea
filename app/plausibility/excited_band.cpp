#include "app/plausibility/excited_band.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "pem/coupling/track_response.hpp"
#include "spectra/integrate_psd.hpp"
#include "spectra/irregularity_spectrum.hpp"

namespace railpem::app {

namespace {

constexpr int kLines = 4000;  ///< over four decades 1000 a decade: 2e-6 of a spectrum that falls with n^4
constexpr double kBesideBandEdge = 1e-9;

/// Equal ratios, with the edges of the bands of wavelengths on either side.
std::vector<double> lines_with_edges(const pem::CaseParameters& parameters, double speed, double low, double high) {
    std::vector<double> lines = pem::geometric_lines(low, high, kLines);
    for (const spectra::IrregularityBand& band : parameters.irregularity.bands)
        for (const double wavelength : {band.shortest_wavelength_m, band.longest_wavelength_m})
            for (const double side : {1.0 - kBesideBandEdge, 1.0 + kBesideBandEdge}) {
                const double edge = speed / wavelength * side;
                if (edge > low && edge < high) lines.push_back(edge);
            }
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    return lines;
}

}  // namespace

ExcitedBand excited_band(const pem::CaseParameters& parameters, double speed, double low, double high) {
    const std::vector<double> lines = lines_with_edges(parameters, speed, low, high);
    std::vector<double> psd;
    for (const double f : lines) psd.push_back(spectra::irregularity_psd_m2_per_hz(parameters.irregularity, f, speed));
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    ExcitedBand band{kNone, kNone, spectra::root_mean_square(lines, psd)};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (psd[i] <= 0.0) continue;
        if (std::isnan(band.from_hz)) band.from_hz = lines[i];
        band.to_hz = lines[i];
    }
    return band;
}

}  // namespace railpem::app
