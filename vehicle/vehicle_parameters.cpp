#include "vehicle/vehicle_parameters.hpp"

#include "parameters/parameter_error.hpp"

namespace railpem::vehicle {

using namespace parameters;

namespace {
constexpr const char* kTolerances = "default tolerance: masses 5 %, suspension 10 to 15 %";
}

std::vector<double> wheel_positions(const VehicleParameters& vehicle) {
    const double b = vehicle.bogie_distance_m / 2.0;
    const double w = vehicle.wheelbase_m / 2.0;
    return {b + w, b - w, -b + w, -b - w};
}

Fields<VehicleParameters> vehicle_fields() {
    using V = VehicleParameters;
    return {
        number(&V::body_mass_kg, "body_mass_kg", "kg", positive(), "mass of the whole car body")
            .of(Nature::mass)
            .required()
            .tolerance(0.05)
            .source(kTolerances),
        number(&V::body_pitch_inertia_kg_m2, "body_pitch_inertia_kg_m2", "kg m^2", positive(),
               "pitch inertia of the whole car body")
            .of(Nature::inertia)
            .required()
            .tolerance(0.05),
        number(&V::bogie_mass_kg, "bogie_mass_kg", "kg", positive(), "mass of one bogie without its wheelsets")
            .of(Nature::mass)
            .required()
            .tolerance(0.05),
        number(&V::bogie_pitch_inertia_kg_m2, "bogie_pitch_inertia_kg_m2", "kg m^2", positive(),
               "pitch inertia of one bogie")
            .of(Nature::inertia)
            .required()
            .tolerance(0.05),
        number(&V::wheelset_mass_kg, "wheelset_mass_kg", "kg", positive(), "mass of one wheelset")
            .of(Nature::mass)
            .required()
            .tolerance(0.05),
        number(&V::bogie_distance_m, "bogie_distance_m", "m", positive(), "distance between the bogie centres")
            .required(),
        number(&V::wheelbase_m, "wheelbase_m", "m", positive(), "distance between the wheelsets of a bogie").required(),
        number(&V::wheel_radius_m, "wheel_radius_m", "m", between(0.1, 1.0), "rolling radius of the wheels")
            .source("Chinese type A subway car: 0.42 m"),
        number(&V::payload_kg, "payload_kg", "kg", not_negative(),
               "extra mass in the car body, whole car; the pitch inertia grows in proportion")
            .of(Nature::mass),
    };
}

Fields<SuspensionParameters> suspension_fields() {
    using S = SuspensionParameters;
    return {
        number(&S::stiffness_n_per_m, "stiffness_n_per_m", "N/m", not_negative(),
               "spring of one element, per rail side")
            .of(Nature::stiffness)
            .required()
            .tolerance(0.10),
        number(&S::damping_n_s_per_m, "damping_n_s_per_m", "N s/m", not_negative(),
               "damper of one element, per rail side")
            .of(Nature::damping)
            .required()
            .tolerance(0.15),
        number(&S::damper_series_stiffness_n_per_m, "damper_series_stiffness_n_per_m", "N/m", positive_or_infinite(),
               "spring in series with the damper; inf: mounted rigidly")
            .of(Nature::stiffness)
            .source("Bruni et al. 2011, Vehicle System Dynamics 49(7)"),
        number(&S::friction_force_n, "friction_force_n", "N", not_negative(),
               "dry friction of one element, per rail side")
            .source("statistical linearisation, Roberts & Spanos 1990"),
    };
}

Fields<BodyBendingMode> body_bending_fields() {
    using B = BodyBendingMode;
    return {
        number(&B::frequency_hz, "frequency_hz", "Hz", positive(),
               "first free–free bending frequency of the empty body (a payload adds to the mode as to the body)")
            .required(),
        number(&B::damping_ratio, "damping_ratio", "1", between(0.0, 1.0), "damping ratio of the mode")
            .of(Nature::loss),
        number(&B::modal_mass_kg, "modal_mass_kg", "kg", positive(),
               "modal mass of the whole, empty body for unit displacement at its centre")
            .of(Nature::mass)
            .required(),
        number(&B::shape_at_pivots, "shape_at_pivots", "1", between(-2.0, 1.0),
               "displacement over the bogie pivots for 1 at the centre"),
    };
}

Fields<WheelsetBendingMode> wheelset_bending_fields() {
    using W = WheelsetBendingMode;
    return {
        number(&W::frequency_hz, "frequency_hz", "Hz", positive(), "first bending frequency of the free wheelset")
            .required(),
        number(&W::damping_ratio, "damping_ratio", "1", between(0.0, 1.0), "damping ratio of the mode")
            .of(Nature::loss),
        number(&W::modal_mass_kg, "modal_mass_kg", "kg", positive(),
               "modal mass of the whole wheelset for unit displacement at the wheels")
            .of(Nature::mass)
            .required(),
    };
}

Fields<BogieMountedMass> bogie_mounted_mass_fields() {
    using M = BogieMountedMass;
    return {
        number(&M::mass_kg, "mass_kg", "kg", positive(), "mass hung on each bogie, in addition to the bogie's own")
            .of(Nature::mass)
            .required(),
        number(&M::frequency_hz, "frequency_hz", "Hz", positive(), "frequency of the mass on a fixed frame").required(),
        number(&M::damping_ratio, "damping_ratio", "1", between(0.0, 2.0), "damping ratio of the mounting")
            .of(Nature::loss),
        number(&M::position_m, "position_m", "m", between(-5.0, 5.0),
               "position from the bogie centre, positive towards the front"),
    };
}

void check(const VehicleParameters& vehicle) {
    if (vehicle.wheelbase_m >= vehicle.bogie_distance_m)
        throw ParameterError(
            "vehicle.wheelbase_m",
            "the wheelbase is not shorter than the bogie distance, so wheels of different bogies would pass each other",
            "less than vehicle.bogie_distance_m");
    if (vehicle.body_bending.size() > 1)
        throw ParameterError("vehicle.body_bending", "more than one bending mode of the body", "at most one");
    if (vehicle.wheelset_bending.size() > 1)
        throw ParameterError("vehicle.wheelset_bending", "more than one bending mode of the wheelsets", "at most one");
    for (const SuspensionParameters* stage : {&vehicle.primary, &vehicle.secondary})
        if (stage->stiffness_n_per_m <= 0.0)
            throw ParameterError(
                stage == &vehicle.primary ? "vehicle.primary.stiffness_n_per_m" : "vehicle.secondary.stiffness_n_per_m",
                "a suspension without a spring cannot carry the car", "greater than 0");
}

}  // namespace railpem::vehicle
