#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "recordings/inspection/inspection_charts.hpp"
#include "recordings/page/png_image.hpp"

namespace railpem::recordings {
namespace {

/// Viridis (van der Walt & Smith 2015, CC0) at nine places; equal steps look equal, in grey as well.
constexpr std::array<std::array<double, 3>, 9> viridis = {{{68, 1, 84},
                                                           {71, 44, 122},
                                                           {59, 81, 139},
                                                           {44, 113, 142},
                                                           {33, 144, 141},
                                                           {39, 173, 129},
                                                           {92, 200, 99},
                                                           {170, 220, 50},
                                                           {253, 231, 37}}};

void append_colour(double share, std::vector<std::uint8_t>& colours) {
    if (std::isnan(share)) {
        colours.insert(colours.end(), {128, 128, 128});  // missing
        return;
    }
    const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(viridis.size() - 1);
    const auto i = std::min(viridis.size() - 2, static_cast<std::size_t>(place));
    for (std::size_t c = 0; c < 3; ++c)
        colours.push_back(static_cast<std::uint8_t>(viridis[i][c] + (place - static_cast<double>(i)) *
                                                                        (viridis[i + 1][c] - viridis[i][c])));
}

double tick_step(double range) {
    const double decade = std::pow(10.0, std::floor(std::log10(range / 5.0)));
    for (const double step : {1.0, 2.0, 5.0})
        if (range / (step * decade) <= 8.0) return step * decade;
    return 10.0 * decade;
}

struct Levels {
    double low = 0.0, high = 0.0;
};

/// From the 5th to the 99.5th percentile: neither the noise nor one impact decides the colours.
Levels levels_of(const Spectrogram& s) {
    std::vector<float> sorted;
    std::copy_if(s.level_db.begin(), s.level_db.end(), std::back_inserter(sorted),
                 [](float x) { return std::isfinite(x); });
    if (sorted.empty()) return {-1.0, 1.0};
    std::sort(sorted.begin(), sorted.end());
    const Levels levels{sorted[sorted.size() / 20], sorted[sorted.size() - 1 - sorted.size() / 200]};
    return levels.high > levels.low ? levels : Levels{levels.low - 1.0, levels.low + 1.0};
}

}  // namespace

std::string spectrogram_svg(const Spectrogram& s, const InspectionReport& report) {
    constexpr double left = 60, top = 26, width = 900, height = 320;
    const Levels levels = levels_of(s);
    std::vector<std::uint8_t> colours;
    for (std::size_t b = s.bins; b-- > 0;)
        for (std::size_t t = 0; t < s.times; ++t)
            append_colour((s.level_db[t * s.bins + b] - levels.low) / (levels.high - levels.low), colours);
    const double duration = static_cast<double>(s.times - 1) * s.step_s + s.window_s,
                 highest = static_cast<double>(s.bins) * s.bin_hz;
    std::string out = fmt::format(
        "<svg class=\"spectrogram\" viewBox=\"0 0 1040 390\" role=\"img\" aria-label=\"Spectrogram of {0}\"><text "
        "x=\"{1}\" y=\"16\">{0}: {2:.0f} (dark) to {3:.0f} dB (light) re 1 (unit)²/Hz, {4:g} s windows</text>",
        s.channel, left, levels.low, levels.high, s.window_s);
    out += fmt::format(
        "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
        "href=\"data:image/png;base64,{}\"/>",
        left, top, width, height, base64(png_image(s.times, s.bins, colours)));
    out += fmt::format("<rect class=\"axis\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", left, top, width, height);
    for (double t = 0.0; t <= duration; t += tick_step(duration)) {
        const double x = left + width * t / duration;
        out += fmt::format(
            "<path class=\"axis\" d=\"M{0:.1f} {1}v5\"/><text x=\"{0:.1f}\" y=\"{2}\" text-anchor=\"middle\">{3:g} "
            "s</text>",
            x, top + height, top + height + 19, t);
    }
    for (double f = 0.0; f <= highest; f += tick_step(highest)) {
        const double y = top + height * (1.0 - f / highest);
        out += fmt::format(
            "<path class=\"axis\" d=\"M{0} {1:.1f}h-5\"/><text x=\"{2}\" y=\"{3:.1f}\" "
            "text-anchor=\"end\">{4:g}</text>",
            left, y, left - 8, y + 4, f);
    }
    out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">Hz</text>", left - 8, top - 10);
    std::vector<NamedFrequency> named = report.named_frequencies;
    std::sort(named.begin(), named.end(),
              [](const NamedFrequency& a, const NamedFrequency& b) { return a.frequency_hz < b.frequency_hz; });
    double last = 1e9;
    for (const NamedFrequency& name : named) {
        if (name.frequency_hz >= highest) continue;
        const double y = top + height * (1.0 - name.frequency_hz / highest);
        out += fmt::format("<path class=\"mark\" d=\"M{} {:.1f}h{}\"/>", left, y, width);
        if (last - y < 12.0) continue;  // no room for another name
        last = y;
        out += fmt::format("<text class=\"name\" x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", left + width - 6,
                           y - 3, name.name);
    }
    return out + "</svg>\n";
}

}  // namespace railpem::recordings
