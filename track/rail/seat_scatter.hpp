#pragma once
// One step of Bloch waves along a row of seats: over a bay, and through a seat that differs from the uniform ones.

#include "track/rail/bloch_waves.hpp"

namespace railpem::track {

/// What is behind a place answers backward waves b = q·β with forward ones a = S·β + e, S symmetric.
struct Behind {
    lanes::Complex s11, s12, s22;
    WavePair e;
};

/// The waves over the bays, with what is the same in all of them computed once.
struct BayFactors {
    lanes::Complex first, second, first_first, first_second, second_second;
    explicit BayFactors(const WavePair& factor)
        : first(factor[0]),
          second(factor[1]),
          first_first(first * first),
          first_second(first * second),
          second_second(second * second) {}
};

/// Λ·S·Λ; e stays.
inline void cross_bay_unloaded(const BayFactors& bay, Behind& behind) {
    behind.s11 = behind.s11 * bay.first_first;
    behind.s12 = behind.s12 * bay.first_second;
    behind.s22 = behind.s22 * bay.second_second;
}

inline void cross_bay(const BayFactors& bay, Behind& behind) {
    cross_bay_unloaded(bay, behind);
    behind.e = {behind.e[0] * bay.first, behind.e[1] * bay.second};
}

/// Force of a seat on the rail: strength·β + load, downwards in the sense of β.
struct Scatter {
    WavePair strength;
    lanes::Complex load;
};

/// S − σ·u·uᵀ with u = q + S·1, σ = ΔK/(1 + ΔK·1ᵀu), ΔK = numerator/denominator; e stays, and `load` is σ, to be
/// multiplied by what would move the seat if ΔK did not hold it.
inline Scatter scatter_unloaded(const WavePair& excited, const lanes::Complex& numerator,
                                const lanes::Complex& denominator, Behind& behind, lanes::Complex& u1,
                                lanes::Complex& u2) {
    u1 = excited[0] + behind.s11 + behind.s12;
    u2 = excited[1] + behind.s12 + behind.s22;
    const lanes::Complex sigma = numerator / (numerator * (u1 + u2) + denominator);
    const Scatter seat{{sigma * u1, sigma * u2}, sigma};
    behind.s11 -= seat.strength[0] * u1;
    behind.s12 -= seat.strength[0] * u2;
    behind.s22 -= seat.strength[1] * u2;
    return seat;
}

/// The same with `moving` = 1ᵀe plus whatever else moves the rail there.
inline Scatter scatter(const WavePair& excited, const lanes::Complex& numerator, const lanes::Complex& denominator,
                       const lanes::Complex& moving, Behind& behind) {
    lanes::Complex u1, u2;
    Scatter seat = scatter_unloaded(excited, numerator, denominator, behind, u1, u2);
    seat.load = seat.load * moving;
    behind.e[0] -= u1 * seat.load;
    behind.e[1] -= u2 * seat.load;
    return seat;
}

}  // namespace railpem::track
