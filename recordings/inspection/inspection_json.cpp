#include <cmath>
#include <nlohmann/json.hpp>

#include "recordings/inspection/inspection_words.hpp"
#include "recordings/inspection/inspection_writers.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json numbers_json(const std::vector<double>& values) {
    Json list = Json::array();
    for (const double value : values) list.push_back(or_null(value));
    return list;
}

Json fault_json(const Fault& fault) {
    Json j = {{"kind", fault_name(fault.kind)},
              {"severity", severity_name(fault.severity)},
              {"channels", fault.channels},
              {"says", fault.says},
              {"value", or_null(fault.value)},
              {"unit", fault.unit},
              {"false_alarm_probability", or_null(fault.false_alarm)}};
    if (fault.to_s > 0.0 || fault.from_s > 0.0) {
        j["from_s"] = fault.from_s;
        j["to_s"] = fault.to_s;
    }
    if (fault.high_hz > 0.0) {
        j["low_hz"] = fault.low_hz;
        j["high_hz"] = fault.high_hz;
    }
    return j;
}

Json channel_json(const ChannelInspection& channel) {
    Json j = {{"name", channel.description.name},
              {"place", place_words(channel.description)},
              {"quantity", quantity_name(channel.description.quantity)},
              {"unit", si_unit(channel.description.quantity)},
              {"unit_in_file", channel.unit_says},
              {"scale", channel.description.scale == Scale::known ? "known" : "unknown"},
              {"mean", or_null(channel.mean)},
              {"rms", or_null(channel.rms)},
              {"peak", or_null(channel.peak)},
              {"kurtosis", or_null(channel.kurtosis)},
              {"noise_rms_at_most", or_null(channel.noise_rms)}};
    j["bands"] = Json::array();
    for (const BandLevel& band : channel.bands)
        j["bands"].push_back({{"centre_hz", band.band.nominal_hz},
                              {"level_db", or_null(band.level_db)},
                              {"low_db", or_null(band.interval_db.low)},
                              {"high_db", or_null(band.interval_db.high)},
                              {"independent_averages", or_null(band.averages)}});
    j["lines"] = Json::array();
    for (std::size_t i = 0; i < channel.lines.size(); ++i) {
        const SpectralLine& line = channel.lines[i];
        j["lines"].push_back({{"frequency_hz", line.frequency_hz},
                              {"standard_error_hz", or_null(line.frequency_error_hz)},
                              {"rms", std::sqrt(line.mean_square)},
                              {"background_psd", or_null(line.background)},
                              {"false_alarm_probability", or_null(line.false_alarm)},
                              {"name", channel.line_names[i]}});
    }
    j["psd"] = numbers_json(channel.psd);
    if (!channel.incoherent.empty()) j["incoherent_psd"] = numbers_json(channel.incoherent);
    return j;
}

void add_tables(const InspectionReport& report, Json& j) {
    for (const ChannelSpectrum& s : report.spectra)
        j["spectra"].push_back({{"name", s.description.name},
                                {"unit_in_file", s.unit_says},
                                {"frequency_hz", numbers_json(s.frequency_hz)},
                                {"psd", numbers_json(s.psd)},
                                {"standard_error", numbers_json(s.standard_error)}});
    if (!report.receptance.frequency_hz.empty()) {
        Json real = Json::array(), imaginary = Json::array();
        for (const auto& value : report.receptance.value_m_per_n) {
            real.push_back(value.real());
            imaginary.push_back(value.imag());
        }
        j["receptance"] = {{"frequency_hz", numbers_json(report.receptance.frequency_hz)},
                           {"re_m_per_n", real},
                           {"im_m_per_n", imaginary},
                           {"has_phase", report.receptance.has_phase}};
    }
    if (!report.decay_rate.centre_hz.empty())
        j["decay_rate"] = {{"centre_hz", numbers_json(report.decay_rate.centre_hz)},
                           {"decay_rate_db_per_m", numbers_json(report.decay_rate.decay_rate_db_per_m)}};
}

