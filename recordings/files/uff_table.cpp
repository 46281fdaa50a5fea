#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "recordings/files/known_units.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/files/uff.hpp"

namespace railpem::recordings {
namespace {

bool is_time_response(const UffDataset& dataset) {
    return !dataset.complex && dataset.abscissa_kind != uff_frequency &&
           (dataset.function_type == static_cast<int>(UffFunction::time_response) ||
            dataset.function_type == static_cast<int>(UffFunction::general));
}

/// Largest error of a number that was written with six digits, as the standard writes an abscissa.
double six_digits(double largest) {
    return largest > 0.0 ? 0.5e-5 * std::pow(10.0, std::floor(std::log10(largest))) : 0.0;
}

/// The step of an abscissa that is listed value by value: the mean one, when no value is farther from even steps than
/// its digits and a tenth of a step say. 0: the steps are not even.
double listed_step(const std::vector<double>& abscissa) {
    const auto steps = static_cast<double>(abscissa.size() - 1);
    const double step = (abscissa.back() - abscissa.front()) / steps;
    if (!(step > 0.0)) return 0.0;
    for (std::size_t i = 0; i < abscissa.size(); ++i) {
        const double even = abscissa.front() + static_cast<double>(i) * step;
        if (!(std::abs(abscissa[i] - even) <= 0.1 * step + six_digits(std::abs(abscissa[i])))) return 0.0;
    }
    return step;
}

/// Seconds in the unit of the abscissa, which is s unless the file says another of time.
double seconds_of_abscissa(const UffDataset& dataset) {
    const std::optional<KnownUnit> unit = known_unit(dataset.abscissa_unit);
    return unit && unit->dimension == Dimension::time ? unit->factor : 1.0;
}

/// Hz; of a listed abscissa to a millionth: below what a clock can promise.
double rate_of(const UffDataset& dataset, const std::string& name, const std::string& file) {
    const double second = seconds_of_abscissa(dataset);
    if (dataset.abscissa.empty()) return 1.0 / (dataset.abscissa_step * second);
    const double step = listed_step(dataset.abscissa) * second;
    if (step > 0.0) return std::round(1e6 / step) / 1e6;
    const auto [least, most] = [&] {
        std::vector<double> steps;
        for (std::size_t i = 1; i < dataset.size(); ++i) steps.push_back(dataset.abscissa[i] - dataset.abscissa[i - 1]);
        const auto [low, high] = std::minmax_element(steps.begin(), steps.end());
        return std::pair(*low, *high);
    }();
    throw ReadError(
        file, dataset.line,
        fmt::format("the record '{}' is not on an even axis: its steps run from {:g} to {:g} s", name, least, most),
        "real values in even steps of time");
}

void require_time_response(const UffDataset& dataset, const std::string& name, const std::string& file) {
    if (is_time_response(dataset) && dataset.size() >= 2) return;
    const bool response = dataset.function_type == static_cast<int>(UffFunction::frequency_response);
    throw ReadError(file, dataset.line,
                    fmt::format("the record '{}' is no time response: {}{}{}", name, dataset.complex ? "complex, " : "",
                                uff_function_name(dataset.function_type),
                                dataset.size() < 2 ? fmt::format(" of {} values", dataset.size()) : ""),
                    fmt::format("real values in even steps of time{}", response ? ", or kind = \"receptance\""
                                                                       : dataset.abscissa_kind == uff_frequency
                                                                           ? ", or kind = \"psd\""
                                                                           : ""));
}

ColumnStatement statement_of_record(const UffDataset& dataset) {
    ColumnStatement says;
    says.unit = dataset.ordinate_unit;
    if (!says.unit.empty()) says.unit_where = "record 9";
    says.start_s = dataset.abscissa_at(0) * seconds_of_abscissa(dataset);
    return says;
}

/// The third text line is the date by the standard; other text is none.
std::string date_of(const UffDataset& dataset) {
    const std::string& text = dataset.id[2];
    return std::count(text.begin(), text.end(), ':') >= 1 &&
                   std::any_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; })
               ? text
               : "";
}

}  // namespace

std::string uff_function_name(int function_type) {
    static const char* const names[] = {"general function",
                                        "time response",
                                        "auto-spectrum",
                                        "cross-spectrum",
                                        "frequency response",
                                        "transmissibility",
                                        "coherence",
                                        "auto-correlation",
                                        "cross-correlation",
                                        "power spectral density",
                                        "energy spectral density",
                                        "probability density",
                                        "spectrum"};
    const bool known = function_type >= 0 && function_type < static_cast<int>(std::size(names));
    return fmt::format("{} (function type {})", known ? names[function_type] : "another function", function_type);
}

std::vector<std::string> uff_record_names(const UffDataset& dataset, std::size_t number) {
    return {std::to_string(number), dataset.id[0],
            fmt::format("{}:{:+d}", dataset.response_node, dataset.response_direction)};
}

std::size_t find_uff_record(const std::vector<UffDataset>& datasets, const std::string& name, const std::string& file) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < datasets.size(); ++i)
        for (std::string& known : uff_record_names(datasets[i], i + 1)) names.push_back(std::move(known));
    return require_name(name, names, "record", file, 0) / 3;
}

DataTable uff_time_table(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits) {
    std::vector<UffDataset> datasets = read_uff(file, limits);
    DataTable table;
    const auto take = [&](const UffDataset& dataset, const std::string& name) {
        require_time_response(dataset, name, file);
        const double rate = rate_of(dataset, name, file);
        if (!table.columns.empty() &&
            (dataset.size() != table.rows() || std::abs(rate / table.sampling_rate_hz - 1.0) > 1e-6))
            throw ReadError(
                file, dataset.line,
                fmt::format("the record '{}' ({} values at {:g} Hz) differs from '{}' ({} at {:g} Hz)", name,
                            dataset.size(), rate, table.names.front(), table.rows(), table.sampling_rate_hz),
                "records sampled together");
        if (table.columns.empty()) table.says.start = date_of(dataset);
        table.sampling_rate_hz = rate;
        table.names.push_back(name);
        table.columns.push_back(dataset.real);
        table.says.columns.push_back(statement_of_record(dataset));
    };
    table.says.sampling_rate_where = "record 7";
    if (wanted.empty()) {
        for (std::size_t i = 0; i < datasets.size(); ++i)
            if (is_time_response(datasets[i]) && datasets[i].abscissa.empty()) take(datasets[i], std::to_string(i + 1));
        return table;
    }
    for (const std::string& name : wanted) take(datasets[find_uff_record(datasets, name, file)], name);
    return table;
}

void uff_time_blocks(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                     const ReadLimits& limits, const std::function<void(DataTable&)>& take) {
    DataTable whole = uff_time_table(file, wanted, limits);
    if (whole.rows() <= rows) {
        take(whole);
        return;
    }
    whole.says.held_rows = whole.rows();
    DataTable block;
    block.notes = whole.notes;
    for (std::size_t begin = 0; begin < whole.rows(); begin += rows) {
        const std::size_t end = std::min(whole.rows(), begin + rows);
        block.names = whole.names;  // the one who takes a block may empty it
        block.sampling_rate_hz = whole.sampling_rate_hz;
        block.says = whole.says;
        block.columns.clear();
        for (const std::vector<double>& column : whole.columns)
            block.columns.emplace_back(column.begin() + static_cast<std::ptrdiff_t>(begin),
                                       column.begin() + static_cast<std::ptrdiff_t>(end));
        take(block);
        block.notes.clear();
    }
}

}  // namespace railpem::recordings
