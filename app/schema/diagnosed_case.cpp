#include "app/schema/diagnosed_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/schema/case_file.hpp"
#include "spectra/irregularity_spectrum.hpp"

namespace railpem::app {

namespace {

constexpr int kPointsPerDecade = 60;
constexpr double kBesideEdge = 1e-6;  ///< a band's edge is a jump: two points so close to each other

struct Ends {
    double longest = 0.0, shortest = 1e300;
};

Ends ends_of(const spectra::IrregularityParameters& irregularity) {
    Ends ends;
    for (const spectra::IrregularityBand& band : irregularity.bands) {
        ends.longest = std::max(ends.longest, band.longest_wavelength_m);
        ends.shortest = std::min(ends.shortest, band.shortest_wavelength_m);
    }
    return ends;
}

}  // namespace

std::string irregularity_text(const pem::CaseParameters& numbers) {
    spectra::IrregularityParameters broadband = numbers.irregularity;
    broadband.corrugation.clear();
    const Ends ends = ends_of(broadband);
    const double low = 1.0 / ends.longest, high = 1.0 / ends.shortest;
    std::set<double> waves;
    const int count = static_cast<int>(kPointsPerDecade * std::log10(high / low));
    for (int i = 0; i <= count; ++i) waves.insert(low * std::pow(high / low, static_cast<double>(i) / count));
    for (const spectra::IrregularityBand& band : broadband.bands)
        for (const double edge : {band.longest_wavelength_m, band.shortest_wavelength_m})
            for (const double side : {1.0 - kBesideEdge, 1.0 + kBesideEdge}) waves.insert(side / edge);
    std::string text = "cycles_per_m,psd_m3\n";
    for (const double n : waves)
        if (const double psd = spectra::irregularity_psd_m3(broadband, n); psd > 0.0)
            text += fmt::format("{:.12g},{:.9g}\n", n, psd);
    return text;
}

std::string diagnosed_case_text(const diagnosis::Diagnosis& diagnosis) {
    pem::CaseParameters numbers = diagnosis.diagnosed_numbers;
    const Ends ends = ends_of(numbers.irregularity);
    spectra::IrregularityBand table{
        .family = spectra::Family::table, .shortest_wavelength_m = ends.shortest, .longest_wavelength_m = ends.longest};
    table.file = kDiagnosedIrregularity;
    numbers.irregularity.bands = {table};
    numbers.irregularity.level_db = numbers.irregularity.slope_db_per_octave = 0.0;
    numbers.irregularity.wave_correction = {};
    numbers.irregularity.frequency_correction = {};
    numbers.solver.moving = true;
    numbers.title += numbers.title.empty() ? "as diagnosed" : ", as diagnosed";
    return write_case(numbers, diagnosis.diagnosed_effects);
}

}  // namespace railpem::app
