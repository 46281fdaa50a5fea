#include "app/schema/irregularity_files.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/run_inputs.hpp"
#include "app/schema/read_table.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/measured_irregularity.hpp"

namespace railpem::app {

using parameters::ParameterError;
using spectra::Family;
using spectra::IrregularityBand;

namespace {

/// A profile of 1000 km at 25 cm and a spectrum of any resolution fit many times.
constexpr recordings::ReadLimits kLimits{.memory_bytes = std::size_t{256} << 20};

recordings::MeasuredIrregularity read_measured(const std::string& file, const IrregularityBand& band) {
    return band.family == Family::profile ? recordings::read_irregularity_profile(file, band.segment_length_m, kLimits)
                                          : recordings::read_irregularity_spectrum(file, kLimits);
}

void read_band(const Document& document, const std::string& key, IrregularityBand& band) {
    const std::string file = (std::filesystem::path(document.name).parent_path() / band.file).string();
    if (!band.table_cycles_per_m.empty() || !band.table_psd_m3.empty())
        throw refused(document,
                      ParameterError(key + ".file", "the table is given both here and as a file", "one of them"));
    note_input(file);
    try {
        recordings::MeasuredIrregularity measured = read_measured(file, band);
        band.table_cycles_per_m = std::move(measured.cycles_per_m);
        band.table_psd_m3 = std::move(measured.psd_m3);
    } catch (const recordings::ReadError& error) {
        if (error.line() > 0)
            throw InputError(
                fmt::format("{}:{}: {}\nallowed: {}", error.file(), error.line(), error.problem(), error.allowed()));
        throw refused(document, ParameterError(key + ".file", file + ": " + error.problem(), error.allowed()));
    }
    band.family = Family::table;
    band.file.clear();
    band.segment_length_m = 0.0;
}

}  // namespace

void read_irregularity_files(const Document& document, spectra::IrregularityParameters& irregularity) {
    for (std::size_t i = 0; i < irregularity.bands.size(); ++i) {
        IrregularityBand& band = irregularity.bands[i];
        const bool measured = band.family == Family::table || band.family == Family::profile;
        if (measured && !band.file.empty()) read_band(document, spectra::element_key("band", i), band);
    }
}

}  // namespace railpem::app
