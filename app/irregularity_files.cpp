#include "app/irregularity_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "app/read_table.hpp"
#include "recordings/read_csv.hpp"
#include "recordings/read_error.hpp"
#include "spectra/profile_spectrum.hpp"

namespace railpem::app {

using parameters::ParameterError;
using spectra::Family;
using spectra::IrregularityBand;

namespace {

/// A profile of 1000 km at 25 cm and a spectrum of any resolution fit many times.
constexpr recordings::ReadLimits kLimits{.memory_bytes = std::size_t{256} << 20};

/// Two columns of a CSV and the line of each of their rows.
struct Measurement {
    std::string file;
    std::vector<double> x, y;
    std::vector<std::size_t> lines;
};

[[noreturn]] void refuse_line(const Measurement& measured, std::size_t row, const std::string& what,
                              const std::string& allowed) {
    throw InputError(fmt::format("{}:{}: {}\nallowed: {}", measured.file, measured.lines[row], what, allowed));
}

Measurement read_columns(const std::string& file, const std::string& x_name, const std::string& y_name) {
    recordings::CsvReader reader(file, kLimits);
    reader.select({recordings::require_name(x_name, reader.names(), "column", file, reader.header_line()),
                   recordings::require_name(y_name, reader.names(), "column", file, reader.header_line())});
    Measurement measured{.file = file};
    std::vector<std::vector<double>> columns(2);
    while (reader.read(1, columns) == 1) measured.lines.push_back(reader.line());
    measured.x = std::move(columns[0]);
    measured.y = std::move(columns[1]);
    for (std::size_t row = 0; row < measured.x.size(); ++row)
        if (std::isnan(measured.x[row]) || std::isnan(measured.y[row]))
            refuse_line(measured, row, "a value is missing", fmt::format("a number in {} and {}", x_name, y_name));
    return measured;
}

void read_spectrum(const std::string& file, IrregularityBand& band) {
    Measurement measured = read_columns(file, "cycles_per_m", "psd_m3");
    for (std::size_t row = 0; row < measured.x.size(); ++row) {
        if (!(measured.x[row] > 0.0))
            refuse_line(measured, row, fmt::format("cycles_per_m cannot be {:g}", measured.x[row]),
                        "a number greater than 0");
        if (!(measured.y[row] > 0.0))
            refuse_line(measured, row, fmt::format("psd_m3 cannot be {:g}", measured.y[row]),
                        "a number greater than 0 (the spectrum is interpolated log-log)");
        if (row > 0 && !(measured.x[row] > measured.x[row - 1]))
            refuse_line(measured, row, "cycles_per_m does not increase", "strictly increasing values");
    }
    band.table_cycles_per_m = std::move(measured.x);
    band.table_psd_m3 = std::move(measured.y);
}

void read_profile(const std::string& file, IrregularityBand& band) {
    constexpr double default_segments =
        8.0;  // 15 with their overlap, some 14 independent: 27 % standard error per line
    const Measurement measured = read_columns(file, "position_m", "height_m");
    if (measured.x.size() < 2)
        throw ParameterError("", "a profile of fewer than two rows", "a profile of many wavelengths");
    const double length = measured.x.back() - measured.x.front();
    const double segment = band.segment_length_m > 0.0 ? band.segment_length_m : length / default_segments;
    const IrregularityBand table =
        spectra::measured_band(spectra::spectrum_of_profile(measured.x, measured.y, segment));
    band.table_cycles_per_m = table.table_cycles_per_m;
    band.table_psd_m3 = table.table_psd_m3;
}

void read_band(const Document& document, const std::string& key, IrregularityBand& band) {
    const std::string file = (std::filesystem::path(document.name).parent_path() / band.file).string();
    if (!band.table_cycles_per_m.empty() || !band.table_psd_m3.empty())
        throw refused(document,
                      ParameterError(key + ".file", "the table is given both here and as a file", "one of them"));
    try {
        (band.family == Family::profile ? read_profile : read_spectrum)(file, band);
    } catch (const recordings::ReadError& error) {
        if (error.line() > 0)
            throw InputError(
                fmt::format("{}:{}: {}\nallowed: {}", error.file(), error.line(), error.problem(), error.allowed()));
        throw refused(document, ParameterError(key + ".file", file + ": " + error.problem(), error.allowed()));
    } catch (const ParameterError& error) {
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
