#include "spectra/profile_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "parameters/parameter_error.hpp"
#include "spectra/irregularity_spectrum.hpp"

namespace railpem::spectra {
namespace {

struct Profile {
    std::vector<double> position, height;
};

Profile sine(double wavelength_m, double amplitude_m, double slope = 0.0, int samples = 4000, double step_m = 0.25) {
    Profile profile;
    for (int i = 0; i < samples; ++i) {
        const double x = i * step_m;
        profile.position.push_back(1000.0 + x);
        profile.height.push_back(0.01 + slope * x +
                                 amplitude_m * std::sin(2.0 * std::numbers::pi * x / wavelength_m + 0.3));
    }
    return profile;
}

double power(const ProfileSpectrum& spectrum) {
    double sum = 0.0;
    for (const double psd : spectrum.psd_m3) sum += psd / spectrum.segment_length_m;
    return sum;
}

TEST(ProfileSpectrum, SineHasHalfItsAmplitudeSquared) {
    const auto profile = sine(5.0, 2e-3);
    const auto spectrum = spectrum_of_profile(profile.position, profile.height, 100.0);
    EXPECT_DOUBLE_EQ(spectrum.segment_length_m, 100.0);  // 400 samples = 2⁴·5²
    EXPECT_EQ(spectrum.segments, 19);
    // 20 periods per segment: the line has no leakage but through the straight line that the fit takes from a sine
    // (of the order 6/(π²·20²) of its power, 1.5e-3).
    EXPECT_NEAR(power(spectrum) / 2e-6, 1.0, 1.5e-3);
    // Hann spreads a line over three bins, 1/6 : 2/3 : 1/6 in power.
    EXPECT_NEAR(spectrum.psd_m3[20 - 2] / 100.0 / 2e-6, 2.0 / 3.0, 1.5e-3);
}

TEST(ProfileSpectrum, LevelAndGradientDoNotCount) {
    const auto flat = sine(5.0, 2e-3), steep = sine(5.0, 2e-3, 1e-3);
    const auto a = spectrum_of_profile(flat.position, flat.height, 100.0);
    const auto b = spectrum_of_profile(steep.position, steep.height, 100.0);
    // The gradient reaches 1 m over the profile: 2⁻⁵³·1 m against amplitudes of 2e-3 m, times the 400 terms of a sum.
    for (std::size_t i = 0; i < a.psd_m3.size(); ++i) EXPECT_NEAR(b.psd_m3[i], a.psd_m3[i], 1e-10 * 100.0 * 2e-6);
}

TEST(ProfileSpectrum, AveragesOfOverlappingSegments) {
    const auto profile = sine(5.0, 2e-3);
    EXPECT_DOUBLE_EQ(spectrum_of_profile(profile.position, profile.height, 1000.0).averages, 1.0);
    // Two segments overlapping by half: variance (1 + 1/36)/2.
    EXPECT_DOUBLE_EQ(spectrum_of_profile(profile.position, profile.height, 600.0).averages, 2.0 / (1.0 + 1.0 / 36.0));
}

TEST(ProfileSpectrum, SegmentLengthIsRoundedDownToAQuickOne) {
    const auto profile = sine(5.0, 2e-3);
    // 101 m are 404 = 4·101 samples; 400 is the next below without a prime above 5.
    EXPECT_DOUBLE_EQ(spectrum_of_profile(profile.position, profile.height, 101.0).segment_length_m, 100.0);
}

TEST(ProfileSpectrum, BecomesABandOfTheCase) {
    const auto profile = sine(5.0, 2e-3);
    const auto spectrum = spectrum_of_profile(profile.position, profile.height, 100.0);
    const auto band = measured_band(spectrum);
    IrregularityParameters irregularity;
    irregularity.bands = {band};
    EXPECT_NO_THROW(check(irregularity));
    EXPECT_DOUBLE_EQ(band_psd_m3(band, spectrum.cycles_per_m[18]), spectrum.psd_m3[18]);
    EXPECT_EQ(band_psd_m3(band, 0.9 * spectrum.cycles_per_m.front()), 0.0);
    EXPECT_EQ(band_psd_m3(band, 1.1 * spectrum.cycles_per_m.back()), 0.0);
}

std::string refusal(const Profile& profile, double segment_length_m) {
    try {
        spectrum_of_profile(profile.position, profile.height, segment_length_m);
    } catch (const parameters::ParameterError& error) {
        EXPECT_EQ(error.key(), "irregularity.profile");
        return error.problem();
    }
    return "accepted";
}

TEST(ProfileSpectrum, RefusesWhatIsNoProfile) {
    const auto good = sine(5.0, 2e-3);
    EXPECT_EQ(refusal(good, 100.0), "accepted");
    EXPECT_EQ(refusal(good, 1001.0), "the segments cannot be cut from the profile");
    EXPECT_EQ(refusal(good, 3.0), "the segments cannot be cut from the profile");
    EXPECT_EQ(refusal(good, std::nan("")), "the segments cannot be cut from the profile");
    auto uneven = good;
    uneven.position[17] += 0.01;
    EXPECT_EQ(refusal(uneven, 100.0), "the positions do not increase in even steps");
    auto backwards = good;
    for (double& x : backwards.position) x = -x;
    EXPECT_EQ(refusal(backwards, 100.0), "the positions do not increase in even steps");
    auto hole = good;
    hole.height[5] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal(hole, 100.0), "a position or height is not a finite number");
    auto longer = good;
    longer.height.push_back(0.0);
    EXPECT_EQ(refusal(longer, 100.0), "as many positions as heights are needed");
    auto flat = good;
    flat.height.assign(flat.height.size(), 0.0);
    EXPECT_EQ(refusal(flat, 100.0), "the profile does not vary");
    EXPECT_EQ(refusal({{0.0, 1.0}, {0.0, 1.0}}, 1.0), "the profile is too short");
}

}  // namespace
}  // namespace railpem::spectra
