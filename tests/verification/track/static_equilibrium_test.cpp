// The static equilibrium against solutions that share no code with it: the Winkler foundation in closed form, and a
// dense finite- element model on a long free-ended rail with nodes under the wheels.

#include "track/statics/static_equilibrium.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "tests/unit/track/wei2016_track.hpp"

namespace railpem::track {
namespace {

/// Linear pads so close that they are a foundation, without clips and with a negligible rail weight.
TrackParameters dense_linear_track(double spacing_m) {
    TrackParameters track = wei2016_track();
    track.spacing_m = spacing_m;
    track.pads.force_polynomial_n.clear();
    track.pads.preload_strength = 0.0;
    track.pads.static_stiffness_n_per_m = 26.7e6 / 0.6 * spacing_m;
    return track;
}

/// Largest difference from the endless Euler beam on a Winkler foundation (Hetényi 1946, eq. 5):
/// w(x) = Pβ/(2k)·e^{−β|x|}(cos β|x| + sin β|x|), β⁴ = k/(4EI), relative to its maximum.
double winkler_error(double spacing_m) {
    const TrackParameters track = dense_linear_track(spacing_m);
    const double k = 26.7e6 / 0.6, beta = std::pow(k / (4.0 * 2.06e11 * 3.22e-5), 0.25);
    const StaticEquilibrium found =
        static_equilibrium(track, wei2016_wheels_m, 80e3, pad_positions(track, wei2016_wheels_m, 0));
    double largest = 0.0;
    for (std::size_t j = 0; j < found.position_m.size(); ++j) {
        double w = 0.0;
        for (const double wheel : wei2016_wheels_m) {
            const double x = beta * std::abs(found.position_m[j] - wheel);
            w += 80e3 * beta / (2.0 * k) * std::exp(-x) * (std::cos(x) + std::sin(x));
        }
        largest = std::max(largest, std::abs(found.compression_m[j] - found.unloaded_compression_m - w));
    }
    return largest / (80e3 * beta / (2.0 * k));
}

TEST(StaticEquilibrium, WinklerFoundationInClosedForm) {
    const double coarse = winkler_error(0.4), fine = winkler_error(0.1);
    // A point support smears with an error that starts at (β·spacing)⁴: 256 from 0.4 m to 0.1 m; order measured 4.
    EXPECT_LT(fine, 1e-5);
    EXPECT_NEAR(std::log(coarse / fine) / std::log(4.0), 4.0, 0.3);
}

/// Under one load on an endless Timoshenko beam (S = κGA), by Fourier transform:
/// w(0) = (P/π)∫₀^∞ (1 + EIq²/S)/(EIq⁴ + k(1 + EIq²/S)) dq = P·(1/√(k·EI) + 1/S)/(4a),  a² = ½√(k/EI) + k/(4S),
/// with ∫₀^∞ dq/(q⁴ + 2pq² + r²) = π/(2r√(2(r + p))) and r times that for q² in the numerator.
TEST(StaticEquilibrium, TimoshenkoBeamOnWinklerFoundationInClosedForm) {
    TrackParameters track = dense_linear_track(0.1);
    track.rail.beam = Beam::timoshenko;
    const double k = 26.7e6 / 0.6, ei = 2.06e11 * 3.22e-5, shear = 0.4 * 81e9 * 7.7e-3;
    const double a = std::sqrt(0.5 * std::sqrt(k / ei) + 0.25 * k / shear);
    const double r = std::sqrt(k / ei);
    const double expected = 80e3 * (1.0 / (ei * r) + 1.0 / shear) / (4.0 * a);
    const std::vector<double> wheel{0.0};
    const StaticEquilibrium found = static_equilibrium(track, wheel, 80e3, pad_positions(track, wheel, 0));
    double largest = 0.0;
    for (const double s : found.compression_m) largest = std::max(largest, s - found.unloaded_compression_m);
    // Smearing: the load stands on a kink of slope P/(2S) now, so the error starts at (spacing)² instead of the fourth
    // power.
    EXPECT_NEAR(largest / expected, 1.0, 1e-3);
    EXPECT_GT(expected, 1.02 * 80e3 / (4.0 * ei * r * std::sqrt(0.5 * r))) << "shear must matter for this to test it";
}

struct Dense {
    Eigen::VectorXd compression_mm;
    Eigen::VectorXd position_m;
};

/// Newton without safeguard on a dense matrix, units kN and mm for the pads, nodes at pads and mid-bay, free ends.
Dense dense_solution(double second_moment, double half_length_m) {
    const double h = 0.3, ei = 2.06e11 * second_moment;
    const int nodes = 2 * static_cast<int>(std::lround(half_length_m / h)) + 1;
    Eigen::MatrixXd beam = Eigen::MatrixXd::Zero(2 * nodes, 2 * nodes);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * nodes);
    Eigen::Matrix4d hermite;
    hermite << 12, 6 * h, -12, 6 * h, 6 * h, 4 * h * h, -6 * h, 2 * h * h, -12, -6 * h, 12, -6 * h, 6 * h, 2 * h * h,
        -6 * h, 4 * h * h;
    for (int e = 0; e + 1 < nodes; ++e) {
        beam.block<4, 4>(2 * e, 2 * e) += ei / (h * h * h) * hermite;
        load.segment<4>(2 * e) += 60.0 * 9.81 * Eigen::Vector4d(h / 2, h * h / 12, h / 2, -h * h / 12);
    }
    const int middle = nodes / 2;
    for (const double wheel : wei2016_wheels_m) load[2 * (middle + static_cast<int>(std::lround(wheel / h)))] += 80e3;
    std::vector<int> pads;
    for (int n = middle % 2; n < nodes; n += 2) pads.push_back(2 * n);
    for (const int p : pads) load[p] += 20e3;
    Eigen::VectorXd u = Eigen::VectorXd::Zero(2 * nodes);
    for (int n = 0; n < nodes; ++n) u[2 * n] = 1.8e-3;
    for (int i = 0; i < 12; ++i) {
        Eigen::VectorXd rest = load - beam * u;
        Eigen::MatrixXd tangent = beam;
        for (const int p : pads) {
            const double s = 1e3 * u[p];
            rest[p] -= 1e3 * (((0.0401 * s + 0.1228) * s + 3.368) * s * s + 5.021 * s - 0.4518);
            tangent(p, p) += 1e6 * (0.1604 * s * s * s + 0.3684 * s * s + 6.736 * s + 5.021);
        }
        u += tangent.partialPivLu().solve(rest);
    }
    Dense result{Eigen::VectorXd(pads.size()), Eigen::VectorXd(pads.size())};
    for (std::size_t j = 0; j < pads.size(); ++j) {
        result.compression_mm[j] = 1e3 * u[pads[j]];
        const int node = pads[j] / 2;
        result.position_m[j] = h * (node - middle);
    }
    return result;
}

TEST(StaticEquilibrium, DenseFiniteElementsOnALongRail) {
    for (const TrackParameters& track : {wei2016_track(), wei2016_track_as_published()}) {
        const double i = track.statics.second_moment_of_area_m4 > 0.0 ? 5.24e-6 : 3.22e-5;
        const Dense expected = dense_solution(i, 33.0);  // the free ends are felt at the wheels as e^{−23}
        const StaticEquilibrium found =
            static_equilibrium(track, wei2016_wheels_m, 80e3, pad_positions(track, wei2016_wheels_m, 0));
        int compared = 0;
        for (std::size_t j = 0; j < found.position_m.size(); ++j)
            for (Eigen::Index n = 0; n < expected.position_m.size(); ++n)
                if (std::abs(found.position_m[j] - expected.position_m[n]) < 1e-6 &&
                    std::abs(found.position_m[j]) < 14.0) {
                    // Dense elements of 0.3 m: EI/h³·ε·u is 1e-6 N against 26e6 N/m; the ends another 1e-8 at 14 m.
                    EXPECT_NEAR(1e3 * found.compression_m[j] / expected.compression_mm[n], 1.0, 1e-8)
                        << found.position_m[j];
                    ++compared;
                }
        EXPECT_EQ(compared, 47);
    }
}

}  // namespace
}  // namespace railpem::track
