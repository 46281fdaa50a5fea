#include "recordings/loading/load_uff_spectra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "recordings/files/compound_unit.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/files/uff.hpp"
#include "recordings/loading/hold_against_file.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings {
namespace {

bool is_function(const UffDataset& dataset, UffFunction function) {
    return dataset.function_type == static_cast<int>(function);
}

/// Hz; the abscissa is in Hz unless the file says another unit of frequency.
std::vector<double> frequencies_of(const UffDataset& dataset, const std::string& file) {
    const std::optional<KnownUnit> unit = known_unit(dataset.abscissa_unit);
    const double hz = unit && unit->dimension == Dimension::frequency ? unit->factor : 1.0;
    std::vector<double> frequencies;
    for (std::size_t i = 0; i < dataset.size(); ++i) {
        frequencies.push_back(hz * dataset.abscissa_at(i));
        if (!(frequencies[i] >= 0.0) || (i > 0 && !(frequencies[i] > frequencies[i - 1])))
            throw ReadError(file, dataset.line, fmt::format("the frequency of value {} does not increase", i + 1),
                            "frequencies that are not negative and increase");
    }
    return frequencies;
}

void require_density(const UffDataset& dataset, const std::string& name, const std::string& file) {
    const bool per_hz = unit_of_density(dataset.ordinate_unit).has_value();
    if (is_function(dataset, UffFunction::power_spectral_density)) return;
    if (is_function(dataset, UffFunction::auto_spectrum) && per_hz) return;
    throw ReadError(file, dataset.line,
                    fmt::format("the record '{}' is no power spectral density: {}{}", name,
                                uff_function_name(dataset.function_type),
                                dataset.ordinate_unit.empty() ? "" : fmt::format(" in '{}'", dataset.ordinate_unit)),
                    "function type 9, or an auto-spectrum (2) in a unit squared per Hz");
}

/// Real and not negative; what is complex must be real within its digits.
std::vector<double> densities_of(const UffDataset& dataset, const std::string& name, const std::string& file) {
    for (std::size_t i = 0; i < dataset.size(); ++i)
        if (!(dataset.real[i] >= 0.0) ||
            (dataset.complex && std::abs(dataset.imaginary[i]) > 1e-4 * std::abs(dataset.real[i])))
            throw ReadError(file, dataset.line,
                            fmt::format("value {} of the record '{}' is negative, missing or complex", i + 1, name),
                            "power spectral densities: real and not negative");
    return dataset.real;
}

ColumnStatement density_statement(const UffDataset& dataset) {
    ColumnStatement says;
    says.unit = unit_of_density(dataset.ordinate_unit).value_or(dataset.ordinate_unit);
    if (!says.unit.empty()) says.unit_where = fmt::format("'{}' in record 9", dataset.ordinate_unit);
    return says;
}

/// Derivatives of the displacement that the ordinate is of: 0, 1 or 2; by its data type, or by its unit.
int derivatives_of(const UffDataset& dataset, const PerForce& unit, const std::string& file) {
    static constexpr ChannelQuantity quantities[] = {ChannelQuantity::displacement, ChannelQuantity::velocity,
                                                     ChannelQuantity::acceleration};
    int by_unit = -1;
    for (int i = 0; i < 3; ++i)
        if (!unit.unit.empty() && factor_of_unit(unit.unit, quantities[i])) by_unit = i;
    const int by_kind = dataset.ordinate_kind == uff_displacement   ? 0
                        : dataset.ordinate_kind == uff_velocity     ? 1
                        : dataset.ordinate_kind == uff_acceleration ? 2
                                                                    : -1;
    const bool kind_is_said = dataset.ordinate_kind > 1;  // 0 unknown, 1 general
    if (kind_is_said && by_kind < 0)
        throw ReadError(file, dataset.line, fmt::format("the response has data type {}", dataset.ordinate_kind),
                        "displacement (8), velocity (11) or acceleration (12) over force");
    if (by_kind >= 0 && by_unit >= 0 && by_kind != by_unit)
        throw ReadError(
            file, dataset.line,
            fmt::format("record 9 says {} (data type {}) and '{}', a unit of {}", quantity_name(quantities[by_kind]),
                        dataset.ordinate_kind, dataset.ordinate_unit, quantity_name(quantities[by_unit])),
            "a data type and a unit that go together");
    if (by_kind < 0 && by_unit < 0)
        throw ReadError(file, dataset.line, "record 9 says neither by data type nor by unit what responds to the force",
                        "displacement (8), velocity (11) or acceleration (12) over force");
    return std::max(by_kind, by_unit);
}

void require_force(const UffDataset& dataset, const std::string& file) {
    const int kind = dataset.denominator_kind;
    const bool other_unit = !dataset.denominator_unit.empty() && !newtons_of(dataset.denominator_unit) &&
                            known_unit(dataset.denominator_unit);
    if ((kind > 1 && kind != uff_force && kind != uff_excitation_force) || other_unit)
        throw ReadError(file, dataset.line,
                        fmt::format("the response is not to a force: record 10 says data type {}{}", kind,
                                    other_unit ? fmt::format(" and '{}'", dataset.denominator_unit) : ""),
                        "displacement, velocity or acceleration over force (9 or 13)");
}

/// Factor from the numbers to SI units per N, with what was taken for it in words.
double per_newton(const UffDataset& dataset, int derivatives, const PerForce& unit, Recording& recording) {
    static constexpr ChannelQuantity quantities[] = {ChannelQuantity::displacement, ChannelQuantity::velocity,
                                                     ChannelQuantity::acceleration};
    static const char* const names[] = {"receptance", "mobility", "accelerance"};
    const ChannelQuantity quantity = quantities[derivatives];
    const double newtons = unit.has_force ? unit.newtons : newtons_of(dataset.denominator_unit).value_or(1.0);
    const std::optional<double> factor = unit.unit.empty() ? std::nullopt : factor_of_unit(unit.unit, quantity);
    if (factor) {
        recording.notes.push_back(fmt::format("{} in {} per {} by records 9 and 10", names[derivatives], unit.unit,
                                              newtons == 1.0 ? "N" : fmt::format("{:g} N", newtons)));
        return *factor / newtons;
    }
    const std::string taken = fmt::format("{} in {} per {}", names[derivatives], si_unit(quantity),
                                          newtons == 1.0 ? "N" : fmt::format("{:g} N", newtons));
    if (unit.unit.empty()) {
        recording.notes.push_back(taken + ", for record 9 says no unit");
    } else {
        Fault found;
        found.kind = FaultKind::unknown_scale;
        found.says = fmt::format("record 9 says '{}', which is no unit of {}: taken for {}", dataset.ordinate_unit,
                                 quantity_name(quantity), taken);
        recording.contradictions.push_back(std::move(found));
    }
    return 1.0 / newtons;
}

/// The response that is meant.
std::size_t chosen_response(const std::vector<UffDataset>& datasets, Recording& recording) {
    if (!recording.description.channels.empty()) {
        const ChannelDescription& channel = recording.description.channels.front();
        const std::string& name = channel.column.empty() ? channel.name : channel.column;
        const std::size_t named = find_uff_record(datasets, name, recording.file);
        if (!is_function(datasets[named], UffFunction::frequency_response))
            throw ReadError(recording.file, datasets[named].line,
                            fmt::format("the record '{}' is no frequency response: {}", name,
                                        uff_function_name(datasets[named].function_type)),
                            "a dataset 58 of function type 4");
        return named;
    }
    std::vector<std::size_t> responses;
    for (std::size_t i = 0; i < datasets.size(); ++i)
        if (is_function(datasets[i], UffFunction::frequency_response)) responses.push_back(i);
    if (responses.empty())
        throw ReadError(recording.file, 0, "no frequency response is in the file", "a dataset 58 of function type 4");
    const auto complex =
        std::find_if(responses.begin(), responses.end(), [&](std::size_t i) { return datasets[i].complex; });
    const std::size_t chosen = complex == responses.end() ? responses.front() : *complex;
    if (responses.size() > 1)
        recording.notes.push_back(
            fmt::format("the file holds {} frequency responses: record {} ('{}', at {}) was used; the column of a "
                        "[[channel]] names another",
                        responses.size(), chosen + 1, datasets[chosen].id[0],
                        uff_record_names(datasets[chosen], chosen + 1).back()));
    return chosen;
}

}  // namespace

