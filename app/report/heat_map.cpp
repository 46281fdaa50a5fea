#include "app/report/heat_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/report/words.hpp"
#include "recordings/page/page_text.hpp"

namespace railpem::app::report {
namespace {

using diagnosis::ChannelComparison;
using diagnosis::Diagnosis;
using recordings::escaped;
using Levels = std::vector<double> ChannelComparison::*;

constexpr double kLeft = 124, kTop = 8, kWidth = 508, kHalfBand = 0.05;  // a third octave is 0.1 decades wide

/// What the maps have in common: rows, and the scales of frequency and colour.
struct Frame {
    std::vector<const ChannelComparison*> rows;  ///< a channel's recordings under each other
    double low = 1.0, high = 2.0;                ///< decades of frequency
    double row_height = 20.0;
    double largest_db = 1.0;

    double x(double frequency_hz) const {
        return kLeft + kWidth * std::clamp((std::log10(frequency_hz) - low) / (high - low), 0.0, 1.0);
    }
    double y(std::size_t row) const { return kTop + row_height * static_cast<double>(row); }
    double bottom() const { return y(rows.size()); }
};

Frame frame_of(const Diagnosis& diagnosis) {
    Frame frame;
    for (const ChannelComparison& channel : diagnosis.channels) {
        const auto same = [&](const ChannelComparison* row) { return row->channel == channel.channel; };
        if (std::any_of(frame.rows.begin(), frame.rows.end(), same)) continue;
        for (const ChannelComparison& other : diagnosis.channels)
            if (other.channel == channel.channel && !other.band_centre_hz.empty()) frame.rows.push_back(&other);
    }
    frame.low = 1e9;
    frame.high = -1e9;
    for (const ChannelComparison* row : frame.rows) {
        frame.low = std::min(frame.low, std::log10(row->band_centre_hz.front()) - kHalfBand);
        frame.high = std::max(frame.high, std::log10(row->band_centre_hz.back()) + kHalfBand);
        for (const Levels levels : {&ChannelComparison::band_believed_db, &ChannelComparison::band_retuned_db,
                                    &ChannelComparison::band_diagnosed_db})
            for (const double level : row->*levels)
                if (std::isfinite(level)) frame.largest_db = std::max(frame.largest_db, std::abs(level));
    }
    frame.largest_db = std::ceil(std::min(frame.largest_db, 20.0));
    frame.row_height = std::clamp(300.0 / static_cast<double>(std::max<std::size_t>(frame.rows.size(), 1)), 9.0, 28.0);
    return frame;
}

/// Small differences stay visible beside large ones: opacity grows with the square root.
double opacity(double level_db, double largest_db) {
    return std::sqrt(std::min(1.0, std::abs(level_db) / largest_db));
}

std::string cells(const Frame& frame, Levels levels) {
    std::string out;
    for (std::size_t r = 0; r < frame.rows.size(); ++r) {
        const ChannelComparison& row = *frame.rows[r];
        for (std::size_t i = 0; i < std::min(row.band_centre_hz.size(), (row.*levels).size()); ++i) {
            const double level = (row.*levels)[i], centre = row.band_centre_hz[i];
            if (!std::isfinite(level)) continue;
            const double left = frame.x(centre * std::pow(10.0, -kHalfBand));
            out += fmt::format(
                "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
                "fill-opacity=\"{:.2f}\"><title>{}, {}, {:g} Hz: {}</title></rect>",
                level > 0.0 ? "up" : "down", left, frame.y(r), frame.x(centre * std::pow(10.0, kHalfBand)) - left,
                frame.row_height, opacity(level, frame.largest_db), escaped(row.channel), escaped(row.recording),
                centre, decibels(level, true));
        }
    }
    return out + "\n";
}

std::string outlines(const Frame& frame, const Diagnosis& diagnosis) {
    std::string out;
    for (const diagnosis::Mismatch& m : diagnosis.mismatch)
        for (std::size_t r = 0; r < frame.rows.size(); ++r) {
            const ChannelComparison& row = *frame.rows[r];
            if (row.channel != m.channel && row.channel != m.other_channel) continue;
            if (!m.recording.empty() && row.recording != m.recording) continue;
            const double left = frame.x(std::max(m.low_hz, 1e-3));
            out +=
                fmt::format("<rect class=\"outline{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
                            m.other_channel.empty() ? "" : " pair", left, frame.y(r) + 0.75,
                            std::max(frame.x(std::max(m.high_hz, 1e-3)) - left, 3.0), frame.row_height - 1.5);
        }
    return out + "\n";
}

std::string axes(const Frame& frame) {
    std::string out;
    for (std::size_t r = 0; r < frame.rows.size(); ++r) {
        if (r > 0 && frame.rows[r]->channel == frame.rows[r - 1]->channel) continue;
        std::size_t end = r;
        while (end < frame.rows.size() && frame.rows[end]->channel == frame.rows[r]->channel) ++end;
        out += fmt::format("<path class=\"axis\" d=\"M{:g} {:.1f}h{:g}\"/>", kLeft, frame.y(r), kWidth);
        out += fmt::format("<text class=\"row\" x=\"{:g}\" y=\"{:.1f}\">{}</text>", kLeft - 7,
                           0.5 * (frame.y(r) + frame.y(end)) + 4, escaped(frame.rows[r]->channel));
    }
    const double bottom = frame.bottom();
    out += fmt::format("<path class=\"axis\" d=\"M{0:g} {1:.1f}h{2:g}M{0:g} {3:g}V{1:.1f}\"/>", kLeft, bottom, kWidth,
                       kTop);
    for (const double tick : {0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0}) {
        const double decade = std::log10(tick);
        if (decade < frame.low || decade > frame.high) continue;
        out += fmt::format(
            "<path class=\"axis\" d=\"M{0:.1f} {1:.1f}v5\"/><text class=\"tick\" x=\"{0:.1f}\" "
            "y=\"{2:.1f}\">{3:g}</text>",
            frame.x(tick), bottom, bottom + 19, tick);
    }
    return out + fmt::format("<text class=\"tick\" x=\"{:g}\" y=\"{:.1f}\">frequency, Hz</text>\n",
                             kLeft + 0.5 * kWidth, bottom + 36);
}

/// The colours from the most negative to the most positive difference.
std::string colour_scale(const Frame& frame) {
    const double top = frame.bottom() + 46, step = 12;
    constexpr int kSteps = 10;
    std::string out;
    for (int i = -kSteps; i <= kSteps; ++i)
        out += fmt::format(
            "<rect class=\"{}\" x=\"{:g}\" y=\"{:.1f}\" width=\"{:g}\" height=\"10\" fill-opacity=\"{:.2f}\"/>",
            i > 0 ? "up" : "down", kLeft + 134 + step * (i + kSteps), top, step, opacity(i, kSteps));
    const double middle = kLeft + 134 + step * (kSteps + 0.5);
    out += fmt::format(
        "<text class=\"tick\" x=\"{0:g}\" y=\"{1:.1f}\">0 dB</text><text class=\"row\" x=\"{2:g}\" "
        "y=\"{3:.1f}\">−{4:g} dB</text>"
        "<text class=\"end\" x=\"{5:g}\" y=\"{3:.1f}\">+{4:g} dB</text>",
        middle, top + 25, kLeft + 128, top + 9, frame.largest_db, kLeft + 140 + step * (2 * kSteps + 1));
    return out;
}

/// Which of a channel's rows is which recording.
std::string row_words(const Frame& frame) {
    std::string out;
    for (const ChannelComparison* row : frame.rows)
        if (row->channel == frame.rows[0]->channel && !row->recording.empty())
            out += fmt::format("{}{} ({} m/s)", out.empty() ? "" : ", ", escaped(row->recording),
                               figure(row->speed_m_per_s));
    return "<p class=\"soft\"><i class=\"red\">Red</i>: more was recorded than the model predicts; <i "
           "class=\"blue\">blue</i>: less." +
           (out.empty() ? out : " Rows of a channel, from the top: " + out + ".") + "</p>";
}

}  // namespace

std::string heat_maps(const Diagnosis& diagnosis) {
    const Frame frame = frame_of(diagnosis);
    if (frame.rows.empty()) return "";
    struct Map {
        const char* name;
        Levels levels;
    };
    std::string inputs, labels, maps;
    for (const Map& map :
         {Map{"believed", &ChannelComparison::band_believed_db}, Map{"retuned", &ChannelComparison::band_retuned_db},
          Map{"diagnosed", &ChannelComparison::band_diagnosed_db}}) {
        const std::string body = cells(frame, map.levels);
        if (body.size() < 2) continue;
        const bool shown =
            map.name == std::string(diagnosis.verdict == diagnosis::Verdict::consistent ? "retuned" : "believed");
        inputs +=
            fmt::format("<input type=\"radio\" name=\"map\" id=\"map_{0}\"{1}>", map.name, shown ? " checked" : "");
        labels += fmt::format("<label for=\"map_{0}\">{0}</label>", map.name);
        maps += fmt::format(
            "<svg class=\"map {0}\" viewBox=\"0 0 640 {1:.0f}\" role=\"img\" aria-label=\"Level difference of the {0} "
            "case\">{2}{3}{4}{5}</svg>\n",
            map.name, frame.bottom() + 76, body, map.name == std::string("diagnosed") ? "" : outlines(frame, diagnosis),
            axes(frame), colour_scale(frame));
    }
    return "<div class=\"maps\">" + inputs + "<div class=\"tabs\"><span>recording over</span>" + labels +
           "</div><div class=\"wide\">" + maps + "</div>" + row_words(frame) + "</div>\n";
}

}  // namespace railpem::app::report
