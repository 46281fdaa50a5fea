// A long recording in bounded memory, and the time of reading and estimating.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>

#include "recordings/estimates/cross_spectra.hpp"
#include "recordings/loading/load_recording.hpp"
#include "recordings/loading/write_csv.hpp"
#include "tests/unit/recordings/scratch_folder.hpp"
#include "tests/unit/recordings/synthetic_record.hpp"

namespace railpem::recordings {
namespace {

long peak_kilobytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

double processor_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

TEST(Speed, NineChannelsOfAMinuteAreReadAndEstimatedInHalfASecond) {
    const testing::ScratchFolder folder;
    const Recording made = testing::make_record({.duration_s = 60.0, .seed = 2});
    write_csv(folder.file("recording.csv"), to_table(made.series));
    double best = 1e9;
    for (int repeat = 0; repeat < 3; ++repeat) {
        const double before = processor_seconds();  // of one core, whatever else the machine does
        const Recording recording = load(made.description, folder.path());
        const CrossSpectra spectra = estimate_cross_spectra(recording.series, {.window_s = 2.0});
        best = std::min(best, processor_seconds() - before);
        ASSERT_EQ(spectra.segments.count, 59U);
    }
    RecordProperty("processor_seconds", std::to_string(best));
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
    EXPECT_LT(best, 0.5);
#endif
}

TEST(Streaming, SpectraOfALongFileNeedTheMemoryOfOneSection) {
    // 16 channels at 2 kHz, a minute of it (15 MB) by default; RAILPEM_LONG_RECORDING_S = 3600 makes the hour of 900
    // MB.
    const char* wanted = std::getenv("RAILPEM_LONG_RECORDING_S");
    const int seconds = wanted ? std::atoi(wanted) : 60;
    const testing::ScratchFolder folder;
    RecordingDescription description;
    description.data = "long.csv";
    description.sampling_rate_hz = 2000.0;
    {
        std::mt19937_64 generator(1);
        std::normal_distribution<double> normal;
        std::ofstream out(folder.file("long.csv"), std::ios::binary);
        std::string block;
        for (int i = 0; i < 16; ++i) {
            description.channels.push_back({.name = "c" + std::to_string(i), .unit = "m/s^2"});
            out << (i > 0 ? "," : "") << "c" << i;
        }
        out << "\n";
        for (int row = 0; row < 2000; ++row)
            for (int i = 0; i < 16; ++i) {
                char text[16];
                std::snprintf(text, sizeof text, "%.4f%c", normal(generator), i < 15 ? ',' : '\n');
                block += text;
            }
        for (int i = 0; i < seconds; ++i) out << block;
    }
    const long before = peak_kilobytes();
    CrossSpectra all;
    std::size_t sections = 0;
    load_in_sections(description, folder.path(), 40000, [&](const Recording& section) {
        const CrossSpectra part = estimate_cross_spectra(section.series, {.window_s = 1.0});
        all = sections++ == 0 ? part : merged({all, part});
    });
    EXPECT_EQ(sections, static_cast<std::size_t>((seconds + 19) / 20));
    double power = 0.0;
    for (std::size_t k = 0; k < all.bins(); ++k) power += all.psd(k, 7) * all.kernel().bin_hz();
    EXPECT_NEAR(power, 1.0, 0.1);  // white noise of unit variance, one second of it repeated
    // A section of 40 000 × 16 numbers is 5 MB; it is held three times (table, channels, without trend), and the
    // matrices are 8 MB twice.
#if !defined(__SANITIZE_ADDRESS__)  // which keeps what was given back
    EXPECT_LT(peak_kilobytes() - before, 80000);
#endif
    RecordProperty("megabytes", std::to_string((peak_kilobytes() - before) / 1024));
}

}  // namespace
}  // namespace railpem::recordings
