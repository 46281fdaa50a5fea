#include <gtest/gtest.h>

#include "tests/verification/simulate/transfer.hpp"

namespace railpem::tests {
namespace {

void expect_agreement(const pem::CaseParameters& parameters) {
    const auto differences = compare(parameters, standing_options(parameters, 16.0));
    for (const ChannelDifference& d : differences) {
        std::printf("%-10s median %.4f largest %.4f dB\n", d.channel.c_str(), d.median_db, d.largest_db);
        EXPECT_LT(d.median_db, 0.05) << d.channel;
    }
}

TEST(Standing, Case1) { expect_agreement(paper_case(1)); }
TEST(Standing, Case2Causal) {
    auto c = paper_case(2);
    c.track.pads.causal = true;
    expect_agreement(c);
}
TEST(Standing, Case3Causal) {
    auto c = paper_case(3);
    c.track.pads.causal = true;
    expect_agreement(c);
}

}  // namespace
}  // namespace railpem::tests
