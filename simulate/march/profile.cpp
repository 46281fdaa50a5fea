#include "simulate/march/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "parameters/parameter_error.hpp"
#include "simulate/numerics/random_numbers.hpp"
#include "spectra/irregularity_spectrum.hpp"

namespace railpem::simulate {

namespace {

using std::numbers::pi;
using Spectrum = std::vector<std::complex<double>>;

/// Points per shortest wave: cubic interpolation is then right to 1e-3 there, and to 1e-5 at four times its length.
constexpr double points_per_wave = 12.0;

std::size_t power_of_two_above(double value) {
    std::size_t n = 64;
    while (static_cast<double>(n) < value) n *= 2;
    return n;
}

/// Moving average over 2a seen as a factor on the wave of n cycles/m: sin(2πna)/(2πna).
double patch_factor(double half_length, double cycles_per_m) {
    const double argument = 2.0 * pi * cycles_per_m * half_length;
    return argument < 1e-9 ? 1.0 : std::sin(argument) / argument;
}

/// `share`: of the spectrum's power at n cycles/m.
template <typename Share>
void add_gaussian(Spectrum& amplitude, const spectra::IrregularityParameters& irregularity,
                  const ProfileRequest& request, double length, std::uint64_t seed, const Share& share) {
    const double highest = 1.0 / request.shortest_wavelength_m;
    for (std::size_t k = 1; k + 1 < amplitude.size(); ++k) {
        const double n = static_cast<double>(k) / length;
        if (n > highest) break;
        const auto [a, b] = normal_pair_at(seed, k);
        // E|c|² = S/(2·length) for h = Σ 2·Re(c·e^{i2πnx}), so that the one-sided spectrum is S.
        amplitude[k] += std::sqrt(share(n) * spectra::irregularity_psd_m3(irregularity, n) / (4.0 * length)) *
                        std::complex<double>(a, b);
    }
}

/// Raised-cosine dips at a regular distance, from one end of the line to the other; only where the periodic profile
/// closes, beyond both ends, is one distance another. (Rounded to a whole number per period, 12 m were 12.01 m, and
/// another distance at every speed.)
void add_joints(Spectrum& amplitude, const spectra::RailJoints& joints, const ProfileRequest& request, double length,
                std::size_t points) {
    const double step = length / static_cast<double>(points), half = 0.5 * joints.length_m;
    const double phase = uniform_at(derived_seed(request.seed, 71), 0) * joints.spacing_m;
    std::vector<double> height(points, 0.0);
    for (double order = std::ceil((request.from_m - phase) / joints.spacing_m);; ++order) {
        const double middle = phase + order * joints.spacing_m;
        if (middle >= request.from_m + length) break;
        for (auto i = static_cast<std::ptrdiff_t>(std::ceil((middle - half) / step));
             static_cast<double>(i) * step < middle + half; ++i) {
            const auto wrapped = static_cast<std::size_t>(
                (i % static_cast<std::ptrdiff_t>(points) + static_cast<std::ptrdiff_t>(points)) %
                static_cast<std::ptrdiff_t>(points));
            height[wrapped] -=
                0.5 * joints.depth_m * (1.0 + std::cos(pi * (static_cast<double>(i) * step - middle) / half));
        }
    }
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    Spectrum own(amplitude.size());
    transform.fwd(own, height);
    for (std::size_t k = 1;
         k + 1 < amplitude.size() && static_cast<double>(k) / length <= 1.0 / request.shortest_wavelength_m; ++k)
        amplitude[k] += own[k] / static_cast<double>(points);
}

Profile synthesise(Spectrum& amplitude, double length, std::size_t points, const ProfileRequest& request) {
    for (std::size_t k = 0; k < amplitude.size(); ++k)
        amplitude[k] *=
            patch_factor(request.patch_half_length_m, static_cast<double>(k) / length) * static_cast<double>(points);
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    Profile profile{.first_m = 0.0,
                    .step_m = length / static_cast<double>(points),
                    .height_m = std::vector<double>(points),
                    .periodic = true};
    transform.inv(profile.height_m, amplitude, static_cast<Eigen::Index>(points));
    return profile;
}

}  // namespace

double OwnShare::at(double cycles_per_m) const {
    return at_1_m > 0.0 ? std::min(1.0, at_1_m * std::pow(cycles_per_m, exponent)) : 0.0;
}

double Profile::at(double position_m) const {
    const auto count = static_cast<std::ptrdiff_t>(height_m.size());
    const double place = (position_m - first_m) / step_m;
    const double floor = std::floor(place);
    const double t = place - floor;
    const auto value = [&](std::ptrdiff_t i) {
        if (periodic) i = ((i % count) + count) % count;
        return height_m[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, count - 1))];
    };
    const auto i = static_cast<std::ptrdiff_t>(floor);
    // Cubic through the four neighbours (Lagrange).
    return value(i - 1) * (-t * (t - 1.0) * (t - 2.0) / 6.0) + value(i) * ((t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0) +
           value(i + 1) * (-(t + 1.0) * t * (t - 2.0) / 2.0) + value(i + 2) * ((t + 1.0) * t * (t - 1.0) / 6.0);
}

