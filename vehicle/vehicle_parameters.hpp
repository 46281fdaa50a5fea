#pragma once
// The car as data: whole-vehicle masses and inertias, suspension elements per rail side (CONVENTIONS.md).

#include <limits>
#include <vector>

#include "parameters/field.hpp"

namespace railpem::vehicle {

/// One suspension element (per axle box or per bogie and rail side).
/// Force law: spring k in parallel with a damper c that may act through a series spring k_s (Maxwell element) and with
/// dry friction of amplitude F: f = k·u + maxwell(c, k_s)(u̇) + F·sgn(u̇).
struct SuspensionParameters {
    double stiffness_n_per_m = 0.0;
    double damping_n_s_per_m = 0.0;
    /// Stiffness in series with the damper; infinity: the damper is mounted rigidly (Bruni et al. 2011).
    double damper_series_stiffness_n_per_m = std::numeric_limits<double>::infinity();
    double friction_force_n = 0.0;
};

/// First free–free bending mode of the car body. Displacement of the body at x: heave + x·pitch + φ(x)·q with
/// φ(0) = 1 and φ(± half the bogie distance) = shape_at_pivots; between them φ(x) = 1 + (shape_at_pivots − 1)·(x/b)².
/// Frequency and mass are of the empty car: a payload adds to the mode's mass as it adds to the body's, by the same
/// factor.
struct BodyBendingMode {
    double frequency_hz = 10.0;
    double damping_ratio = 0.015;
    double modal_mass_kg = 9000.0;  ///< of the whole body, for φ(0) = 1; halved like every mass
    double shape_at_pivots = -0.35;
};

/// Bending of the axle as one extra mode on every wheel: the wheel (contact, axle box, primary suspension) moves by
/// rigid displacement + q.
struct WheelsetBendingMode {
    double frequency_hz = 80.0;  ///< of the free wheelset
    double damping_ratio = 0.01;
    double modal_mass_kg = 600.0;  ///< of the whole wheelset for unit displacement at the wheels; halved
};

/// A mass hung elastically on each bogie frame, in addition to the bogie's own mass.
struct BogieMountedMass {
    double mass_kg = 400.0;      ///< per bogie; halved
    double frequency_hz = 20.0;  ///< of the mass on the fixed frame
    double damping_ratio = 0.1;
    double position_m = 0.0;  ///< from the bogie centre, positive towards the front
};

struct VehicleParameters {
    double body_mass_kg = 0.0;
    double body_pitch_inertia_kg_m2 = 0.0;
    double bogie_mass_kg = 0.0;
    double bogie_pitch_inertia_kg_m2 = 0.0;
    double wheelset_mass_kg = 0.0;
    double bogie_distance_m = 0.0;  ///< between the bogie centres
    double wheelbase_m = 0.0;       ///< of a bogie
    double wheel_radius_m = 0.42;
    /// Extra mass in the car body (whole car), spread like the body's own: the pitch inertia grows in proportion.
    double payload_kg = 0.0;
    SuspensionParameters primary;
    SuspensionParameters secondary;
    std::vector<BodyBendingMode> body_bending;           ///< at most one
    std::vector<WheelsetBendingMode> wheelset_bending;   ///< at most one, the same on every wheelset
    std::vector<BogieMountedMass> bogie_mounted_masses;  ///< each hangs on both bogies
};

/// Longitudinal positions of wheels 1…4 from the centre of the body, m, front first.
std::vector<double> wheel_positions(const VehicleParameters& vehicle);

parameters::Fields<VehicleParameters> vehicle_fields();
parameters::Fields<SuspensionParameters> suspension_fields();
parameters::Fields<BodyBendingMode> body_bending_fields();
parameters::Fields<WheelsetBendingMode> wheelset_bending_fields();
parameters::Fields<BogieMountedMass> bogie_mounted_mass_fields();

/// Rules between parameters. Throws parameters::ParameterError (keys begin with "vehicle.").
void check(const VehicleParameters& vehicle);

}  // namespace railpem::vehicle
