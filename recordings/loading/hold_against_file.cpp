#include "recordings/loading/hold_against_file.hpp"

#include <fmt/format.h>

#include <cmath>

#include "parameters/parameter_error.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings {
namespace {

/// Two factors that mean the same unit: 9.81 or 9.8 for standard gravity is within 0.1 %, a calibration is not meant.
bool same_factor(double a, double b) {
    return std::abs(std::abs(a) / std::abs(b) - 1.0) < 1e-3;
}

std::string said_at(const std::string& where) {
    return where.empty() ? "" : fmt::format(" ({})", where);
}

Fault fault_of(FaultKind kind, Severity severity, const ChannelDescription& channel, std::string says) {
    Fault found;
    found.kind = kind;
    found.severity = severity;
    found.channels = {channel.name};
    found.says = std::move(says);
    return found;
}

/// What both sides say of one channel, in the same terms.
struct Sides {
    const ChannelDescription& channel;
    const ColumnStatement& file;
    std::optional<double> described_unit, file_unit;  ///< factors to SI; empty: not said, or not of the quantity

    bool file_unit_is_foreign() const { return !file.unit.empty() && !file_unit; }
};

Sides sides_of(const ChannelDescription& channel, const ColumnStatement& file, const std::string& key) {
    Sides sides{channel, file, {}, {}};
    if (!channel.unit.empty()) sides.described_unit = to_si_factor(channel.unit, channel.quantity, key + ".unit");
    if (!file.unit.empty()) sides.file_unit = factor_of_unit(file.unit, channel.quantity);
    return sides;
}

/// The unit of another vibration is not converted: the quantity, which is only the default, may be what is wrong.
void refuse_other_quantity(const Sides& sides, const std::string& key) {
    if (sides.described_unit || sides.channel.scale_factor || !sides.file_unit_is_foreign()) return;
    for (const ChannelQuantity other :
         {ChannelQuantity::acceleration, ChannelQuantity::velocity, ChannelQuantity::displacement})
        if (factor_of_unit(sides.file.unit, other))
            throw parameters::ParameterError(
                key + ".quantity",
                fmt::format("the data file says '{}'{}, a unit of {}, where the description has {}", sides.file.unit,
                            said_at(sides.file.unit_where), quantity_name(other),
                            quantity_name(sides.channel.quantity)),
                fmt::format("quantity = \"{}\", or a unit of {} in `unit` where the file is wrong",
                            quantity_name(other), quantity_name(sides.channel.quantity)));
}

/// The description says a scale of its own: it turns the file's numbers into `unit`, and whatever the file's unit is
/// may be what it converts from.
Conversion with_described_scale(const Sides& sides) {
    Conversion result;
    const double scale = *sides.channel.scale_factor;
    const std::string si = si_unit(sides.channel.quantity);
    if (sides.described_unit) {
        result.factor = scale * *sides.described_unit;
        result.says = fmt::format("{} after a factor of {:g}, by the description", sides.channel.unit, scale);
    } else if (sides.file_unit && !same_factor(scale, *sides.file_unit)) {
        result.factor = scale * *sides.file_unit;
        result.says = fmt::format("{} by the data file{}, after a factor of {:g} by the description", sides.file.unit,
                                  said_at(sides.file.unit_where), scale);
    } else {
        result.factor = scale;
        result.says = fmt::format("{} after a factor of {:g}, by the description", si, scale);
    }
    return result;
}

Conversion with_scale_of_the_file(const Sides& sides) {
    Conversion result;
    const double scale = sides.file.scale.value_or(1.0), offset = sides.file.offset.value_or(0.0);
    const double unit = sides.described_unit ? *sides.described_unit : sides.file_unit.value_or(1.0);
    result.factor = scale * unit;
    result.offset = offset * unit;
    result.says = sides.described_unit ? fmt::format("{} by the description", sides.channel.unit)
                  : sides.file_unit
                      ? fmt::format("{} by the data file{}", sides.file.unit, said_at(sides.file.unit_where))
                      : fmt::format("{}, which nobody says", si_unit(sides.channel.quantity));
    if (sides.file.scale || sides.file.offset)
        result.says +=
            fmt::format(", after × {:g} {:+g} by the data file{}", scale, offset, said_at(sides.file.scale_where));
    return result;
}

/// Both speak of the unit and differ.
void hold_units(const Sides& sides, Conversion& result) {
    const ChannelDescription& channel = sides.channel;
    if (!sides.described_unit || sides.file.unit.empty()) return;
    const double stored_to_unit = sides.file.scale.value_or(1.0);
    if (sides.file_unit) {
        const bool agree = same_factor(result.factor, stored_to_unit * *sides.file_unit) ||
                           same_factor(*sides.described_unit, *sides.file_unit);
        if (agree) return;
        result.contradiction = fault_of(
            FaultKind::wrong_unit, Severity::error, channel,
            fmt::format("the data file says '{}'{}, the description '{}': a factor of {:.4g} lies between them; the "
                        "description was followed",
                        sides.file.unit, said_at(sides.file.unit_where), channel.unit,
                        result.factor / (stored_to_unit * *sides.file_unit)));
        result.contradiction->value = result.factor / (stored_to_unit * *sides.file_unit);
        result.contradiction->unit = "1";
        return;
    }
    if (channel.scale_factor) return;  // volts to m/s^2, for instance: the factor is what converts them
    result.contradiction =
        fault_of(FaultKind::wrong_unit, Severity::error, channel,
                 fmt::format("the data file says '{}'{}, the description '{}': not the same, and no scale_factor "
                             "converts one into the other; the description was followed",
                             sides.file.unit, said_at(sides.file.unit_where), channel.unit));
}

/// Both speak of the scale and differ.
void hold_scales(const Sides& sides, Conversion& result) {
    if (result.contradiction || !sides.channel.scale_factor || !sides.file.scale) return;
    const double described = result.factor,
                 file = *sides.file.scale * sides.file_unit.value_or(sides.described_unit.value_or(1.0));
    if (same_factor(described, file)) {
        result.factor = file;  // with the offset that belongs to it
        result.offset = sides.file.offset.value_or(0.0) * sides.file_unit.value_or(sides.described_unit.value_or(1.0));
        return;
    }
    result.contradiction = fault_of(
        FaultKind::wrong_unit, Severity::error, sides.channel,
        fmt::format("the data file says a scale of {:g}{}, the description a scale_factor of {:g}; the description was "
                    "followed",
                    *sides.file.scale, said_at(sides.file.scale_where), *sides.channel.scale_factor));
    result.contradiction->value = described / file;
    result.contradiction->unit = "1";
}

/// Nobody says what the numbers are worth: shapes can be judged, levels cannot.
void hold_unknown_scale(const Sides& sides, Conversion& result) {
    if (result.contradiction || sides.channel.scale_factor || sides.file.scale) return;
    if (sides.channel.scale == Scale::unknown) return;
    if (sides.file.share_of_full_scale) {
        result.scale_is_known = false;
        result.says = "shares of full scale; nobody says what that is";
        result.contradiction =
            fault_of(FaultKind::unknown_scale, Severity::warning, sides.channel,
                     "the samples are shares of full scale and no scale_factor says what full scale is: levels cannot "
                     "be trusted");
    } else if (sides.file_unit_is_foreign() && !sides.described_unit) {
        result.scale_is_known = false;
        result.says = fmt::format("{} by the data file{}", sides.file.unit, said_at(sides.file.unit_where));
        result.contradiction = fault_of(
            FaultKind::unknown_scale, Severity::warning, sides.channel,
            fmt::format("the data file says '{}'{}, which is no unit of {}, and no scale_factor converts it: "
                        "levels cannot be trusted",
                        sides.file.unit, said_at(sides.file.unit_where), quantity_name(sides.channel.quantity)));
    }
}

}  // namespace

