#include "track/pads/seat_law.hpp"

#include <algorithm>
#include <cmath>

#include "track/pads/support_law.hpp"

namespace railpem::track {

SeatLaw seat_law(const TrackParameters& track) {
    return {pad_curve(track.pads), track.statics.clip_preload_n, static_support_compliance(track.support)};
}

SeatState seat_state(const SeatLaw& seat, double scale, double displacement_m) {
    const double compliance = scale * seat.support_compliance_m_per_n;
    double s = displacement_m;
    if (compliance > 0.0) {
        // g(S) = S + a·ρ·(F − F_c) − u rises with at least slope 1, so the root lies within |g| of S: a bracket for
        // Newton.
        const auto excess = [&](double x) {
            return x + compliance * (pad_force(seat.curve, x) - seat.clip_preload_n) - displacement_m;
        };
        double g = excess(s);
        double low = s - std::max(g, 0.0), high = s + std::max(-g, 0.0);
        for (int i = 0; i < 200 && high - low > 1e-15 * std::abs(s); ++i) {
            const double newton = s - g / (1.0 + compliance * pad_stiffness(seat.curve, s));
            if (newton == s) break;
            s = newton > low && newton < high ? newton : 0.5 * (low + high);
            g = excess(s);
            (g > 0.0 ? high : low) = s;
        }
    }
    const double stiffness = scale * pad_stiffness(seat.curve, s);
    return {displacement_m, s, scale * (pad_force(seat.curve, s) - seat.clip_preload_n),
            stiffness / (1.0 + stiffness * seat.support_compliance_m_per_n)};
}

SeatState unloaded_seat(const SeatLaw& seat, double rest_load_n) {
    const double s = pad_compression(seat.curve, seat.clip_preload_n + rest_load_n);
    return seat_state(seat, 1.0, s + seat.support_compliance_m_per_n * rest_load_n);
}

double rest_load_n(const TrackParameters& track) {
    const double mass =
        track.statics.rail_weight_kg_per_m > 0.0 ? track.statics.rail_weight_kg_per_m : track.rail.mass_kg_per_m;
    return mass * track.statics.gravity_m_per_s2 * track.spacing_m;
}

double static_bending_stiffness(const TrackParameters& track) {
    const double i = track.statics.second_moment_of_area_m4;
    return track.rail.youngs_modulus_pa * (i > 0.0 ? i : track.rail.second_moment_of_area_m4);
}

}  // namespace railpem::track
