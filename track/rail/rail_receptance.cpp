// The hot path: one group of frequency lines of the exact rail.

#include "track/rail/exact_rail.hpp"

namespace railpem::track {

using lanes::Complex;
using lanes::Matrix2;
using lanes::Real;
using lanes::Vector2;

namespace {

/// Loss added where only loss can tell an outgoing wave from an incoming one.
constexpr double kProbeLoss = 1e-6;

Bay lossier(const ExactRail& rail, Real omega, const Complex& support) {
    RailParameters lossy = rail.rail;
    lossy.loss_factor += kProbeLoss;
    const Complex factor(std::complex<double>(1.0, kProbeLoss));
    return {rail_element(beam_coefficients(lossy, rail.dampers, omega, rail.modifiers.rail), rail.spacing_m),
            support * factor};
}

/// d = −(behind + near)⁻¹·far·d_next and what the next node then feels.
struct Elimination {
    Matrix2 inverted, back, behind_next;
};

Elimination eliminate(const Matrix2& behind, const RailElement& stretch) {
    Elimination step;
    step.inverted = lanes::inverse(behind + stretch.near);
    const Matrix2 minus_back = step.inverted * stretch.far;
    step.back = Matrix2{} - minus_back;
    step.behind_next = mirrored(stretch.near) - transpose(stretch.far) * minus_back;
    return step;
}

/// What the uniform end adds to a node when every pad, out to infinity, is loaded with its own stiffness: displacement
/// w of the uniform state, and the force that the end then exerts.
Vector2 end_load(const RailElement& bay, const Complex& support, const Matrix2& stiffness, bool towards_front) {
    const Complex uniform = support / ((bay.near.a + bay.far.a) * 2.0 + support);
    const Complex force = (stiffness.a - bay.near.a - bay.far.a) * uniform;
    const Complex moment = (stiffness.c - bay.near.c - bay.far.c) * uniform;
    return {force, towards_front ? moment : -moment};
}

/// Receptances by selected inversion: the inverse's diagonal blocks from the front, products of `back` between the
/// points.
void collect(const ExactRail& rail, const Matrix2& front, const Vector2& front_load, ExactRailWorkspace& work) {
    RailReceptance& result = work.result;
    const int last = static_cast<int>(rail.nodes.size()) - 1;
    const std::size_t points = static_cast<std::size_t>(rail.points);
    Matrix2 diagonal = front;              // block (j, j) of the inverse
    Vector2 pad_sum = front * front_load;  // displacement in the pad-sum problem
    // Points met so far and the first row of Π back · (block (k, k) of the inverse), k the point's node.
    std::vector<int>& met = work.met;
    std::vector<Vector2>& row = work.row;
    std::size_t count = 0;
    for (int j = last; j >= 0; --j) {
        if (j < last) {
            const Matrix2& g = work.back[j];
            diagonal = work.condensed[j] + g * diagonal * transpose(g);
            pad_sum = work.load[j] + g * pad_sum;
            for (std::size_t k = 0; k < count; ++k) row[k] = g * row[k];
        }
        const int point = rail.nodes[j].point;
        if (point < 0) continue;
        met[count] = point;
        row[count] = {diagonal.a, diagonal.c};
        ++count;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t a = static_cast<std::size_t>(met[k]), b = static_cast<std::size_t>(point);
            result.between[a * points + b] = result.between[b * points + a] = row[k].a;
        }
        result.trackbed[static_cast<std::size_t>(point)] = pad_sum.a;
    }
}

}  // namespace

const RailReceptance& rail_receptance(const ExactRail& rail, Real omega, ExactRailWorkspace& work) {
    const BeamCoefficients beam = beam_coefficients(rail.rail, rail.dampers, omega, rail.modifiers.rail);
    for (std::size_t i = 0; i < rail.lengths_m.size(); ++i) work.elements[i] = rail_element(beam, rail.lengths_m[i]);
    const SupportLaw law(rail.pads, rail.support, omega, rail.modifiers);
    for (std::size_t j = 0; j < rail.nodes.size(); ++j)
        work.supports[j] = rail.nodes[j].supported
                               ? law.stiffness(rail.nodes[j].pad_stiffness_n_per_m, rail.nodes[j].pad_scale)
                               : Complex{};

    const Complex uniform = law.stiffness(rail.uniform_pad_stiffness_n_per_m);
    const HalfTrack ahead = uniform_half_track(rail, omega, work.elements[0], uniform);
    const std::size_t last = rail.nodes.size() - 1;

    Matrix2 behind = mirrored(ahead.stiffness);
    Vector2 load = end_load(work.elements[0], uniform, ahead.stiffness, false);
    for (std::size_t j = 0; j < last; ++j) {
        behind.a += work.supports[j];
        load.a += work.supports[j];
        const RailElement& stretch = work.elements[static_cast<std::size_t>(rail.nodes[j].stretch)];
        const Elimination step = eliminate(behind, stretch);
        work.condensed[j] = step.inverted;
        work.back[j] = step.back;
        work.load[j] = step.inverted * load;
        load = transpose(step.back) * load;
        behind = step.behind_next;
    }
    const Vector2 end = end_load(work.elements[0], uniform, ahead.stiffness, true);
    load = load + end;
    load.a += work.supports[last];
    behind.a += work.supports[last];
    collect(rail, lanes::inverse(behind + ahead.stiffness), load, work);
    return work.result;
}

HalfTrack uniform_half_track(const ExactRail& rail, Real omega, const RailElement& bay, const Complex& support) {
    return half_track(bay, support, [&] { return lossier(rail, omega, support); });
}

HalfTrack uniform_half_track(const ExactRail& rail, Real omega) {
    const RailElement bay =
        rail_element(beam_coefficients(rail.rail, rail.dampers, omega, rail.modifiers.rail), rail.spacing_m);
    const Complex support =
        SupportLaw(rail.pads, rail.support, omega, rail.modifiers).stiffness(rail.uniform_pad_stiffness_n_per_m);
    return uniform_half_track(rail, omega, bay, support);
}

}  // namespace railpem::track
