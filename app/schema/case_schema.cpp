#include "app/schema/case_schema.hpp"

#include "app/schema/describe_table.hpp"
#include "app/schema/effect_list.hpp"

namespace railpem::app {

using namespace parameters;

namespace {

constexpr const char* kOneLayout =
    "a vehicle here is a body on two bogies of two wheelsets, all alike; one of another layout (two axles, one bogie, "
    "three axles, unequal axle loads, articulated) cannot be described";

Table<vehicle::VehicleParameters> vehicle_table() {
    using V = vehicle::VehicleParameters;
    const Table<vehicle::SuspensionParameters> suspension(vehicle::suspension_fields());
    Table<V> table(vehicle::vehicle_fields());
    table.note(kOneLayout, {"bogie_mass_kg", "bogie_pitch_inertia_kg_m2", "bogie_distance_m", "wheelbase_m"})
        .table("primary", &V::primary, "Primary suspension: one element per axle box and rail side", suspension)
        .table("secondary", &V::secondary, "Secondary suspension: one element per bogie and rail side", suspension)
        .list("body_bending", &V::body_bending, "The first bending mode of the car body; at most one",
              Table(vehicle::body_bending_fields()))
        .list("wheelset_bending", &V::wheelset_bending, "Bending of the axle, the same on every wheelset; at most one",
              Table(vehicle::wheelset_bending_fields()))
        .list("bogie_mounted_mass", &V::bogie_mounted_masses, "A mass hung elastically on each bogie frame",
              Table(vehicle::bogie_mounted_mass_fields()));
    return table;
}

Table<track::TrackParameters> track_table() {
    using T = track::TrackParameters;
    Table<track::SupportParameters> support(track::support_fields());
    support.list("bending_mode", &track::SupportParameters::bending_modes,
                 "A bending mode of the sleeper, seen at the rail seat", Table(track::sleeper_mode_fields()));
    Table<T> table(track::track_fields());
    table.table("rail", &T::rail, "One rail", Table(track::rail_fields()))
        .table("pads", &T::pads, "The rail pads, per rail seat: static curve, stiffness and damping",
               Table(track::pad_fields()))
        .table("support", &T::support, "What carries the pads, per rail seat", support)
        .table("static", &T::statics, "Loads of the static equilibrium, and where it shall differ from the dynamics",
               Table(track::static_fields()))
        .list("rail_damper", &T::rail_dampers, "A continuous line of tuned masses on the rail",
              Table(track::rail_damper_fields()))
        .list("failed_fasteners", &T::failed_fasteners, "Fasteners that carry little or nothing; at most one table",
              Table(track::failed_fastener_fields()));
    return table;
}

Table<spectra::IrregularityParameters> irregularity_table() {
    using I = spectra::IrregularityParameters;
    Table<I> table(spectra::irregularity_fields());
    table
        .list("band", &I::bands,
              "A family of spectra over a band of wavelengths; bands add where they overlap. At least one",
              Table(spectra::irregularity_band_fields()))
        .list("corrugation", &I::corrugation, "A narrow band in wavelength", Table(spectra::corrugation_fields()))
        .list("joints", &I::joints, "Dips at a regular distance", Table(spectra::rail_joint_fields()));
    return table;
}

Table<pem::CaseParameters> case_table() {
    using C = pem::CaseParameters;
    Table<C> table(pem::case_fields());
    table
        .table("vehicle", &C::vehicle,
               "The car: masses and inertias of the whole vehicle, bogie or wheelset; suspension per rail side",
               vehicle_table())
        .table("track", &C::track, "The track under one rail; everything under the rail is per rail seat",
               track_table())
        .table("contact", &C::contact, "The contact of wheel and rail", Table(pem::contact_fields()))
        .table("irregularity", &C::irregularity,
               "The vertical irregularity of the running surface, one-sided spectra in cycles/m", irregularity_table())
        .table("running", &C::running, "How the train runs", Table(pem::running_fields()))
        .table("frequency", &C::frequency, "The frequency lines of the solution", Table(pem::frequency_fields()))
        .table("solver", &C::solver, "How the rail is solved", Table(pem::solver_fields()))
        .table("sleeper_passing", &C::sleeper_passing, "Excitation by the supports passing under the wheels",
               Table(pem::sleeper_passing_fields()))
        .table("decay_rate_reference", &C::decay_rate_reference,
               "What this track was measured to have when the case was fitted to it, as `diagnose` writes it: decay "
               "rates of a later state are held against the "
               "prediction times these ratios. Nothing but `diagnose` reads it",
               Table(pem::decay_rate_reference_fields()))
        .list("wheel_out_of_roundness", &C::wheel_out_of_roundness, "A wheel that is not round",
              Table(pem::wheel_out_of_roundness_fields()))
        .list("sensor", &C::sensors, "What the acquisition does to a channel", Table(pem::sensor_fields()))
        .keyed_numbers("tolerance", &C::tolerances,
                       "How well a number of the case is known: relative standard deviation by dotted key, for "
                       "instance `\"vehicle.body_mass_kg\" = 0.03`; "
                       "0: known exactly. Without an entry the default in the column *tolerance* holds",
                       between(0.0, 10.0));
    table.variants(effect_list());
    return table;
}

constexpr const char* kCaseIntroduction =
    "A case file is TOML. SI units everywhere; every key that carries a unit ends in it. Positions are in metres from "
    "the centre of\n"
    "the vehicle body, positive towards the front. A number may be overridden on the command line with `--set "
    "key=value`, where the\n"
    "key is the dotted path, `vehicle.primary.stiffness_n_per_m` for instance, and elements of lists are counted from "
    "1:\n"
    "`irregularity.band[2].exponent`.\n\n"
    "This page is printed by `railpem describe case` from the same description that reads the file.";

}  // namespace

const TableSchema& case_schema() {
    static const std::shared_ptr<const TableSchema> schema = case_table().schema();
    return *schema;
}

pem::CaseParameters case_defaults() {
    pem::CaseParameters defaults;
    defaults.frequency.step_hz = 0.0;
    return defaults;
}

std::string describe_case() {
    const pem::CaseParameters defaults = case_defaults();
    return describe_table("The case file", kCaseIntroduction, case_schema(), &defaults);
}

}  // namespace railpem::app
