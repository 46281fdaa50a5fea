#pragma once
// Physics that exists in the time-marched world only, for trials in which the diagnosis meets what it does not know.
// Masses per whole car or wheelset and springs per rail side, as everywhere; zero strength: absent.

namespace railpem::simulate {

/// A linkage under the car that resists heave and pitch of the bogies against each other:
/// u = (z_b1 − a·θ_b1) − (z_b2 + a·θ_b2), force k·u + c·u̇ (the arms a reach towards the middle of the car).
struct BogieCoupling {
    double stiffness_n_per_m = 0.0;
    double damping_n_s_per_m = 0.0;
    double arm_m = 1.5;
};

/// A tuned absorber on axles: mass on spring and damper. `wheel` 1 to 4, 0: on every axle.
struct AxleAbsorber {
    double mass_kg = 0.0;  ///< per wheelset
    double frequency_hz = 45.0;
    double damping_ratio = 0.08;
    int wheel = 0;
};

/// Play in the fastening: once a pad carries `at_load_n` beyond its unloaded state it gives by `gap_m` with a tenth of
/// its stiffness only.
struct PadDeadBand {
    double gap_m = 0.0;
    double at_load_n = 20e3;
};

/// Friction in the guidance of the axle boxes that sticks harder than it slides (Stribeck):
/// f = [F + (r − 1)·F·exp(−(u̇/v_s)²)]·tanh(u̇/v_0), F kinetic force per axle box, r = static over kinetic.
struct GuidanceStickSlip {
    double force_n = 0.0;
    double static_to_kinetic = 1.6;
    double stribeck_velocity_m_per_s = 0.01;
};

/// A buffer or gangway that ties the rear end of the car body to the neighbouring car: the neighbour's end is a mass on
/// its own suspension, tied by spring and damper to the body at `position_m` from its centre.
struct BodyCoupling {
    double stiffness_n_per_m = 0.0;
    double damping_n_s_per_m = 0.0;
    double neighbour_mass_kg = 15000.0;
    double neighbour_frequency_hz = 1.3;
    double neighbour_damping_ratio = 0.15;
    double position_m = -11.0;
};

/// Ground under the supports that resonates at a frequency which wanders along the line:
/// each seat's foot yields like a mass on spring and dashpot, f(x) = f·(1 + variation·sin(2πx/length)).
struct WanderingSubgrade {
    double mass_kg = 0.0;  ///< per seat
    double frequency_hz = 35.0;
    double damping_ratio = 0.1;
    double variation = 0.25;
    double length_m = 150.0;
};

/// Bump stops that close beside the secondary springs: f = k·(|u| − gap)·sgn(u) beyond the gap.
struct SecondaryBumpStop {
    double stiffness_n_per_m = 0.0;
    double gap_m = 0.002;
};

struct OnlyHereParameters {
    BogieCoupling bogie_coupling;
    AxleAbsorber axle_absorber;
    PadDeadBand pad_dead_band;
    GuidanceStickSlip guidance_stick_slip;
    BodyCoupling body_coupling;
    WanderingSubgrade wandering_subgrade;
    SecondaryBumpStop secondary_bump_stop;
};

}  // namespace railpem::simulate