Profile draw_profile(const spectra::IrregularityParameters& irregularity, const ProfileRequest& request) {
    const double stretch = request.to_m - request.from_m;
    if (request.length_m > 0.0 && request.length_m < stretch && !request.may_repeat)
        throw parameters::ParameterError(
            "--profile-length",
            fmt::format("{:g} m of profile for {:g} m of line: it would repeat", request.length_m, stretch),
            fmt::format("at least {:g} m", stretch));
    const double length = request.length_m > 0.0 ? request.length_m : stretch;
    const std::size_t points = power_of_two_above(points_per_wave * length / request.shortest_wavelength_m);
    Spectrum amplitude(points / 2 + 1);
    add_gaussian(amplitude, irregularity, request, length, request.seed,
                 [&](double n) { return 1.0 - request.own.at(n); });
    for (const spectra::RailJoints& joints : irregularity.joints)
        add_joints(amplitude, joints, request, length, points);
    return synthesise(amplitude, length, points, request);
}

Profile resample_profile(const MeasuredProfile& measured, const ProfileRequest& request) {
    if (measured.position_m.size() < 2 || measured.position_m.front() > request.from_m ||
        measured.position_m.back() < request.to_m)
        throw parameters::ParameterError(
            "--profile",
            fmt::format("the measured profile does not cover {:g} to {:g} m", request.from_m, request.to_m),
            "a longer profile or a shorter record");
    const double length = request.to_m - request.from_m;
    const std::size_t points = power_of_two_above(points_per_wave * length / request.shortest_wavelength_m);
    Profile profile{.first_m = request.from_m,
                    .step_m = length / static_cast<double>(points - 1),
                    .height_m = std::vector<double>(points),
                    .periodic = false};
    const std::vector<double>& x = measured.position_m;
    const auto height = [&](double at) {
        const auto above = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
            std::upper_bound(x.begin(), x.end(), at) - x.begin(), 1, static_cast<std::ptrdiff_t>(x.size()) - 1));
        const double share = std::clamp((at - x[above - 1]) / (x[above] - x[above - 1]), 0.0, 1.0);
        return measured.height_m[above - 1] + share * (measured.height_m[above] - measured.height_m[above - 1]);
    };
    const double half = std::max(request.patch_half_length_m, 0.25 * profile.step_m);
    for (std::size_t i = 0; i < points; ++i) {
        const double at = profile.first_m + profile.step_m * static_cast<double>(i);
        constexpr int samples = 9;  // midpoint rule over the patch
        double sum = 0.0;
        for (int j = 0; j < samples; ++j) sum += height(at + half * ((2.0 * j + 1.0) / samples - 1.0));
        profile.height_m[i] = sum / samples;
    }
    return profile;
}

void add_own_profile(Profile& profile, const spectra::IrregularityParameters& irregularity,
                     const ProfileRequest& request, std::size_t wheel) {
    const std::size_t points = profile.height_m.size();
    const double length = profile.step_m * static_cast<double>(points);
    constexpr std::uint64_t for_wheel = 331;  // purpose of derived seeds, one per wheel
    Spectrum amplitude(points / 2 + 1);
    add_gaussian(amplitude, irregularity, request, length, derived_seed(request.seed, for_wheel + wheel),
                 [&](double n) { return request.own.at(n); });
    const Profile own = synthesise(amplitude, length, points, request);
    for (std::size_t i = 0; i < points; ++i) profile.height_m[i] += own.height_m[i];
}

double profile_rms(const Profile& profile, double from_m, double to_m) {
    const auto count = static_cast<std::size_t>(std::max(1.0, (to_m - from_m) / profile.step_m));
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double h = profile.at(from_m + profile.step_m * static_cast<double>(i));
        sum += h;
        squares += h * h;
    }
    const double mean = sum / static_cast<double>(count);
    return std::sqrt(std::max(0.0, squares / static_cast<double>(count) - mean * mean));
}

}  // namespace railpem::simulate
