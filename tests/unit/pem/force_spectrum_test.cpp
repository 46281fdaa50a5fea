#include "pem/force_spectrum.hpp"

#include <gtest/gtest.h>

namespace railpem::pem {
namespace {

const std::vector<double> kNodes{2.0, 8.0, 32.0};

TEST(ForceSpectrum, WeightsShareEveryFrequency) {
    for (const double f : {0.5, 2.0, 3.0, 8.0, 20.0, 32.0, 100.0}) {
        double sum = 0.0;
        for (std::size_t node = 0; node < kNodes.size(); ++node) {
            EXPECT_GE(ForceSpectrum::weight(kNodes, node, f), 0.0);
            sum += ForceSpectrum::weight(kNodes, node, f);
        }
        EXPECT_NEAR(sum, 1.0, 1e-14) << f;
    }
    EXPECT_EQ(ForceSpectrum::weight(kNodes, 1, 8.0), 1.0);
    EXPECT_EQ(ForceSpectrum::weight(kNodes, 0, 8.0), 0.0);
}

// Half-way between the nodes on the logarithmic axis: the reference's geometric mean, the shares' arithmetic one.
TEST(ForceSpectrum, ReferenceTimesShare) {
    const ForceSpectrum force{
        .frequency_hz = kNodes, .reference_n2_per_hz = {1.0, 100.0, 4.0}, .share = {0.2, 0.4, 0.0}};
    EXPECT_NEAR(force.at(2.0), 0.2, 1e-14);
    EXPECT_NEAR(force.at(4.0), 10.0 * 0.3, 1e-13);
    EXPECT_NEAR(force.at(16.0), 20.0 * 0.2, 1e-13);
    EXPECT_EQ(force.at(64.0), 0.0);
    EXPECT_EQ(ForceSpectrum{}.at(5.0), 0.0);
}

}  // namespace
}  // namespace railpem::pem