Json irregularity_json(const InspectionReport& report) {
    const MeasuredIrregularity& brought = report.irregularity;
    Json j = {{"file", brought.file},
              {"kind", report.profile_length_m > 0.0 ? "profile" : "spectrum"},
              {"shortest_wavelength_m", brought.shortest_wavelength_m()},
              {"longest_wavelength_m", brought.longest_wavelength_m()}};
    const double speed = report.speed_m_per_s > 0.0 ? report.speed_m_per_s : report.stated_speed_m_per_s;
    if (speed > 0.0) {
        j["low_hz"] = speed / brought.longest_wavelength_m();
        j["high_hz"] = speed / brought.shortest_wavelength_m();
    }
    if (report.profile_length_m > 0.0) {
        j["length_m"] = report.profile_length_m;
        j["step_m"] = report.profile_step_m;
        j["rms_m"] = report.profile_rms_m;
        j["segment_length_m"] = brought.segment_length_m;
        j["independent_averages"] = brought.averages;
    }
    j["cycles_per_m"] = numbers_json(brought.cycles_per_m);
    j["psd_m3"] = numbers_json(brought.psd_m3);
    return j;
}

}  // namespace

nlohmann::ordered_json to_json(const InspectionReport& report) {
    static const char* const kinds[] = {"timeseries", "psd", "points", "receptance", "decay-rate"};
    Json j = {{"title", report.title},
              {"file", report.file},
              {"kind", kinds[static_cast<int>(report.kind)]},
              {"verdict", verdict_of(report)}};
    if (report.kind == RecordingKind::timeseries) {
        j["duration_s"] = report.duration_s;
        j["sampling_rate_hz"] = report.sampling_rate_hz;
        j["samples"] = report.samples;
        if (!report.start.empty()) j["start"] = report.start;
        j["independent_averages"] = or_null(report.averages);
        j["coherence_limit"] = or_null(report.coherence_limit);
        j["bin_interval_db"] = {or_null(report.interval_low_db), or_null(report.interval_high_db)};
    }
    const auto or_unknown = [](double speed) { return speed > 0.0 ? Json(speed) : Json(nullptr); };
    const bool known = !report.speed_along.read_from.empty();
    j["speed"] = {{"mean_m_per_s", or_unknown(report.speed_along.mean_m_per_s)},
                  {"lowest_m_per_s", known ? Json(report.speed_along.lowest_m_per_s) : Json(nullptr)},
                  {"highest_m_per_s", or_unknown(report.speed_along.highest_m_per_s)},
                  {"read_from", known ? Json(report.speed_along.read_from) : Json(nullptr)},
                  {"stated_m_per_s", or_unknown(report.stated_speed_m_per_s)},
                  {"stated_standard_error_m_per_s", report.stated_speed_error_m_per_s},
                  {"from_delays_m_per_s", or_unknown(report.speed_m_per_s)},
                  {"from_delays_standard_error_m_per_s", report.speed_error_m_per_s},
                  {"pairs", report.speed_pairs}};
    if (report.wheel_orders)
        j["wheel_rotation"] = {{"rotation_hz", report.wheel_orders->rotation_hz},
                               {"standard_error_hz", report.wheel_orders->rotation_error_hz},
                               {"orders", report.wheel_orders->orders},
                               {"lines", report.wheel_orders->lines},
                               {"false_alarm_probability", report.wheel_orders->false_alarm}};
    j["faults"] = Json::array();
    for (const Fault& fault : report.faults) j["faults"].push_back(fault_json(fault));
    j["not_checked"] = report.not_checked;
    j["lacks"] = report.lacks;
    j["notes"] = report.notes;
    j["named_frequencies"] = Json::array();
    for (const NamedFrequency& named : report.named_frequencies)
        j["named_frequencies"].push_back({{"frequency_hz", named.frequency_hz}, {"name", named.name}});
    j["frequency_hz"] = numbers_json(report.frequency_hz);
    j["channels"] = Json::array();
    for (const ChannelInspection& channel : report.channels) j["channels"].push_back(channel_json(channel));
    j["coherence"] = Json::array();
    for (const PairCoherence& pair : report.coherences)
        j["coherence"].push_back(
            {{"first", pair.first}, {"second", pair.second}, {"coherence", numbers_json(pair.coherence)}});
    add_tables(report, j);
    if (report.irregularity.brought()) j["irregularity"] = irregularity_json(report);
    return j;
}

}  // namespace railpem::recordings
