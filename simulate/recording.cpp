#include "simulate/recording.hpp"

#include <fmt/format.h>

#include <iterator>
#include <ostream>

namespace railpem::simulate {

const std::vector<std::string>& channel_names() {
    static const std::vector<std::string> names{"axlebox_1", "axlebox_2",  "axlebox_3", "axlebox_4",  "bogie_1",
                                                "bogie_2",   "body_front", "body_rear", "body_centre"};
    return names;
}

void write_csv(std::ostream& out, const Recording& recording) {
    fmt::memory_buffer row;
    const auto flush = [&] {
        out.write(row.data(), static_cast<std::streamsize>(row.size()));
        row.clear();
    };
    fmt::format_to(std::back_inserter(row), "time_s");
    for (const Channel& channel : recording.channels) fmt::format_to(std::back_inserter(row), ",{}", channel.name);
    const bool with_speed = !recording.speed_channel_m_per_s.empty();
    if (with_speed) fmt::format_to(std::back_inserter(row), ",speed");
    row.push_back('\n');
    for (std::size_t i = 0; i < recording.samples(); ++i) {
        fmt::format_to(std::back_inserter(row), "{:.9g}", static_cast<double>(i) / recording.sampling_rate_hz);
        for (const Channel& channel : recording.channels)
            fmt::format_to(std::back_inserter(row), ",{:.7g}", channel.acceleration_m_per_s2[i]);
        if (with_speed) fmt::format_to(std::back_inserter(row), ",{:.7g}", recording.speed_channel_m_per_s[i]);
        row.push_back('\n');
        if (row.size() > 1 << 16) flush();
    }
    flush();
}

std::string description(const Recording& recording, const std::string& data) {
    std::string text = fmt::format("kind = \"timeseries\"\nsampling_rate_hz = {:.10g}\nspeed_m_per_s = {:.10g}\n",
                                   recording.sampling_rate_hz, recording.speed_m_per_s);
    if (recording.speed_standard_error_m_per_s > 0.0)
        text += fmt::format("speed_standard_error_m_per_s = {:.6g}\n", recording.speed_standard_error_m_per_s);
    text += fmt::format("payload_kg = {:.10g}\ndata = \"{}\"\n", recording.payload_kg, data);
    for (const Channel& channel : recording.channels) {
        text += fmt::format(
            "\n[[channel]]\nname = \"{0}\"\ncolumn = \"{0}\"\nquantity = \"acceleration\"\nunit = \"m/s^2\"\nlocation "
            "= \"{1}\"\n",
            channel.name, channel.location);
        if (channel.index > 0)
            text += fmt::format("index = {}\n", channel.index);
        else
            text += fmt::format("position_m = {:.6g}\n", channel.position_m);
    }
    if (!recording.speed_channel_m_per_s.empty())
        text += "\n[[channel]]\nname = \"speed\"\ncolumn = \"speed\"\nquantity = \"speed\"\nunit = \"m/s\"\n";
    return text;
}

}  // namespace railpem::simulate
