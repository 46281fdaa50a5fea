#include "simulate/track/footing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace railpem::simulate {
namespace {

constexpr double kWay_m = 33.0 * 2e-4;
constexpr double kNode_m = 0.6;

/// Ten elements of 0.15 m.
TrackWindow window(bool shears) {
    track::RailParameters rail{
        .youngs_modulus_pa = 2.06e11, .second_moment_of_area_m4 = 3.22e-5, .mass_kg_per_m = 60.64};
    if (shears) rail.beam = track::Beam::timoshenko;
    TrackWindow track;
    track.section = section_of(rail);
    track.element_m = 0.15, track.spacing_m = 0.6;
    track.w.resize(11);
    return track;
}

/// A load that is at `place` at the end of its step.
Footing footing_at(const TrackWindow& track, double place_m) {
    return footing(track, {.position_m = {place_m - (1.0 - RadauStep::first_stage) * kWay_m, place_m}, .force_n = {}},
                   1);
}

/// Where the parts of the load are, and their mean.
double mean_place(const TrackWindow& track, const Footing& footing) {
    double mean = 0.0;
    for (std::size_t i = 0; i < footing.count; ++i) {
        // The first and third shape function of an element are displacements of its nodes; of a straight rail they say
        // the place.
        Eigen::Vector4d straight;
        const double left = static_cast<double>(footing.parts[i].at.node) * track.element_m;
        straight << left, 1.0, left + track.element_m, 1.0;
        mean += footing.parts[i].share * footing.parts[i].at.shape.dot(straight);
    }
    return mean;
}

TEST(Footing, IsAPointWhereNothingIsPassed) {
    EXPECT_EQ(footing_at(window(false), kNode_m).count, 1U) << "no kink without shear";
    EXPECT_EQ(footing_at(window(true), kNode_m + 0.51 * kWay_m).count, 1U);
    EXPECT_EQ(footing_at(window(true), kNode_m + 0.49 * kWay_m).count, 2U);
}

TEST(Footing, SpreadKeepsForceAndMoment) {
    const TrackWindow track = window(true);
    for (const double part : {-0.49, -0.3, 0.0, 0.1, 0.45}) {
        const Footing own = footing_at(track, kNode_m + part * kWay_m);
        EXPECT_NEAR(own.parts[0].share + own.parts[1].share, 1.0, 1e-12);
        EXPECT_NEAR(mean_place(track, own), kNode_m + part * kWay_m, 1e-12);
    }
}

// Between nodes that do not move a string of the rail's shear stiffness: c(x, x') = (min(x, x') − x·x'/l')/κGA,
// averaged over both places of the load. Bending adds some 1e-3 of that.
TEST(Footing, GivesWayAsTheLoadThatIsSpread) {
    const TrackWindow track = window(true);
    const double flexibility = track.section.shear_flexibility_per_n, l = track.element_m;
    const auto mean = [&](double length) {
        constexpr int n = 400;
        double sum = 0.0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double a = length * (i + 0.5) / n, b = length * (j + 0.5) / n;
                sum += (std::min(a, b) - a * b / l) * flexibility;
            }
        return sum / n / n;
    };
    for (const double part : {-0.3, 0.0, 0.2}) {
        const double before = (0.5 - part) * kWay_m, behind = kWay_m - before, share = before / kWay_m;
        const double expected =
            share * share * mean(before) + (1.0 - share) * (1.0 - share) * mean(behind) + flexibility * kWay_m / 6.0;
        EXPECT_NEAR(footing_at(track, kNode_m + part * kWay_m).local_compliance_m_per_n, expected, 3e-3 * expected)
            << part;
    }
}

// Where the spread begins its compliance goes on from that of a point, to the second order of the way.
TEST(Footing, BeginsWithoutAStep) {
    const TrackWindow track = window(true);
    const double point = footing_at(track, kNode_m + 0.5001 * kWay_m).local_compliance_m_per_n,
                 spread = footing_at(track, kNode_m + 0.4999 * kWay_m).local_compliance_m_per_n;
    EXPECT_NEAR(spread, point, 0.05 * point);
}

}  // namespace
}  // namespace railpem::simulate
