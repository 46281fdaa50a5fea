// `railpem receptance`: the tables of the contract, and that they hold what the track gives.

#include "app/tables/track_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/schema/case_file.hpp"
#include "program_in_process.hpp"

namespace railpem::app {
namespace {

using Names = std::vector<std::string>;

TEST(Receptance, TablesOfTheContract) {
    const Scratch scratch;
    ASSERT_EQ(
        run({"receptance", shipped("ballasted/uic60.toml"), "--out", scratch.path("new/out"), "--threads", "1"}).status,
        0);
    const std::string text = scratch.read("new/out/uic60.receptance.csv");
    EXPECT_EQ(text.substr(0, text.find('\n')),
              "frequency_hz,over_pad_re_m_per_n,over_pad_im_m_per_n,mid_bay_re_m_per_n,mid_bay_im_m_per_n");
    const auto table = columns(text);
    const std::vector<double>& f = table.at("frequency_hz");
    ASSERT_EQ(f.size(), 1500u);
    EXPECT_DOUBLE_EQ(f.front(), 20.0);
    EXPECT_NEAR(f.back(), 5000.0, 5e-6);  // nine digits
    EXPECT_NEAR(f[1] / f[0], f[1499] / f[1498], 1e-7);
    for (const double im : table.at("over_pad_im_m_per_n")) EXPECT_LT(im, 0.0);  // e^{+iωt}: work is done on the track
    for (const double im : table.at("mid_bay_im_m_per_n")) EXPECT_LT(im, 0.0);

    const std::string decay_text = scratch.read("new/out/uic60.decay.csv");
    EXPECT_EQ(decay_text.substr(0, decay_text.find('\n')), "centre_hz,decay_rate_db_per_m,bloch_decay_rate_db_per_m");
    const auto decay = columns(decay_text);
    // Bands that lie wholly within 20 to 5000 Hz: the one of 20 Hz begins at 17.8 Hz, that of 5000 Hz ends at 5.6 kHz.
    EXPECT_EQ(decay.at("centre_hz").front(), 25.0);
    EXPECT_EQ(decay.at("centre_hz").back(), 4000.0);
    EXPECT_EQ(decay.at("centre_hz").size(), 23u);
}

/// Force and response of the tables are those of pem/coupling/track_response.hpp at the frequencies asked for; one or
/// two threads.
TEST(Receptance, RangeLinesOverridesAndThreads) {
    const Scratch scratch;
    const Names arguments{"receptance", shipped("ballasted/uic60.toml"),
                          "--from",     "100",
                          "--to",       "800",
                          "--lines",    "40",
                          "--set",      "track.pads.static_stiffness_n_per_m=100e6",
                          "--out"};
    for (const char* threads : {"1", "2"}) {
        Names all = arguments;
        all.insert(all.end(), {scratch.path(threads), "--threads", threads});
        ASSERT_EQ(run(all).status, 0);
    }
    // without the comment that says which command made them
    const auto numbers = [&](const std::string& file) {
        const std::string text = scratch.read(file);
        return text.substr(0, text.find("# "));
    };
    EXPECT_EQ(numbers("1/uic60.receptance.csv"), numbers("2/uic60.receptance.csv"));
    EXPECT_EQ(numbers("1/uic60.decay.csv"), numbers("2/uic60.decay.csv"));
    const CaseFile file = read_case(shipped("ballasted/uic60.toml"), {"track.pads.static_stiffness_n_per_m=100e6"});
    const pem::TrackResponse direct =
        pem::track_response(file.parameters, pem::geometric_lines(100.0, 800.0, 40), true, 1);
    EXPECT_EQ(numbers("1/uic60.receptance.csv"), csv_text(receptance_table(direct)));
    EXPECT_EQ(columns(scratch.read("1/uic60.receptance.csv")).at("frequency_hz").size(), 40u);
}

/// Around the pinned–pinned frequency (1068 Hz): a dip below it, where the supports stand in nodes of the wave, a peak
/// in the stop band above it; in both decay rates. Above 1.5 kHz, with hardly any near field, they agree within 12 %.
TEST(Receptance, DecayRateAroundThePinnedPinnedFrequency) {
    const CaseFile file = read_case(shipped("ballasted/uic60.toml"), {});
    const pem::TrackResponse response =
        pem::track_response(file.parameters, pem::geometric_lines(20.0, 5000.0, 1500), true, 1);
    const NumberTable table = decay_table(response, 0.6);
    const auto at = [&](std::size_t column, double centre) {
        const auto found = std::find(table.columns[0].begin(), table.columns[0].end(), centre);
        return table.columns[column][static_cast<std::size_t>(found - table.columns[0].begin())];
    };
    for (const std::size_t column : {1u, 2u}) {
        EXPECT_LT(at(column, 1000.0), at(column, 800.0)) << column;
        EXPECT_GT(at(column, 1250.0), 1.5 * at(column, 1000.0)) << column;
        EXPECT_GT(at(column, 1250.0), 1.5 * at(column, 1600.0)) << column;
    }
    for (const double centre : {1600.0, 2000.0, 2500.0, 3150.0, 4000.0})
        EXPECT_NEAR(at(1, centre) / at(2, centre), 1.0, 0.12) << centre;
}

TEST(Receptance, BadRangesAreRefused) {
    const Scratch scratch;
    const auto refused = [&](const Names& extra) {
        Names all{"receptance", shipped("ballasted/uic60.toml"), "--out", scratch.path("out")};
        all.insert(all.end(), extra.begin(), extra.end());
        return run(all);
    };
    const ProgramResult empty = refused({"--from", "500", "--to", "100"});
    EXPECT_EQ(empty.status, 2);
    EXPECT_EQ(empty.message,
              "railpem receptance: --from 500 --to 100: no frequency between them\nallowed: --from less than --to\n");
    EXPECT_EQ(refused({"--from", "0"}).status, 2);
    EXPECT_EQ(refused({"--lines", "1"}).status, 2);
    EXPECT_EQ(refused({"--to", "nan"}).status, 2);
    EXPECT_FALSE(scratch.has("out"));
}

TEST(Receptance, FailedFastenersAreSaidToBeLeftOut) {
    const Scratch scratch;
    const ProgramResult result = run({"receptance", shipped("ballasted/uic60.toml"), "--lines", "10", "--set",
                                      "track.failed_fasteners[1].every=5", "--out", scratch.path("out")});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.message,
              "uic60: every support is taken as intact; failed fasteners are left out of receptance and decay rate\n");
}

}  // namespace
}  // namespace railpem::app
