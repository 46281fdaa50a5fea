#include "pem/distortion/pad_distortion.hpp"
#include "pem/coupling/excite.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/pem/paper_case.hpp"

namespace railpem::pem {
namespace {

constexpr double kFastSpeed = 33.0;

CaseParameters loaded(double strength) {
    CaseParameters c = tests::paper_case(1);
    c.track.pads.preload_strength = strength;
    c.solver.moving = true;
    return c;
}

std::vector<DelayedSpectrum> distortion_of(const CaseParameters& c) {
    const std::vector<double> wheels = vehicle::wheel_positions(c.vehicle);
    return pad_distortion(pad_transfers(c, coupled_model(c, kFastSpeed)), excitation(c, wheels, kFastSpeed).broadband,
                          wheels, kFastSpeed);
}

TEST(PadDistortion, NoneWhereLoadDoesNotMatter) {
    EXPECT_TRUE(distortion_of(loaded(0.0)).empty());
}

// A square: 10 dB more irregularity make 20 dB more distortion.
TEST(PadDistortion, IsOfSecondOrder) {
    CaseParameters c = loaded(1.0);
    const DelayedSpectrum plain = distortion_of(c).front();
    c.irregularity.level_db += 10.0;
    const DelayedSpectrum rougher = distortion_of(c).front();
    for (const double f : {5.0, 30.0, 65.0, 120.0}) {
        EXPECT_GT(plain.psd_m2_per_hz(f), 0.0);
        EXPECT_NEAR(rougher.psd_m2_per_hz(f) / plain.psd_m2_per_hz(f), 100.0, 1e-6) << f;
    }
}

// Linear in the strength of the law while that is small: so is the curvature, and the spectrum goes with its square.
TEST(PadDistortion, GrowsWithTheStrength) {
    const double weak = distortion_of(loaded(0.01)).front().psd_m2_per_hz(65.0),
                 twice = distortion_of(loaded(0.02)).front().psd_m2_per_hz(65.0);
    EXPECT_NEAR(twice / weak, 4.0, 0.1);
}

}  // namespace
}  // namespace railpem::pem
