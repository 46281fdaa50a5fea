#include "app/report/chart_data.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "recordings/page/thinned_spectrum.hpp"

namespace railpem::app::report {
namespace {

using diagnosis::ChannelComparison;
using diagnosis::Diagnosis;
using recordings::rounded;
using Json = nlohmann::json;

/// NaN becomes null, which the charts leave out.
Json numbers(const std::vector<double>& values) {
    Json array = Json::array();
    for (const double value : values) array.push_back(std::isfinite(value) ? Json(rounded(value)) : Json(nullptr));
    return array;
}

/// A curve on the common abscissae; `more` are the optional keys of a set.
void add_set(Json& sets, const char* name, const char* group, const std::vector<double>& values,
             const Json& more = {}) {
    if (values.empty()) return;
    Json set = {{"name", name}, {"group", group}, {"y", numbers(values)}};
    if (!more.is_null()) set.update(more);
    sets.push_back(std::move(set));
}

/// The interval as two curves with the area between them filled.
void add_band(Json& sets, const std::vector<double>& low, const std::vector<double>& high) {
    if (low.empty() || low.size() != high.size()) return;
    add_set(sets, "low", "measured", low, {{"width", 0}, {"quiet", true}});
    add_set(sets, "90 % of the estimate", "measured", high, {{"width", 0}, {"quiet", true}, {"fill", "-1"}});
}

std::string name_of(const ChannelComparison& channel) {
    return channel.recording.empty() ? channel.channel : channel.channel + ", " + channel.recording;
}

Json spectra_sets(const ChannelComparison& channel, const std::vector<recordings::BinGroup>& groups) {
    const auto thinned = [&](const std::vector<double>& values) {
        return values.size() == channel.frequency_hz.size() ? group_means(groups, values) : std::vector<double>{};
    };
    Json sets = Json::array();  // the first is painted last
    add_set(sets, "believed", "believed", thinned(channel.believed), {{"dash", {7, 4}}, {"width", 1.8}});
    add_set(sets, "retuned", "retuned", thinned(channel.retuned), {{"dash", {2, 3}}, {"width", 1.8}});
    add_set(sets, "diagnosed", "diagnosed", thinned(channel.diagnosed), {{"dash", Json::array()}, {"width", 1.8}});
    add_set(sets, "recorded (shaded: 90 %)", "measured", thinned(channel.measured),
            {{"dash", Json::array()}, {"width", 1}});
    add_band(sets, thinned(channel.low), thinned(channel.high));
    return sets;
}

Json band_sets(const ChannelComparison& channel) {
    Json sets = Json::array();
    add_set(sets, "believed", "believed", channel.band_believed_db, {{"dots", "joined"}, {"dash", {7, 4}}});
    add_set(sets, "retuned", "retuned", channel.band_retuned_db, {{"dots", "joined"}, {"dash", {2, 3}}});
    add_set(sets, "diagnosed", "diagnosed", channel.band_diagnosed_db, {{"dots", "joined"}, {"dash", Json::array()}});
    return sets;
}

std::string axis_of(const std::string& quantity) {
    if (quantity == "receptance_m_per_n") return "receptance, m/N";
    return quantity == "decay_rate_db_per_m" ? "decay rate, dB/m" : "PSD, (m/s²)²/Hz";
}

Json channel_json(const ChannelComparison& channel) {
    const std::vector<recordings::BinGroup> groups = recordings::bin_groups(channel.frequency_hz);
    return {{"name", name_of(channel)},
            {"quantity", axis_of(channel.quantity)},
            {"f", numbers(group_means(groups, channel.frequency_hz))},
            {"sets", spectra_sets(channel, groups)},
            {"centres", numbers(channel.band_centre_hz)},
            {"bands", band_sets(channel)}};
}

std::vector<double> part(const std::vector<std::complex<double>>& values, bool real) {
    std::vector<double> out;
    for (const std::complex<double>& value : values) out.push_back(real ? value.real() : value.imag());
    return out;
}

Json curve_chart(const diagnosis::InferredCurve& curve, std::size_t index, bool real) {
    Json sets = Json::array();
    add_set(sets, "inferred (shaded: 90 %)", "measured", part(curve.value, real),
            {{"dash", Json::array()}, {"width", 2}});
    add_set(sets, "retuned", "retuned", part(curve.retuned, real), {{"dash", {2, 3}}, {"width", 1.8}});
    add_set(sets, "diagnosed", "diagnosed", part(curve.diagnosed, real), {{"dash", Json::array()}, {"width", 1.8}});
    add_band(sets, real ? curve.real_low : curve.imaginary_low, real ? curve.real_high : curve.imaginary_high);
    return {{"id", (real ? "curve_real_" : "curve_imaginary_") + std::to_string(index)},
            {"x", "frequency, Hz"},
            {"y", (real ? "real part, " : "imaginary part, ") + curve.unit},
            {"yType", "linear"},
            {"f", numbers(curve.frequency_hz)},
            {"sets", sets}};
}

}  // namespace

double rms_level_db(const std::vector<double>& levels_db) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const double level : levels_db)
        if (std::isfinite(level)) {
            sum += level * level;
            ++count;
        }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : std::nan("");
}

std::size_t worst_channel(const Diagnosis& diagnosis) {
    for (const diagnosis::Mismatch& mismatch : diagnosis.mismatch)
        for (std::size_t i = 0; i < diagnosis.channels.size(); ++i)
            if (diagnosis.channels[i].channel == mismatch.channel &&
                (mismatch.recording.empty() || diagnosis.channels[i].recording == mismatch.recording))
                return i;
    std::size_t worst = 0;
    double largest = -1.0;
    for (std::size_t i = 0; i < diagnosis.channels.size(); ++i)
        if (const double rms = rms_level_db(diagnosis.channels[i].band_believed_db); rms > largest) {
            largest = rms;
            worst = i;
        }
    return worst;
}

nlohmann::json chart_data(const Diagnosis& diagnosis) {
    Json data = {{"charts", Json::array()}, {"channels", Json::array()}};
    for (const ChannelComparison& channel : diagnosis.channels) data["channels"].push_back(channel_json(channel));
    if (!diagnosis.channels.empty()) data["worst"] = worst_channel(diagnosis);
    for (std::size_t i = 0; i < diagnosis.curves.size(); ++i)
        for (const bool real : {true, false}) data["charts"].push_back(curve_chart(diagnosis.curves[i], i, real));
    return data;
}

}  // namespace railpem::app::report
