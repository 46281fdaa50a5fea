#include "recordings/recording_parameters.hpp"

#include <fmt/format.h>

#include <set>

#include "parameters/parameter_error.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings {

using namespace parameters;

Fields<RecordingDescription> recording_fields() {
    using R = RecordingDescription;
    return {
        text(&R::title, "title", "one line that names the recording"),
        choice(&R::kind, "kind", {"timeseries", "psd", "points", "receptance", "decay-rate"},
               "what the data file holds"),
        text(&R::data, "data",
             "the data file: .csv or other text, .mat, .uff or .unv, .wav, .h5; relative to this file")
            .required(),
        number(&R::sampling_rate_hz, "sampling_rate_hz", "Hz", positive(),
               "sampling rate of a time series, where the data file does not say it"),
        number(&R::speed_m_per_s, "speed_m_per_s", "m/s", {.low = 0.0, .high = 200.0, .low_open = true},
               "speed of the train"),
        number(&R::speed_standard_error_m_per_s, "speed_standard_error_m_per_s", "m/s", not_negative(),
               "standard error of the stated speed; 0: exact"),
        number(&R::payload_kg, "payload_kg", "kg", not_negative(), "extra mass in the car body (whole car)"),
        text(&R::irregularity, "irregularity",
             "measured irregularity: a CSV with cycles_per_m and psd_m3, or position_m and height_m (up positive)"),
        text(&R::time_column, "time_column",
             "column with the time; without it a column named time_s, time, t, timestamp or the like is used when "
             "there is one"),
        integer(&R::averages, "averages", between(1, 1000000000), "kind psd: independent averages behind every value"),
        choice(&R::place, "place", {"over_pad", "mid_bay"}, "kind receptance: where the rail was struck and measured"),
    };
}

namespace {

/// Whether it is stated matters: where it is not, the data file may state one.
Field<ChannelDescription> scale_factor_field() {
    using C = ChannelDescription;
    return {{.key = "scale_factor",
             .unit = "1",
             .kind = Kind::number,
             .range = any_number(),
             .says = "the number in the file times this is the value in the unit (for instance the full scale of a WAV "
                     "file); without it what the data file says, else 1"},
            [](const C& channel) { return Value(channel.scale_factor.value_or(1.0)); },
            [](C& channel, const Value& value) { channel.scale_factor = std::get<double>(value); }};
}

}  // namespace

Fields<ChannelDescription> channel_fields() {
    using C = ChannelDescription;
    return {
        text(&C::name, "name", "name of the channel in every table").required(),
        text(&C::column, "column",
             "CSV column (name:2 is the second of that name, 5 the fifth of all), MAT variable (also run.y, "
             "ch(2).y, sig{2}), UFF record, WAV channel or HDF5 dataset (name:3 is its third column); without it the "
             "name"),
        choice(&C::quantity, "quantity", {"acceleration", "velocity", "displacement", "speed", "mileage"},
               "what is measured; speed and mileage are of the train"),
        text(&C::unit, "unit",
             "unit of the numbers, such as m/s^2, g, mm/s, um, km/h; without it what the data file says, else the SI "
             "unit"),
        scale_factor_field(),
        choice(&C::scale, "scale", {"known", "unknown"}, "unknown: the unit cannot be trusted, levels say nothing"),
        number(&C::gain_standard_error, "gain_standard_error", "1", between(0.0, 0.5),
               "relative standard error of the sensor's calibration; 0: exact"),
        choice(&C::location, "location", {"none", "body", "bogie", "wheel", "rail"},
               "where the sensor sits; wheel is the axle box"),
        integer(&C::index, "index", between(1, 4),
                "wheel 1 to 4, bogie 1 or 2 from the front; rail: under wheel n; absent for the body"),
        choice(&C::side, "side", {"unstated", "left", "right"}, "side of the train, looking forward"),
        number(&C::position_m, "position_m", "m", between(-50.0, 50.0),
               "body only: from its centre, positive towards the front"),
    };
}

namespace {

bool needs_channels(RecordingKind kind) {
    return kind == RecordingKind::timeseries || kind == RecordingKind::psd || kind == RecordingKind::points;
}

void check_channel(const ChannelDescription& channel, const std::string& key) {
    if (channel.name.empty()) throw ParameterError(key + ".name", "a channel without a name", "a name");
    to_si_factor(channel.unit, channel.quantity, key + ".unit");
    if (channel.scale_factor == 0.0)
        throw ParameterError(key + ".scale_factor", "the channel would be zero", "any number but 0");
    const int last = channel.location == Location::bogie                                         ? 2
                     : channel.location == Location::wheel || channel.location == Location::rail ? 4
                                                                                                 : 0;
    if (last == 0 && channel.index != 0)
        throw ParameterError(key + ".index", "only wheels, bogies and rails are numbered",
                             "no index for this location");
    if (last > 0 && (channel.index < 1 || channel.index > last))
        throw ParameterError(
            key + ".index",
            fmt::format("{} does not say which one", channel.index == 0 ? "no index" : std::to_string(channel.index)),
            fmt::format("1 to {}", last));
}

}  // namespace

void check(const RecordingDescription& description) {
    if (description.data.empty()) throw ParameterError("data", "no data file", "the name of a file");
    if (description.speed_standard_error_m_per_s > 0.0 && description.speed_m_per_s <= 0.0)
        throw ParameterError("speed_standard_error_m_per_s", "a standard error of a speed that is not stated",
                             "with speed_m_per_s");
    if (needs_channels(description.kind) && description.channels.empty())
        throw ParameterError("channel", "no channel is described", "at least one [[channel]]");
    std::set<std::string> names;
    for (std::size_t i = 0; i < description.channels.size(); ++i) {
        const std::string key = fmt::format("channel[{}]", i + 1);
        check_channel(description.channels[i], key);
        if (!names.insert(description.channels[i].name).second)
            throw ParameterError(key + ".name",
                                 fmt::format("two channels are named '{}'", description.channels[i].name),
                                 "a name of its own for every channel");
    }
}

}  // namespace railpem::recordings
