#include "simulate/track/seat_row.hpp"

#include <cmath>

namespace railpem::simulate {

SeatStep seat_step(const SeatLaw& law, const RadauStep& step) {
    SeatStep numbers;
    numbers.modulus = law.chain.modulus(step.s);
    for (std::size_t b = 0; b < law.chain.strength.size(); ++b) {
        const Complex st = step.s * law.chain.time_s[b];
        numbers.branch_weight.push_back(law.chain.strength[b] * st / (1.0 + st) * step.one);
        numbers.branch_old.push_back(st / (1.0 + st) * step.one);
        numbers.branch_new.push_back(1.0 / (1.0 + st));
    }
    return numbers;
}

Seat fresh_seat(const SeatLaw& law) {
    Seat seat;
    seat.reference_stiffness_n_per_m = law.reference_stiffness_n_per_m;
    seat.branch_force_n.assign(law.chain.strength.size(), 0.0);
    seat.oscillators.resize(law.oscillators.size());
    seat.oscillator_scale.assign(law.oscillators.size(), 1.0);
    seat.oscillator_receptance.resize(law.oscillators.size());
    seat.oscillator_history.resize(law.oscillators.size());
    return seat;
}

void set_stiffness(Seat& seat, const SeatLaw& law, const SeatStep& numbers, const RadauStep& step) {
    const Complex pad = seat.share * (numbers.modulus * seat.reference_stiffness_n_per_m +
                                      seat.dashpot_scale * law.dashpot_n_s_per_m * step.s);
    Complex foot = 0.0;  // receptance of the foot
    for (std::size_t r = 0; r < law.oscillators.size(); ++r) {
        const Oscillator& o = law.oscillators[r];
        seat.oscillator_receptance[r] = 1.0 / (o.mass_kg * step.s * step.s + o.damping_n_s_per_m * step.s +
                                               o.stiffness_n_per_m * seat.oscillator_scale[r]);
        foot += seat.oscillator_receptance[r];
    }
    seat.softening = 1.0 / (1.0 + pad * foot);
    seat.condensed_stiffness = pad * seat.softening;
    seat.residual_gain = seat.share * numbers.modulus * seat.softening;
}

void begin_step(Seat& seat, const SeatLaw& law, const SeatStep& numbers, const RadauStep& step) {
    // Pad: −c·s·1̂·x − Σ strength·sτ/(1 + sτ)·1̂·h; oscillators: 1̂·s·[m(s·y + ẏ) + c·y].
    Complex pad = -product(seat.dashpot_scale * law.dashpot_n_s_per_m * seat.compression_m * step.s, step.one);
    for (std::size_t b = 0; b < seat.branch_force_n.size(); ++b)
        pad -= numbers.branch_weight[b] * seat.branch_force_n[b];
    Complex foot = 0.0;
    const Complex scale = product(step.one, step.s);
    for (std::size_t r = 0; r < law.oscillators.size(); ++r) {
        const Oscillator& o = law.oscillators[r];
        const Motion& y = seat.oscillators[r];
        const Complex momentum = step.s * (o.mass_kg * y.displacement_m) +
                                 (o.mass_kg * y.velocity_m_per_s + o.damping_n_s_per_m * y.displacement_m);
        seat.oscillator_history[r] = product(scale, momentum);
        foot += product(seat.oscillator_history[r], seat.oscillator_receptance[r]);
    }
    // Elimination of the foot: F·(1 + K_pad·Σ1/D) = K_pad·(Σ history/D − rail) + pad + g·residual.
    seat.constant_force = product(seat.condensed_stiffness, foot) + product(seat.share * pad, seat.softening);
}

double respond(Seat& seat, const SeatLaw& law, const RadauStep& step, Complex rail) {
    seat.force = applied_force(seat) - product(seat.condensed_stiffness, rail);
    Complex foot = 0.0;
    for (std::size_t r = 0; r < law.oscillators.size(); ++r)
        foot += product(seat.oscillator_history[r] - seat.force, seat.oscillator_receptance[r]);
    seat.compression = foot - rail;
    if (!law.nonlinear) return 0.0;
    const double x1 = step.at_first(seat.compression);
    const double x2 = RadauStep::at_end(seat.compression);
    const double origin = law.curve.force(seat.origin_m);
    const double e1 = law.curve.force(seat.origin_m + x1) - origin - seat.reference_stiffness_n_per_m * x1;
    const double e2 = law.curve.force(seat.origin_m + x2) - origin - seat.reference_stiffness_n_per_m * x2;
    const Complex residual = step.transform(e1, e2);
    const Complex change = residual - seat.residual;
    seat.residual = residual;
    return std::abs(change.real()) + std::abs(change.imag());
}

void finish_step(Seat& seat, const SeatLaw& law, const SeatStep& numbers, const RadauStep& step) {
    const Complex elastic = seat.reference_stiffness_n_per_m * seat.compression + seat.residual;
    for (std::size_t b = 0; b < seat.branch_force_n.size(); ++b)
        seat.branch_force_n[b] =
            RadauStep::at_end(numbers.branch_old[b] * seat.branch_force_n[b] + product(numbers.branch_new[b], elastic));
    for (std::size_t r = 0; r < law.oscillators.size(); ++r) {
        const Complex y = product(seat.oscillator_history[r] - seat.force, seat.oscillator_receptance[r]);
        const Complex velocity = step.derivative(y, seat.oscillators[r].displacement_m);
        seat.oscillators[r] = {RadauStep::at_end(y), RadauStep::at_end(velocity)};
    }
    seat.compression_m = RadauStep::at_end(seat.compression);
}

}  // namespace railpem::simulate