Conversion conversion_of(const ChannelDescription& channel, const ColumnStatement& file, const std::string& key) {
    const Sides sides = sides_of(channel, file, key);
    refuse_other_quantity(sides, key);
    Conversion result = channel.scale_factor ? with_described_scale(sides) : with_scale_of_the_file(sides);
    hold_units(sides, result);
    hold_scales(sides, result);
    hold_unknown_scale(sides, result);
    return result;
}

void add_contradiction(const Fault& fault, std::vector<Fault>& contradictions) {
    for (Fault& known : contradictions)
        if (known.kind == fault.kind && known.says == fault.says) {
            known.channels.insert(known.channels.end(), fault.channels.begin(), fault.channels.end());
            return;
        }
    contradictions.push_back(fault);
}

double held_sampling_rate(double described_hz, double file_hz, const std::string& file_where,
                          std::vector<Fault>& contradictions) {
    if (described_hz <= 0.0) return file_hz;
    if (file_hz > 0.0 && std::abs(file_hz / described_hz - 1.0) > 1e-4) {
        Fault found;
        found.kind = FaultKind::sampling_rate;
        found.severity = Severity::error;
        found.says = fmt::format(
            "the data file says a sampling rate of {:g} Hz{}, the description {:g} Hz; the "
            "description was followed",
            file_hz, said_at(file_where), described_hz);
        found.value = file_hz;
        found.unit = "Hz";
        contradictions.push_back(std::move(found));
    }
    return described_hz;
}

