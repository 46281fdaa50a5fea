// Beliefs about the irregularity from measured spectra and profiles.

#include "diagnosis/observations/measured_irregularity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/model/trial.hpp"
#include "spectra/irregularity_spectrum.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

const spectra::IrregularityParameters believed{.bands = {{.family = spectra::Family::power_law,
                                                          .shortest_wavelength_m = 0.1,
                                                          .longest_wavelength_m = 100.0,
                                                          .coefficient_m3 = 1e-7,
                                                          .exponent = 3.0}}};

/// The believed spectrum times a factor, on even lines as a profile's estimate has them, or as a coarse table.
recordings::MeasuredIrregularity measured(double factor, double averages, double from, double to, double ratio) {
    recordings::MeasuredIrregularity own{.file = "track.csv", .averages = averages};
    for (double n = from; n<to; n = averages> 0.0 ? n + ratio : n * ratio) {
        own.cycles_per_m.push_back(n);
        own.psd_m3.push_back(factor * spectra::irregularity_psd_m3(believed, n));
    }
    if (averages > 0.0) own.height_m = {0.0, 1.0};  // marks a profile
    return own;
}

const std::vector<double> wavelengths{0.5, 0.7, 1.0, 1.4, 2.0, 2.8, 4.0};

TEST(NodeBeliefs, SpectrumGivesItsFactorEverywhere) {
    for (const NodeBelief& belief : node_beliefs(believed, {measured(2.0, 0.0, 0.05, 10.0, 1.6)}, wavelengths)) {
        EXPECT_TRUE(belief.measured);
        EXPECT_NEAR(belief.mean, std::log(2.0), 1e-6);
        EXPECT_NEAR(belief.deviation, 0.1, 1e-12);
    }
}

TEST(NodeBeliefs, ProfileKnowsAsMuchAsItsAveragesAndLines) {
    const auto beliefs = node_beliefs(believed, {measured(0.5, 15.0, 0.01, 5.0, 0.01)}, wavelengths);
    for (std::size_t i = 1; i + 1 < wavelengths.size(); ++i) {
        const double lines =
            (1.0 / wavelengths[i]) *
            (std::sqrt(wavelengths[i] / wavelengths[i - 1]) - 1.0 / std::sqrt(wavelengths[i] / wavelengths[i - 1])) /
            0.01;
        EXPECT_NEAR(beliefs[i].mean, std::log(0.5), 1e-6);
        EXPECT_NEAR(beliefs[i].deviation, std::max(0.02, 1.0 / std::sqrt(15.0 * lines)), 0.02);
    }
}

TEST(NodeBeliefs, LeaveWhatWasNotMeasured) {
    const auto beliefs = node_beliefs(believed, {measured(2.0, 0.0, 0.05, 0.9, 1.1)}, wavelengths);
    EXPECT_FALSE(beliefs[0].measured);
    EXPECT_TRUE(beliefs.back().measured);
    for (const NodeBelief& belief : node_beliefs(believed, {}, wavelengths)) EXPECT_FALSE(belief.measured);
}

TEST(NodeBeliefs, WeighSeveralByTheirPrecision) {
    const auto beliefs =
        node_beliefs(believed, {measured(2.0, 0.0, 0.05, 10.0, 1.1), measured(8.0, 0.0, 0.05, 10.0, 1.1)}, wavelengths);
    EXPECT_NEAR(beliefs[3].mean, std::log(4.0), 1e-6);
    EXPECT_NEAR(beliefs[3].deviation, 0.1 / std::sqrt(2.0), 1e-12);
}

}  // namespace
}  // namespace railpem::diagnosis
