#include "recordings/loading/load_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recordings/files/read_error.hpp"
#include "recordings/loading/hold_against_file.hpp"
#include "recordings/loading/load_uff_spectra.hpp"
#include "recordings/text/column_address.hpp"
#include "recordings/text/csv_dialect.hpp"
#include "recordings/text/read_csv.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings {
namespace {

const char* const no_cross_spectra = "no cross-spectra: phases and coherence between the channels are not known";

bool has_column(const DataTable& table, const std::string& name) {
    return std::find(table.names.begin(), table.names.end(), name) != table.names.end();
}

const std::vector<double>& column(const DataTable& table, const std::string& name, const std::string& file) {
    return table.columns[require_name(name, table.names, "column", file, 1)];
}

/// Frequencies: finite, positive, increasing.
void check_frequencies(const std::vector<double>& frequencies, const std::string& name, const std::string& file) {
    for (std::size_t i = 0; i < frequencies.size(); ++i)
        if (!(frequencies[i] > (i > 0 ? frequencies[i - 1] : -1.0)) || frequencies[i] < 0.0)
            throw ReadError(file, i + 2, fmt::format("'{}' does not increase", name),
                            "frequencies that are not negative and increase from row to row");
}

void check_values(const std::vector<double>& values, const std::string& name, double lowest, const std::string& file) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!(values[i] >= lowest))
            throw ReadError(file, i + 2, fmt::format("a value of '{}' is missing or less than {:g}", name, lowest),
                            "a number in every row");
}

double squared_factor(const RecordingDescription& description, std::size_t channel) {
    const ChannelDescription& c = description.channels[channel];
    const double factor =
        c.scale_factor.value_or(1.0) * to_si_factor(c.unit, c.quantity, fmt::format("channel[{}].unit", channel + 1));
    return factor * factor;
}

/// What the file says of a column of densities, as of the amplitude behind it; a unit that is none of a density says
/// nothing.
ColumnStatement amplitude_statement(const ColumnStatement& density) {
    ColumnStatement amplitude = density;
    amplitude.unit = amplitude_unit(density.unit);
    return amplitude;
}

/// One spectrum in SI units; what file and description say of its unit is held together.
ChannelSpectrum spectrum_of(std::size_t i, const DataTable& table, const std::vector<double>& frequency,
                            Recording& recording) {
    ChannelDescription channel = recording.description.channels[i];
    const std::size_t at = find_column(channel.column.empty() ? channel.name : channel.column,
                                       {.names = table.names, .line = 1}, recording.file);
    const Conversion conversion =
        conversion_of(channel, amplitude_statement(table.says.columns[at]), fmt::format("channel[{}]", i + 1));
    if (conversion.contradiction) add_contradiction(*conversion.contradiction, recording.contradictions);
    check_values(table.columns[at], channel.name, 0.0, recording.file);
    ChannelSpectrum spectrum{channel, frequency, table.columns[at], {}, conversion.says};
    for (double& value : spectrum.psd) value *= conversion.factor * conversion.factor;
    return spectrum;
}

void add_scale_lack(Recording& recording) {
    for (const ChannelDescription& channel : recording.description.channels)
        if (channel.scale == Scale::unknown)
            recording.lacks.push_back(
                fmt::format("the scale of {} is not known: its level says nothing, its shape does", channel.name));
}

}  // namespace

namespace {

void load_csv_densities(Recording& recording, const ReadLimits& limits) {
    const DataTable table = read_csv(recording.file, {}, limits);
    const std::vector<double>& frequency = column(table, "frequency_hz", recording.file);
    check_frequencies(frequency, "frequency_hz", recording.file);
    for (std::size_t i = 0; i < recording.description.channels.size(); ++i) {
        ChannelSpectrum spectrum = spectrum_of(i, table, frequency, recording);
        recording.spectra.push_back(std::move(spectrum));
    }
    recording.notes.insert(recording.notes.end(), table.notes.begin(), table.notes.end());
}

}  // namespace

void load_psd(Recording& recording, const ReadLimits& limits) {
    if (is_universal_file(recording.file))
        load_uff_densities(recording, limits);
    else
        load_csv_densities(recording, limits);
    const int averages = recording.description.averages;
    for (ChannelSpectrum& spectrum : recording.spectra)
        for (std::size_t k = 0; k < spectrum.psd.size() && averages > 0; ++k)
            spectrum.standard_error.push_back(spectrum.psd[k] / std::sqrt(static_cast<double>(averages)));
    recording.lacks.emplace_back(no_cross_spectra);
    if (averages == 0)
        recording.lacks.emplace_back("no number of averages: the significance of a difference is not known");
    recording.lacks.emplace_back("no time series: faults of the sensors cannot be looked for");
    add_scale_lack(recording);
}