void hold_columns_together(const std::vector<std::string>& names, const std::vector<ColumnStatement>& columns,
                           std::vector<Fault>& contradictions) {
    const auto differ = [&](auto member, double tolerance) -> std::optional<std::pair<std::size_t, std::size_t>> {
        for (std::size_t first = 0; first < columns.size(); ++first) {
            if (!(columns[first].*member)) continue;
            for (std::size_t i = first + 1; i < columns.size(); ++i)
                if (columns[i].*member && std::abs(*(columns[i].*member) - *(columns[first].*member)) > tolerance)
                    return std::pair(first, i);
            return std::nullopt;
        }
        return std::nullopt;
    };
    const auto add = [&](FaultKind kind, std::size_t a, std::size_t b, std::string says) {
        Fault found;
        found.kind = kind;
        found.severity = Severity::error;
        found.channels = {names[a], names[b]};
        found.says = std::move(says);
        contradictions.push_back(std::move(found));
    };
    const auto rate_of = [](const ColumnStatement& column) { return column.sampling_rate_hz.value_or(0.0); };
    double interval_s = 0.0;
    for (const ColumnStatement& column : columns)
        if (rate_of(column) > 0.0) interval_s = 1.0 / rate_of(column);
    if (const auto pair = differ(&ColumnStatement::sampling_rate_hz, interval_s > 0.0 ? 1e-4 / interval_s : 0.0))
        add(FaultKind::sampling_rate, pair->first, pair->second,
            fmt::format("the data file says {:g} Hz for {} and {:g} Hz for {}: they do not run together",
                        rate_of(columns[pair->first]), names[pair->first], rate_of(columns[pair->second]),
                        names[pair->second]));
    // A tenth of a sample: what delays between channels are known to.
    if (const auto pair = differ(&ColumnStatement::start_s, 0.1 * interval_s))
        add(FaultKind::timing_skew, pair->first, pair->second,
            fmt::format("the data file says that {} starts at {:g} s and {} at {:g} s: their samples were not taken "
                        "together",
                        names[pair->first], *columns[pair->first].start_s, names[pair->second],
                        *columns[pair->second].start_s));
}

void hold_promised_rows(std::size_t rows, std::size_t promised, double sampling_rate_hz,
                        std::vector<Fault>& contradictions) {
    if (promised == 0 || rows == promised) return;
    Fault found;
    found.kind = FaultKind::missing_samples;
    found.severity = Severity::warning;
    const double rate = sampling_rate_hz > 0.0 ? sampling_rate_hz : 1.0;
    found.says = fmt::format(
        "the header of the data file promises {} samples ({:.4g} s), {} are there ({:.4g} s): the "
        "file was cut, or another's header was put before it",
        promised, static_cast<double>(promised) / rate, rows, static_cast<double>(rows) / rate);
    found.value = static_cast<double>(rows) / static_cast<double>(promised);
    found.unit = "1";
    contradictions.push_back(std::move(found));
}

}  // namespace railpem::recordings
