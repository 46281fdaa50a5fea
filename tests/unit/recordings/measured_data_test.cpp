// Public measured data, kept outside the project: the environment variable RAILPEM_RECORDINGS names the folder. Skipped
// without it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>

#include "recordings/files/uff.hpp"
#include "recordings/inspection/inspect.hpp"
#include "recordings/inspection/inspection_writers.hpp"
#include "recordings/loading/load_recording.hpp"
#include "recordings/loading/write_csv.hpp"
#include "recordings/text/read_csv.hpp"
#include "scratch_folder.hpp"

namespace railpem::recordings {
namespace {

using testing::ScratchFolder;
namespace fs = std::filesystem;

fs::path measured(const std::string& name) {
    const char* folder = std::getenv("RAILPEM_RECORDINGS");
    return folder && fs::exists(fs::path(folder) / name) ? fs::path(folder) / name : fs::path();
}

RecordingDescription axlebox(const std::string& data) {
    RecordingDescription d;
    d.data = data;
    d.sampling_rate_hz = 2000.0;
    d.channels = {{.name = "left",
                   .unit = "m/s^2",
                   .scale = Scale::unknown,
                   .location = Location::wheel,
                   .index = 1,
                   .side = Side::left},
                  {.name = "right",
                   .unit = "m/s^2",
                   .scale = Scale::unknown,
                   .location = Location::wheel,
                   .index = 1,
                   .side = Side::right},
                  {.name = "speed", .column = "speed_kmh", .quantity = ChannelQuantity::speed, .unit = "km/h"},
                  {.name = "mileage", .column = "km", .quantity = ChannelQuantity::mileage, .unit = "km"}};
    return d;
}

const Fault* find(const InspectionReport& report, FaultKind kind, const std::string& channel,
                  const std::string& words = "") {
    for (const Fault& fault : report.faults)
        if (fault.kind == kind && (channel.empty() || (!fault.channels.empty() && fault.channels[0] == channel)) &&
            fault.says.find(words) != std::string::npos)
            return &fault;
    return nullptr;
}

TEST(MeasuredAxleBox, KnownDefectsAreReported) {
    const fs::path folder = measured("axlebox-two-kilometres");
    if (folder.empty()) GTEST_SKIP() << "RAILPEM_RECORDINGS is not set";
    const InspectionReport km1 = inspect_file(axlebox("km1.csv"), folder),
                           km2 = inspect_file(axlebox("km2.csv"), folder);
    for (const InspectionReport* report : {&km1, &km2}) {
        EXPECT_NEAR(report->duration_s, 33.0, 1e-9);
        // Offsets of about 1.1 and 0.7, as the data's own description says.
        ASSERT_NE(find(*report, FaultKind::offset, "left"), nullptr);
        EXPECT_NEAR(find(*report, FaultKind::offset, "left")->value, 1.1, 0.1);
        ASSERT_NE(find(*report, FaultKind::offset, "right"), nullptr);
        EXPECT_NEAR(find(*report, FaultKind::offset, "right")->value, 0.7, 0.1);
        EXPECT_NE(find(*report, FaultKind::unknown_scale, "left"), nullptr);
        EXPECT_NE(find(*report, FaultKind::mileage, "", "constant step"), nullptr);
        EXPECT_NE(find(*report, FaultKind::impacts, "left"), nullptr);
        EXPECT_EQ(find(*report, FaultKind::clipping, ""), nullptr);
        EXPECT_EQ(find(*report, FaultKind::duplicated, ""), nullptr);
    }
    EXPECT_EQ(find(km1, FaultKind::mileage, "", "short"), nullptr);
    const Fault* mileage = find(km2, FaultKind::mileage, "", "short");  // "about 4 % short"
    ASSERT_NE(mileage, nullptr);
    EXPECT_NEAR(mileage->value, -0.04, 0.01);
    // The lines of the first kilometre are orders of one wheel of a usual size.
    ASSERT_TRUE(km1.wheel_orders.has_value());
    EXPECT_NEAR(km1.stated_speed_m_per_s / (2.0 * std::numbers::pi * km1.wheel_orders->rotation_hz), 0.45, 0.02);
}

TEST(MeasuredDecayRates, OneCampaignReadsAsADecayRateRecording) {
    const fs::path folder = measured("sbb-niederwangen");
    if (folder.empty()) GTEST_SKIP() << "RAILPEM_RECORDINGS is not set";
    const auto rows = read_csv_text((folder / "track_decay_rate.csv").string());
    const auto at = [&](const std::string& name) {
        return static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin());
    };
    DataTable table;
    table.names = {"centre_hz", "decay_rate_db_per_m"};
    table.columns.resize(2);
    std::string campaign;  // the first one of this rail and direction
    for (const auto& row : rows)
        if ((campaign.empty() || row[at("tdr_id")] == campaign) && row[at("sec")] == "B3" &&
            row[at("damp")] == "FALSE" && row[at("rail")] == "li" && row[at("dir")] == "v") {
            campaign = row[at("tdr_id")];
            table.columns[0].push_back(std::stod(row[at("freq")]));
            table.columns[1].push_back(std::stod(row[at("tdr")]));
        }
    ASSERT_GE(table.rows(), 15U);
    const ScratchFolder scratch;
    write_csv(scratch.file("decay.csv"), table);
    RecordingDescription d;
    d.kind = RecordingKind::decay_rate;
    d.data = "decay.csv";
    const InspectionReport report = inspect(load(d, scratch.path()));
    EXPECT_EQ(report.decay_rate.centre_hz.front(), 100.0);
    EXPECT_GE(report.lacks.size(), 2U);
    EXPECT_NE(to_text(report).find("decay rate"), std::string::npos);
}

TEST(MeasuredBeam, AccelerancesReadAsReceptanceWithTheBeamsPeaks) {
    const fs::path folder = measured("pyuff-beam-frf");
    if (folder.empty()) GTEST_SKIP() << "RAILPEM_RECORDINGS is not set";
    for (const char* name : {"meas_point_1.txt", "meas_point_2.txt", "meas_point_3.txt"}) {
        std::ifstream in(folder / name);
        UffDataset frf;
        frf.function_type = static_cast<int>(UffFunction::frequency_response);
        frf.complex = true;
        frf.ordinate_kind = 12;
        frf.denominator_kind = 13;
        frf.abscissa_kind = 18;
        frf.abscissa_step = 1.0;
        for (std::string line; std::getline(in, line);) {
            char* rest = nullptr;
            const std::size_t open = line.find('(');
            if (open == std::string::npos) continue;
            frf.real.push_back(std::strtod(line.c_str() + open + 1, &rest));
            frf.imaginary.push_back(std::strtod(rest, nullptr));
        }
        ASSERT_EQ(frf.size(), 1001U);
        const ScratchFolder scratch;
        write_uff(scratch.file("frf.uff"), {frf}, true);
        RecordingDescription d;
        d.kind = RecordingKind::receptance;
        d.data = "frf.uff";
        const Recording recording = load(d, scratch.path());
        ASSERT_EQ(recording.receptance.frequency_hz.size(), 1000U);
        // Free–free Euler beam with f1 = 51.5 Hz: 51.5, 142.0, 278.3, 460.1, 687.2 Hz; lines of 1 Hz.
        for (const double f : {52.0, 142.0, 279.0, 460.0, 687.0}) {
            std::size_t peak = static_cast<std::size_t>(f) - 1 - 8;
            for (std::size_t k = peak; k < static_cast<std::size_t>(f) + 8; ++k)
                if (std::abs(recording.receptance.value_m_per_n[k]) >
                    std::abs(recording.receptance.value_m_per_n[peak]))
                    peak = k;
            EXPECT_NEAR(recording.receptance.frequency_hz[peak], f, 1.0) << name;
        }
        EXPECT_NE(to_html(inspect(recording)).find("id=\"receptance\""), std::string::npos);
    }
}

}  // namespace
}  // namespace railpem::recordings