bool is_universal_file(const std::string& file) {
    std::string name = file;
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name.ends_with(".uff") || name.ends_with(".unv");
}

void load_uff_densities(Recording& recording, const ReadLimits& limits) {
    const std::string& file = recording.file;
    const std::vector<UffDataset> datasets = read_uff(file, limits);
    for (std::size_t i = 0; i < recording.description.channels.size(); ++i) {
        const ChannelDescription& channel = recording.description.channels[i];
        const std::string& name = channel.column.empty() ? channel.name : channel.column;
        const UffDataset& dataset = datasets[find_uff_record(datasets, name, file)];
        require_density(dataset, name, file);
        const Conversion conversion =
            conversion_of(channel, density_statement(dataset), fmt::format("channel[{}]", i + 1));
        if (conversion.contradiction) recording.contradictions.push_back(*conversion.contradiction);
        ChannelSpectrum spectrum{
            channel, frequencies_of(dataset, file), densities_of(dataset, name, file), {}, conversion.says};
        if (!conversion.scale_is_known) spectrum.description.scale = Scale::unknown;
        for (double& value : spectrum.psd) value *= conversion.factor * conversion.factor;
        recording.spectra.push_back(std::move(spectrum));
    }
}

void load_uff_receptance(Recording& recording, const ReadLimits& limits) {
    const std::vector<UffDataset> datasets = read_uff(recording.file, limits);
    const UffDataset& dataset = datasets[chosen_response(datasets, recording)];
    require_force(dataset, recording.file);
    const PerForce unit = unit_per_force(dataset.ordinate_unit);
    const int derivatives = derivatives_of(dataset, unit, recording.file);
    const double factor = per_newton(dataset, derivatives, unit, recording);
    const std::vector<double> frequencies = frequencies_of(dataset, recording.file);
    recording.receptance.has_phase = dataset.complex;
    for (std::size_t i = 0; i < dataset.size(); ++i) {
        if (!(frequencies[i] > 0.0)) continue;
        const double omega = 2.0 * std::numbers::pi * frequencies[i];
        const std::complex<double> value(dataset.real[i], dataset.complex ? dataset.imaginary[i] : 0.0);
        if (!std::isfinite(value.real()) || !std::isfinite(value.imag()))
            throw ReadError(recording.file, dataset.line, fmt::format("value {} of the response is missing", i + 1),
                            "a number for every frequency");
        recording.receptance.frequency_hz.push_back(frequencies[i]);
        recording.receptance.value_m_per_n.push_back(
            dataset.complex ? factor * value / std::pow(std::complex<double>(0.0, omega), derivatives)
                            : std::complex<double>(factor * std::abs(value) / std::pow(omega, derivatives)));
    }
    if (recording.receptance.frequency_hz.empty())
        throw ReadError(recording.file, dataset.line, "the response holds no value at a frequency above 0",
                        "at least one");
    if (!dataset.complex) recording.lacks.emplace_back("no phase: only the magnitude of the receptance is known");
}

}  // namespace railpem::recordings
