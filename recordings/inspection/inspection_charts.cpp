#include "recordings/inspection/inspection_charts.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "recordings/page/thinned_spectrum.hpp"
#include "recordings/units.hpp"

namespace railpem::recordings {
namespace {

using ChartJson = nlohmann::json;

std::string group_of(const ChannelDescription& channel) {
    static const char* const names[] = {"none", "body", "bogie", "wheel", "rail"};
    return names[static_cast<int>(channel.location)];
}

/// Means of groups of bins; zero is left out.
ChartJson curve(const std::vector<double>& frequency, const std::vector<double>& values) {
    const std::vector<BinGroup> groups = bin_groups(frequency);
    const std::vector<double> x = group_means(groups, frequency), y = group_means(groups, values);
    ChartJson points = ChartJson::array();
    for (std::size_t k = 0; k < groups.size(); ++k)
        if (y[k] > 0.0) points.push_back({{"x", x[k]}, {"y", y[k]}});
    return points;
}

ChartJson points_of(const std::vector<double>& frequency, const std::vector<double>& values) {
    ChartJson points = ChartJson::array();
    for (std::size_t k = 0; k < frequency.size(); ++k)
        if (frequency[k] > 0.0 && std::isfinite(values[k]))
            points.push_back({{"x", rounded(frequency[k])}, {"y", rounded(values[k])}});
    return points;
}

ChartJson spectra_chart(const InspectionReport& report, ChannelQuantity quantity) {
    ChartJson sets = ChartJson::array();
    for (const ChannelInspection& channel : report.channels)
        if (channel.description.quantity == quantity && !channel.psd.empty())
            sets.push_back({{"name", channel.description.name},
                            {"group", group_of(channel.description)},
                            {"points", curve(report.frequency_hz, channel.psd)}});
    for (const ChannelSpectrum& spectrum : report.spectra)
        if (spectrum.description.quantity == quantity && !spectrum.psd.empty())
            sets.push_back({{"name", spectrum.description.name},
                            {"group", group_of(spectrum.description)},
                            {"points", points_of(spectrum.frequency_hz, spectrum.psd)},
                            {"dots", report.kind == RecordingKind::points}});
    const bool scaled = std::none_of(report.channels.begin(), report.channels.end(), [&](const ChannelInspection& c) {
        return c.description.quantity == quantity && c.description.scale == Scale::unknown;
    });
    return {
        {"id", "spectra_" + quantity_name(quantity)},
        {"x", "frequency, Hz"},
        {"y", "PSD of " + quantity_name(quantity) + (scaled ? ", (" + si_unit(quantity) + ")²/Hz" : ", scale unknown")},
        {"yType", "logarithmic"},
        {"sets", sets},
        {"marks", true}};
}

/// The six pairs that share most, by mean coherence, and the limit of chance.
ChartJson coherence_chart(const InspectionReport& report) {
    std::vector<std::pair<double, const PairCoherence*>> pairs;
    for (const PairCoherence& pair : report.coherences)
        pairs.emplace_back(std::accumulate(pair.coherence.begin(), pair.coherence.end(), 0.0), &pair);
    std::sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    static const char* const groups[] = {"wheel", "bogie", "body", "rail", "none", "mark"};
    ChartJson sets = ChartJson::array();
    for (std::size_t i = 0; i < std::min<std::size_t>(6, pairs.size()); ++i)
        sets.push_back({{"name", pairs[i].second->first + " – " + pairs[i].second->second},
                        {"group", groups[i]},
                        {"dash", ChartJson::array()},
                        {"points", curve(report.frequency_hz, pairs[i].second->coherence)}});
    if (!report.frequency_hz.empty())
        sets.push_back(
            {{"name", "5 % limit of unrelated channels"},
             {"group", "none"},
             {"dash", {6, 4}},
             {"points", ChartJson::array({{{"x", report.frequency_hz[1]}, {"y", report.coherence_limit}},
                                          {{"x", report.frequency_hz.back()}, {"y", report.coherence_limit}}})}});
    return {{"id", "coherence"},
            {"x", "frequency, Hz"},
            {"y", "coherence γ²"},
            {"yType", "linear"},
            {"sets", sets},
            {"marks", true},
            {"limits", {{"y", {{"min", 0}, {"max", 1}}}}}};
}

}  // namespace

nlohmann::json chart_data(const InspectionReport& report) {
    ChartJson data = {{"named", ChartJson::array()}, {"charts", ChartJson::array()}};
    for (const NamedFrequency& named : report.named_frequencies)
        data["named"].push_back({{"f", rounded(named.frequency_hz)}, {"name", named.name}});
    for (const ChannelQuantity quantity :
         {ChannelQuantity::acceleration, ChannelQuantity::velocity, ChannelQuantity::displacement})
        if (ChartJson chart = spectra_chart(report, quantity); !chart["sets"].empty())
            data["charts"].push_back(std::move(chart));
    if (!report.coherences.empty()) data["charts"].push_back(coherence_chart(report));
    if (!report.receptance.frequency_hz.empty()) {
        std::vector<double> magnitude;
        for (const auto& value : report.receptance.value_m_per_n) magnitude.push_back(std::abs(value));
        data["charts"].push_back(
            {{"id", "receptance"},
             {"x", "frequency, Hz"},
             {"y", "receptance, m/N"},
             {"yType", "logarithmic"},
             {"sets", ChartJson::array({{{"name", "magnitude"},
                                         {"group", "rail"},
                                         {"points", points_of(report.receptance.frequency_hz, magnitude)}}})}});
    }
    if (!report.decay_rate.centre_hz.empty())
        data["charts"].push_back(
            {{"id", "decay"},
             {"x", "third-octave, Hz"},
             {"y", "decay rate, dB/m"},
             {"yType", "logarithmic"},
             {"sets", ChartJson::array({{{"name", "decay rate"},
                                         {"group", "rail"},
                                         {"markers", true},
                                         {"points", points_of(report.decay_rate.centre_hz,
                                                              report.decay_rate.decay_rate_db_per_m)}}})}});
    if (report.irregularity.brought())
        data["charts"].push_back(
            {{"id", "irregularity"},
             {"x", "cycles per metre"},
             {"xUnit", "cycles/m"},
             {"y", "PSD of the irregularity, m³"},
             {"yType", "logarithmic"},
             {"sets",
              ChartJson::array(
                  {{{"name", "measured irregularity"},
                    {"group", "rail"},
                    {"points", report.profile_length_m > 0.0
                                   ? curve(report.irregularity.cycles_per_m, report.irregularity.psd_m3)
                                   : points_of(report.irregularity.cycles_per_m, report.irregularity.psd_m3)}}})}});
    return data;
}

}  // namespace railpem::recordings
