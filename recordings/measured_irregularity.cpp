#include "recordings/measured_irregularity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parameters/parameter_error.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/text/read_csv.hpp"
#include "spectra/profile_spectrum.hpp"

namespace railpem::recordings {
namespace {

/// Two columns of a CSV and the line of each of their rows.
struct TwoColumns {
    std::string file;
    std::vector<double> x, y;
    std::vector<std::size_t> lines;
};

[[noreturn]] void refuse_row(const TwoColumns& table, std::size_t row, const std::string& problem,
                             const std::string& allowed) {
    throw ReadError(table.file, table.lines[row], problem, allowed);
}

TwoColumns read_columns(const std::string& file, const std::string& x_name, const std::string& y_name,
                        const ReadLimits& limits) {
    CsvReader reader(file, limits, {x_name, y_name});
    reader.select({require_name(x_name, reader.names(), "column", file, reader.header_line()),
                   require_name(y_name, reader.names(), "column", file, reader.header_line())});
    TwoColumns table{.file = file};
    std::vector<std::vector<double>> columns(2);
    // By the row, so that each keeps its line: comments and empty lines stand between them.
    while (reader.read(1, columns) == 1) {
        table.lines.push_back(reader.line());
        if (table.lines.size() > limits.memory_bytes / (2 * sizeof(double) + sizeof(std::size_t)))
            throw ReadError(file, reader.line(), "too many rows to hold at once",
                            fmt::format("at most {} MB", limits.memory_bytes >> 20));
    }
    table.x = std::move(columns[0]);
    table.y = std::move(columns[1]);
    for (std::size_t row = 0; row < table.x.size(); ++row)
        if (std::isnan(table.x[row]) || std::isnan(table.y[row]))
            refuse_row(table, row, "a value is missing", fmt::format("a number in {} and {}", x_name, y_name));
    if (table.x.size() < 2)
        throw ReadError(file, 0, fmt::format("{} row{} of numbers", table.x.size(), table.x.size() == 1 ? "" : "s"),
                        "at least two rows");
    return table;
}

/// The first step that differs from the usual one, named by its line: the mean step would blame the sound ones.
void require_even_steps(const TwoColumns& profile) {
    std::vector<double> steps;
    for (std::size_t row = 1; row < profile.x.size(); ++row) steps.push_back(profile.x[row] - profile.x[row - 1]);
    std::vector<double> sorted = steps;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double usual = *middle;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (!(steps[i] > 0.0)) refuse_row(profile, i + 1, "position_m does not increase", "strictly increasing values");
        if (!(std::abs(steps[i] - usual) <= 0.01 * std::abs(usual)))
            refuse_row(profile, i + 1,
                       fmt::format("the positions do not increase in even steps: {:.6g} m among steps of {:.6g} m",
                                   steps[i], usual),
                       "steps within 1 % of their mean");
    }
}

bool has(const std::vector<std::string>& names, const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

MeasuredIrregularity read_irregularity_spectrum(const std::string& file, const ReadLimits& limits) {
    TwoColumns table = read_columns(file, "cycles_per_m", "psd_m3", limits);
    for (std::size_t row = 0; row < table.x.size(); ++row) {
        if (!(table.x[row] > 0.0))
            refuse_row(table, row, fmt::format("cycles_per_m cannot be {:g}", table.x[row]), "a number greater than 0");
        if (!(table.y[row] > 0.0))
            refuse_row(table, row, fmt::format("psd_m3 cannot be {:g}", table.y[row]),
                       "a number greater than 0 (the spectrum is interpolated log-log)");
        if (row > 0 && !(table.x[row] > table.x[row - 1]))
            refuse_row(table, row, "cycles_per_m does not increase", "strictly increasing values");
    }
    return {.file = file, .cycles_per_m = std::move(table.x), .psd_m3 = std::move(table.y)};
}

MeasuredIrregularity read_irregularity_profile(const std::string& file, double segment_length_m,
                                               const ReadLimits& limits) {
    constexpr double default_segments = 8.0;
    TwoColumns table = read_columns(file, "position_m", "height_m", limits);
    require_even_steps(table);
    constexpr std::size_t fewest_rows = 129;  // eight segments of 16 steps, the shortest that are estimated from
    if (segment_length_m <= 0.0 && table.x.size() < fewest_rows)
        throw ReadError(file, table.lines.back(), fmt::format("a profile of {} rows is too short", table.x.size()),
                        fmt::format("at least {} rows: eight segments of 16 steps", fewest_rows));
    const double segment =
        segment_length_m > 0.0 ? segment_length_m : (table.x.back() - table.x.front()) / default_segments;
    try {
        spectra::ProfileSpectrum spectrum = spectra::spectrum_of_profile(table.x, table.y, segment);
        return {.file = file,
                .cycles_per_m = std::move(spectrum.cycles_per_m),
                .psd_m3 = std::move(spectrum.psd_m3),
                .position_m = std::move(table.x),
                .height_m = std::move(table.y),
                .segment_length_m = spectrum.segment_length_m,
                .averages = spectrum.averages};
    } catch (const parameters::ParameterError& error) {
        throw ReadError(file, 0, error.problem(), error.allowed());
    }
}

MeasuredIrregularity read_irregularity(const std::string& file, const ReadLimits& limits) {
    const CsvReader reader(file, limits);
    const std::vector<std::string>& names = reader.names();
    const bool spectrum = has(names, "cycles_per_m") || has(names, "psd_m3"),
               profile = has(names, "position_m") || has(names, "height_m");
    if (spectrum && profile)
        throw ReadError(file, reader.header_line(), "columns of a spectrum and of a profile in one file",
                        "cycles_per_m and psd_m3, or position_m and height_m");
    if (!spectrum && !profile)
        throw ReadError(file, reader.header_line(), fmt::format("the columns are {}", listed(names)),
                        "cycles_per_m and psd_m3 (a spectrum), or position_m and height_m (a profile, up positive)");
    return spectrum ? read_irregularity_spectrum(file, limits) : read_irregularity_profile(file, 0.0, limits);
}

}  // namespace railpem::recordings
