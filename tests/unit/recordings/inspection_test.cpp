#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "recordings/estimates/noise_floor.hpp"
#include "recordings/estimates/order_track.hpp"
#include "recordings/inspection/inspect.hpp"
#include "recordings/inspection/inspection_writers.hpp"
#include "recordings/loading/write_csv.hpp"
#include "recordings/recording_parameters.hpp"
#include "scratch_folder.hpp"
#include "synthetic_record.hpp"

namespace railpem::recordings {
namespace {

using testing::ScratchFolder;

const InspectionReport& report() {
    static const InspectionReport r = [] {
        InspectionContext context;
        context.geometry = testing::geometry();
        context.wheel_radius_m = 0.42;
        context.sleeper_spacing_m = 0.6;
        Recording recording = testing::make_record({.duration_s = 24.0, .sampling_rate_hz = 500.0, .seed = 21});
        recording.description.title = "A </script><b> title & more";
        auto& x = recording.series.channels[0].samples;
        for (std::size_t n = 0; n < x.size(); ++n)
            x[n] += 1.5 * std::sin(2.0 * std::numbers::pi * (22.2222 / 0.6) * static_cast<double>(n) / 500.0);
        x[100] = std::nan("");
        return inspect(recording, context);
    }();
    return r;
}

TEST(Inspection, TextFitsAScreenAndSaysWhatMatters) {
    const std::string text = to_text(report());
    std::size_t lines = 0, at = 0, longest = 0;
    for (std::size_t end; (end = text.find('\n', at)) != std::string::npos; at = end + 1, ++lines)
        longest = std::max(longest, end - at);
    EXPECT_LE(lines, 50U);
    EXPECT_LE(longest, 110U);  // 100 columns; a letter of UTF-8 may take three bytes
    for (const char* words : {"9 channels at 500 Hz", "missing-samples", "22.22", "independent averages",
                              "sleeper passing", "Not checked", "axlebox_1"})
        EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
}

TEST(Inspection, JsonHoldsTheReport) {
    const auto json = nlohmann::json::parse(to_json(report()).dump());
    EXPECT_EQ(json["kind"], "timeseries");
    EXPECT_EQ(json["channels"].size(), 9U);
    EXPECT_EQ(json["channels"][0]["psd"].size(), json["frequency_hz"].size());
    EXPECT_EQ(json["coherence"].size(), 36U);
    EXPECT_EQ(json["faults"][0]["kind"], "missing-samples");
    EXPECT_NEAR(json["speed"]["from_delays_m_per_s"].get<double>(), 22.2222, 0.04);
    bool named = false;
    for (const auto& line : json["channels"][0]["lines"]) named = named || line["name"] == "sleeper passing";
    EXPECT_TRUE(named) << json["channels"][0]["lines"].dump();
}

TEST(Inspection, PageIsWholeAndHarmless) {
    const std::string page = to_html(report());
    EXPECT_EQ(page.find("</script><b>"), std::string::npos);
    EXPECT_NE(page.find("A &lt;/script&gt;&lt;b&gt; title &amp; more"), std::string::npos);
    EXPECT_EQ(page.find("src=\"http"), std::string::npos);  // needs nothing beside it
    EXPECT_EQ(page.find("href=\"http"), std::string::npos);
    EXPECT_NE(page.find("Chart.js v"), std::string::npos);
    for (const char* id : {"spectra_acceleration", "coherence", "data:image/png;base64,", "prefers-color-scheme: dark"})
        EXPECT_NE(page.find(id), std::string::npos) << id;
    // The data of the charts is JSON again.
    const std::size_t begin = page.find("id=\"report\">") + 12, end = page.find("</script>", begin);
    EXPECT_TRUE(nlohmann::json::accept(page.substr(begin, end - begin)));
}

TEST(Inspection, OfAFileInSectionsFindsTheFaultAtItsTime) {
    const ScratchFolder folder;
    Recording recording = testing::make_record({.duration_s = 60.0, .sampling_rate_hz = 250.0, .seed = 22});
    auto& x = recording.series.channels[4].samples;
    for (std::size_t n = 12000; n < 12050; ++n) x[n] = std::nan("");
    write_csv(folder.file("recording.csv"), to_table(recording.series));
    const InspectionReport sections = inspect_file(recording.description, folder.path(), {}, 5000);
    const InspectionReport whole = inspect_file(recording.description, folder.path());
    EXPECT_NEAR(sections.duration_s, 60.0, 1e-9);
    ASSERT_EQ(sections.channels.size(), 9U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(sections.channels[i].rms / whole.channels[i].rms, 1.0, 0.01);
    bool found = false;
    for (const Fault& fault : sections.faults)
        if (fault.kind == FaultKind::missing_samples) {
            found = true;
            EXPECT_NEAR(fault.from_s, 48.0, 1e-6);
            EXPECT_NEAR(fault.to_s, 48.2, 1e-6);
        }
    EXPECT_TRUE(found);
}

TEST(Inspection, SectionsTellWhatTheWholeTells) {
    // Four sections against the record in one piece: the same spectra but for the segments across the joints, the same
    // line, and what all sections show alike said once.
    const ScratchFolder folder;
    Recording recording = testing::make_record({.duration_s = 96.0, .sampling_rate_hz = 250.0, .seed = 23});
    auto& x = recording.series.channels[0].samples;
    for (std::size_t n = 0; n < x.size(); ++n) {
        const double t = static_cast<double>(n) / 250.0;
        x[n] += 5.0 + (t >= 48.0 ? 2.0 * std::sin(2.0 * std::numbers::pi * 40.0 * t) : 0.0);  // in the second half only
    }
    write_csv(folder.file("recording.csv"), to_table(recording.series));
    InspectionContext context;
    context.geometry = testing::geometry();
    const InspectionReport sections = inspect_file(recording.description, folder.path(), context, 6000);
    const InspectionReport whole = inspect_file(recording.description, folder.path(), context);
    EXPECT_NEAR(sections.averages / whole.averages, 92.0 / 95.0, 0.01);  // 4 × 23 segments against 95
    ASSERT_EQ(sections.channels.size(), whole.channels.size());
    ASSERT_EQ(sections.coherences.size(), whole.coherences.size());
    for (std::size_t i = 0; i < whole.channels.size(); ++i) {
        const ChannelInspection &part = sections.channels[i], &all = whole.channels[i];
        ASSERT_EQ(part.bands.size(), all.bands.size());
        for (std::size_t b = 6; b < all.bands.size(); ++b)
            EXPECT_NEAR(part.bands[b].level_db, all.bands[b].level_db, 0.5) << all.description.name << " band " << b;
        EXPECT_NEAR(part.noise_rms / all.noise_rms, 1.0, 0.1);
        EXPECT_NEAR(part.kurtosis, all.kurtosis, 0.1);
    }
    const auto line = [](const InspectionReport& report) {
        for (const SpectralLine& l : report.channels[0].lines)
            if (std::abs(l.frequency_hz - 40.0) < 0.05) return l;
        return SpectralLine{};
    };
    EXPECT_NEAR(line(whole).mean_square, 1.0, 0.1);  // 2²/2 over half of the time
    EXPECT_NEAR(line(sections).mean_square, 1.0, 0.1);
    EXPECT_NEAR(sections.speed_m_per_s, whole.speed_m_per_s, 1e-3 * whole.speed_m_per_s);
    int offsets = 0;
    for (const Fault& fault : sections.faults)
        if (fault.kind == FaultKind::offset && fault.channels.front() == "axlebox_1") {
            ++offsets;
            EXPECT_NE(fault.says.find("the same in 4 of 4 sections"), std::string::npos) << fault.says;
            EXPECT_EQ(fault.to_s, 0.0);  // everywhere
        }
    EXPECT_EQ(offsets, 1);
}

TEST(Inspection, OtherKindsSayWhatTheyLack) {
    Recording recording;
    recording.description.kind = RecordingKind::decay_rate;
    recording.decay_rate = {{100.0, 125.0}, {11.5, 11.2}, {}};
    recording.lacks = {"no standard errors"};
    const InspectionReport r = inspect(recording);
    EXPECT_NE(to_text(r).find("no standard errors"), std::string::npos);
    EXPECT_NE(to_html(r).find("id=\"decay\""), std::string::npos);
    EXPECT_EQ(to_json(r)["decay_rate"]["centre_hz"].size(), 2U);
}

TEST(NoiseFloor, OfAChannelThatOthersExplainIsItsNoise) {
    // Two channels of one source, white noise of a known level on the second.
    std::mt19937_64 generator(3);
    std::normal_distribution<double> normal;
    TimeSeries series;
    series.sampling_rate_hz = 500.0;
    series.channels = {{{.name = "a"}, std::vector<double>(60000)}, {{.name = "b"}, std::vector<double>(60000)}};
    for (std::size_t n = 0; n < 60000; ++n) {
        series.channels[0].samples[n] = normal(generator);
        series.channels[1].samples[n] = 3.0 * series.channels[0].samples[n] + 0.05 * normal(generator);
    }
    const CrossSpectra spectra = estimate_cross_spectra(series, {.window_s = 1.0});
    const auto floor = incoherent_part(spectra, 1);
    double mean = 0.0;
    for (std::size_t k = 10; k < 240; ++k) mean += floor[k] / 230.0;
    EXPECT_NEAR(mean / (0.0025 * 2.0 / 500.0), 1.0, 0.02);  // 230 bins with 113 averages: standard error 0.8 %
}

TEST(OrderTrack, FollowsTheWheelThroughAChangeOfSpeed) {
    const double rate = 500.0, radius = 0.42;
    std::mt19937_64 generator(9);
    std::normal_distribution<double> normal;
    std::vector<double> x, speed;
    double angle = 0.0;
    for (std::size_t n = 0; n < 30000; ++n) {
        speed.push_back(20.0 + 5.0 * static_cast<double>(n) / 30000.0);
        x.push_back(0.4 * std::cos(3.0 * angle + 0.5) + normal(generator));
        angle += speed.back() / radius / rate;
    }
    const OrderTrack track = track_order(x, rate, speed, radius, 3.0);
    EXPECT_LT(track.false_alarm, 1e-6);
    EXPECT_NEAR(track.mean_square, 0.08, 0.008);
    EXPECT_NEAR(track.background / (2.0 / rate), 1.0, 0.2);
    EXPECT_NEAR(std::arg(track.amplitude[10]), 0.5, 0.3);
    EXPECT_LT(track.frequency_hz.front(), track.frequency_hz.back());
    EXPECT_GT(track_order(x, rate, speed, radius, 4.0).false_alarm, 1e-3);
}

TEST(WheelOrders, RotationFromItsMultiples) {
    const auto line = [](double f) { return SpectralLine{.frequency_hz = f, .frequency_error_hz = 0.002}; };
    // Orders 12, 16, 18, 19, 21 of 6.5444 Hz and two strangers.
    const std::vector<std::vector<SpectralLine>> lines = {{line(78.533), line(104.71), line(117.80), line(60.0)},
                                                          {line(124.344), line(137.432), line(104.712), line(91.1)}};
    const auto found = wheel_orders_of(lines, 18.61);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->rotation_hz, 6.5444, 0.001);
    EXPECT_EQ(found->orders, (std::vector<int>{12, 16, 18, 19, 21}));
    EXPECT_EQ(name_by_rotation(150.52, *found), "wheel order 23");
    // Sleepers 0.6 m apart are no wheel, though four times a radius of 0.38 m fits them; nor with a stranger that fits.
    const double passing = 18.61 / 0.6;
    const std::vector<SpectralLine> sleepers = {line(passing), line(2.0 * passing), line(3.0 * passing),
                                                line(4.0 * passing)};
    EXPECT_FALSE(wheel_orders_of({sleepers}, 18.61));
    EXPECT_FALSE(wheel_orders_of({sleepers, {line(1.25 * passing)}}, 18.61));
    EXPECT_FALSE(wheel_orders_of({sleepers, {line(1.25 * passing)}}, 18.61, 0.6));
    // Lines anywhere are multiples of nothing.
    int named = 0;
    std::mt19937_64 generator(12);
    std::uniform_real_distribution<double> anywhere(5.0, 300.0);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<SpectralLine> strangers;
        for (int i = 0; i < 10; ++i) strangers.push_back(line(anywhere(generator)));
        named += wheel_orders_of({strangers}, 20.0) ? 1 : 0;
    }
    EXPECT_LE(named, 2);  // 1e-3 each
}

TEST(RecordingFields, ReadAndWriteEveryKey) {
    RecordingDescription d;
    for (const auto& field : recording_fields()) {
        EXPECT_FALSE(field.description.says.empty()) << field.description.key;
        field.set(d, field.get(d));
    }
    for (const auto& field : recording_fields())
        if (field.description.key == "kind") field.set(d, std::string("decay-rate"));
    EXPECT_EQ(d.kind, RecordingKind::decay_rate);
    ChannelDescription c;
    for (const auto& field : channel_fields()) {
        field.set(c, field.get(c));
        if (field.description.key == "quantity") field.set(c, std::string("mileage"));
        if (field.description.key == "location") field.set(c, std::string("rail"));
    }
    EXPECT_EQ(c.quantity, ChannelQuantity::mileage);
    EXPECT_EQ(c.location, Location::rail);
}

}  // namespace
}  // namespace railpem::recordings
