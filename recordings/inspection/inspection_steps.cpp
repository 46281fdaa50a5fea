#include "recordings/inspection/inspection_steps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recordings/checks/line_names.hpp"
#include "recordings/estimates/confidence.hpp"
#include "recordings/estimates/noise_floor.hpp"
#include "recordings/inspection/named_frequencies.hpp"

namespace railpem::recordings {
namespace {

double speed_for_names(const InspectionReport& report) {
    return report.speed_m_per_s > 0.0 ? report.speed_m_per_s : report.stated_speed_m_per_s;
}

void describe_channel(const CrossSpectra& spectra, std::size_t i, ChannelInspection& inspection) {
    for (std::size_t k = 0; k < spectra.bins(); ++k) inspection.psd.push_back(spectra.psd(k, i));
    inspection.bands = band_levels(spectra, i);
    if (spectra.size() < 2 || spectra.averages < 2.0 * static_cast<double>(spectra.size())) return;
    inspection.incoherent = incoherent_part(spectra, i);
    double power = 0.0;
    for (std::size_t k = 0; k < spectra.bins(); ++k)
        if (spectra.frequency_hz[k] > 4.0 && spectra.frequency_hz[k] < 0.4 * spectra.sampling_rate_hz &&
            std::isfinite(inspection.incoherent[k]))
            power += inspection.incoherent[k] * spectra.kernel().bin_hz();
    if (power > 0.0) inspection.noise_rms = std::sqrt(power);
}

}  // namespace

void describe_spectra(const CrossSpectra& spectra, InspectionReport& report) {
    report.frequency_hz = spectra.frequency_hz;
    report.averages = spectra.averages;
    report.coherence_limit = coherence_limit(spectra.averages, 0.05);
    const Interval interval = spectrum_interval(spectra.averages);
    report.interval_low_db = 10.0 * std::log10(interval.low);
    report.interval_high_db = 10.0 * std::log10(interval.high);
    for (std::size_t i = 0; i < spectra.size(); ++i) describe_channel(spectra, i, report.channels[i]);
    for (std::size_t i = 0; i < spectra.size(); ++i)
        for (std::size_t j = i + 1; j < spectra.size(); ++j) {
            PairCoherence pair{spectra.channels[i].name, spectra.channels[j].name, {}};
            for (std::size_t k = 0; k < spectra.bins(); ++k) pair.coherence.push_back(spectra.coherence(k, i, j));
            report.coherences.push_back(std::move(pair));
        }
}

void name_lines(const InspectionContext& context, InspectionReport& report) {
    if (report.kind != RecordingKind::timeseries) return;
    const double speed = speed_for_names(report);
    const double speed_error = report.speed_m_per_s > 0.0 ? report.speed_error_m_per_s
                                                          : std::max(0.01 * speed, report.stated_speed_error_m_per_s);
    std::vector<std::vector<SpectralLine>> lines;
    for (const ChannelInspection& channel : report.channels) lines.push_back(channel.lines);
    report.wheel_orders = wheel_orders_of(lines, speed, context.sleeper_spacing_m);
    for (ChannelInspection& channel : report.channels)
        for (const SpectralLine& line : channel.lines) {
            std::string name = name_of_line(line.frequency_hz, speed, speed_error, context);
            if (name.empty() && report.wheel_orders) name = name_by_rotation(line.frequency_hz, *report.wheel_orders);
            channel.line_names.push_back(std::move(name));
        }
    InspectionContext known = context;
    if (known.wheel_radius_m <= 0.0 && report.wheel_orders)
        known.wheel_radius_m = speed / (2.0 * std::numbers::pi * report.wheel_orders->rotation_hz);
    report.named_frequencies = named_frequencies(speed, 0.5 * report.sampling_rate_hz, known);
}

void sort_faults(std::vector<Fault>& faults) {
    std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
        return static_cast<int>(a.severity) > static_cast<int>(b.severity);
    });
}

}  // namespace railpem::recordings