void load_points(Recording& recording, const ReadLimits& limits) {
    const auto rows = read_csv_text(recording.file, limits);
    const std::string& file = recording.file;
    const std::size_t at_channel = require_name("channel", rows[0], "column", file, 1),
                      at_frequency = require_name("frequency_hz", rows[0], "column", file, 1),
                      at_value = require_name("value", rows[0], "column", file, 1);
    const auto error_column = std::find(rows[0].begin(), rows[0].end(), "standard_error");
    std::vector<std::string> names;
    for (const ChannelDescription& channel : recording.description.channels) {
        names.push_back(channel.column.empty() ? channel.name : channel.column);
        recording.spectra.push_back({channel, {}, {}, {}, {}});
    }
    const auto number = [&](std::size_t row, std::size_t at) {
        double value = 0.0;
        if (!parse_number(rows[row][at], {}, value) || !(value >= 0.0))
            throw ReadError(file, row + 1,
                            fmt::format("'{}' is not a number, or less than 0", rows[row][at].substr(0, 60)),
                            "a number that is not negative");
        return value;
    };
    for (std::size_t row = 1; row < rows.size(); ++row) {
        const std::size_t channel =
            require_name(rows[row][at_channel], names, "channel in the description called", file, row + 1);
        const double factor = squared_factor(recording.description, channel);
        recording.spectra[channel].frequency_hz.push_back(number(row, at_frequency));
        recording.spectra[channel].psd.push_back(factor * number(row, at_value));
        if (error_column != rows[0].end())
            recording.spectra[channel].standard_error.push_back(
                factor * number(row, static_cast<std::size_t>(error_column - rows[0].begin())));
    }
    recording.lacks.emplace_back(no_cross_spectra);
    recording.lacks.emplace_back("points of a spectrum only: nothing is known between them");
    if (error_column == rows[0].end())
        recording.lacks.emplace_back("no standard errors: the significance of a difference is not known");
    add_scale_lack(recording);
}

void load_receptance(Recording& recording, const ReadLimits& limits) {
    recording.lacks.emplace_back("a track without a vehicle: nothing is known of the vehicle or the irregularity");
    recording.lacks.emplace_back("no standard errors: the significance of a difference is not known");
    const std::string& file = recording.file;
    if (is_universal_file(file)) return load_uff_receptance(recording, limits);
    const DataTable table = read_csv(file, {}, limits);
    MeasuredReceptance& receptance = recording.receptance;
    receptance.frequency_hz = column(table, "frequency_hz", file);
    check_frequencies(receptance.frequency_hz, "frequency_hz", file);
    receptance.has_phase = has_column(table, "re_m_per_n") || !has_column(table, "magnitude_m_per_n");
    const std::vector<double>& real = column(table, receptance.has_phase ? "re_m_per_n" : "magnitude_m_per_n", file);
    check_values(real, receptance.has_phase ? "re_m_per_n" : "magnitude_m_per_n", receptance.has_phase ? -1e300 : 0.0,
                 file);
    if (receptance.has_phase) check_values(column(table, "im_m_per_n", file), "im_m_per_n", -1e300, file);
    for (std::size_t i = 0; i < real.size(); ++i)
        receptance.value_m_per_n.emplace_back(real[i],
                                              receptance.has_phase ? column(table, "im_m_per_n", file)[i] : 0.0);
    if (!receptance.has_phase) recording.lacks.emplace_back("no phase: only the magnitude of the receptance is known");
    recording.notes.insert(recording.notes.end(), table.notes.begin(), table.notes.end());
}

void load_decay_rate(Recording& recording, const ReadLimits& limits) {
    const DataTable table = read_csv(recording.file, {}, limits);
    MeasuredDecayRate& decay = recording.decay_rate;
    decay.centre_hz = column(table, "centre_hz", recording.file);
    decay.decay_rate_db_per_m = column(table, "decay_rate_db_per_m", recording.file);
    check_frequencies(decay.centre_hz, "centre_hz", recording.file);
    check_values(decay.decay_rate_db_per_m, "decay_rate_db_per_m", 0.0, recording.file);
    if (has_column(table, "standard_error_db_per_m")) {
        decay.standard_error_db_per_m = column(table, "standard_error_db_per_m", recording.file);
        check_values(decay.standard_error_db_per_m, "standard_error_db_per_m", 0.0, recording.file);
    } else {
        recording.lacks.emplace_back("no standard errors: the significance of a difference is not known");
    }
    recording.lacks.emplace_back("a track without a vehicle: nothing is known of the vehicle or the irregularity");
    recording.notes.insert(recording.notes.end(), table.notes.begin(), table.notes.end());
}

}  // namespace railpem::recordings
