#pragma once
// The static law of a whole seat: pad, clip and support between rail and ground.

#include "track/pads/pad_curve.hpp"
#include "track/track_parameters.hpp"

namespace railpem::track {

/// Everything static of one seat. With u the downward displacement of the rail, S the compression of the pad, F_c the
/// clip preload, ρ the share that a failed fastener still has and a the compliance of the support,
///   r = ρ·(F(S) − F_c)    force of the seat on the rail, upwards
///   u = S + a·r           the support feels r only, for the clip acts between rail and sleeper
/// u counts from the rail resting freely on the pads of an unloaded support.
struct SeatLaw {
    PadCurve curve;
    double clip_preload_n = 0.0;
    double support_compliance_m_per_n = 0.0;
};

struct SeatState {
    double displacement_m = 0.0;   ///< u
    double compression_m = 0.0;    ///< S
    double force_on_rail_n = 0.0;  ///< r
    double tangent_n_per_m = 0.0;  ///< dr/du
};

/// Throws parameters::ParameterError when the curve of the pad is no static law, see pad_curve().
SeatLaw seat_law(const TrackParameters& track);

/// The seat under a rail displaced by u; `scale` is ρ.
SeatState seat_state(const SeatLaw& seat, double scale, double displacement_m);

/// An intact seat that carries `rest_load_n` (> −clip preload) of rail.
SeatState unloaded_seat(const SeatLaw& seat, double rest_load_n);

/// Weight of the rail on one seat, N.
double rest_load_n(const TrackParameters& track);

/// EI of the static analysis, N·m²: with the second moment of area that the static parameters may put in place of the
/// rail's.
double static_bending_stiffness(const TrackParameters& track);

}  // namespace railpem::track
