#include "track/pads/fit_power_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "track/pads/pad_law.hpp"

namespace railpem::track {
namespace {

const std::vector<double> kFrequencies = {1.0, 3.0, 4.0, 11.0, 50.0, 170.0, 900.0};

/// Points made with the pad's own law give its parameters back, without error.
TEST(FitPowerLaw, RecoversASpringPot) {
    PadParameters pads;
    pads.exponent = 0.17;
    pads.causal = true;
    pads.reference_frequency_hz = 4.0;
    std::vector<double> storage, loss;
    for (const double f : kFrequencies) {
        const std::complex<double> modulus = 80.0 * pad_shape(pads, f);
        storage.push_back(modulus.real());
        loss.push_back(modulus.imag() / modulus.real());
    }
    const PowerLawFit fit = fit_power_law(kFrequencies, storage, loss, 4.0);
    EXPECT_NEAR(fit.exponent, 0.17, 1e-14);
    EXPECT_NEAR(fit.storage_at_reference, 80.0, 1e-12);
    EXPECT_LT(fit.rms_error_db, 1e-13);
    EXPECT_LT(fit.largest_error_db, 1e-12);
    EXPECT_LT(fit.rms_loss_factor_error, 1e-14);
}

/// A modulus that does not depend on frequency but dissipates is no spring-pot: the fit says by how much. Two points at
/// f_ref·e^{±1}: x̄ = 0, Σx² = 2, so k = (π/2)·2φ/(2 + 2(π/2)²), and the errors of |E| are ∓k in nepers.
TEST(FitPowerLaw, SaysHowFarOffALossWithoutStiffeningIs) {
    const double half = 0.5 * std::numbers::pi, eta = 0.2;
    const PowerLawFit fit =
        fit_power_law({4.0 / std::numbers::e, 4.0 * std::numbers::e}, {10.0, 10.0}, {eta, eta}, 4.0);
    const double k = half * std::atan(eta) / (1.0 + half * half);
    EXPECT_NEAR(fit.exponent, k, 1e-14);
    EXPECT_NEAR(fit.rms_error_db, 20.0 / std::numbers::ln10 * k, 1e-12);
    EXPECT_NEAR(fit.largest_error_db, 20.0 / std::numbers::ln10 * k, 1e-12);
    EXPECT_NEAR(fit.rms_loss_factor_error, eta - std::tan(half * k), 1e-14);
}

}  // namespace
}  // namespace railpem::track
