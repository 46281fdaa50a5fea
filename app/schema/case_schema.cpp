#include "app/schema/case_schema.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/schema/apply_option.hpp"
#include "app/schema/describe_table.hpp"
#include "app/schema/effect_tables.hpp"
#include "app/schema/irregularity_files.hpp"
#include "app/schema/read_table.hpp"
#include "app/schema/write_table.hpp"

namespace railpem::app {

using namespace parameters;

namespace {

Table<vehicle::VehicleParameters> vehicle_table() {
    using V = vehicle::VehicleParameters;
    const Table<vehicle::SuspensionParameters> suspension(vehicle::suspension_fields());
    Table<V> table(vehicle::vehicle_fields());
    table.table("primary", &V::primary, "Primary suspension: one element per axle box and rail side", suspension)
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

/// Every number below a table, reached through `locate`: the table's struct within a case.
using Locate = std::function<void*(pem::CaseParameters&)>;

void collect_numbers(const TableSchema& schema, const std::string& prefix, const Locate& locate,
                     pem::CaseParameters& parameters, std::vector<CaseNumber>& numbers) {
    for (const FieldSchema& field : schema.fields) {
        if (field.description.kind != Kind::number) continue;
        CaseNumber number{.key = prefix + field.description.key,
                          .description = field.description,
                          .tolerance = field.description.tolerance};
        number.get = [get = field.get, locate](const pem::CaseParameters& owner) {
            return std::get<double>(get(locate(const_cast<pem::CaseParameters&>(owner))));
        };
        number.set = [set = field.set, locate](pem::CaseParameters& owner, double value) { set(locate(owner), value); };
        numbers.push_back(std::move(number));
    }
    for (const SubtableSchema& child : schema.tables) {
        const Locate within = [locate, member = child.member](pem::CaseParameters& owner) {
            return member(locate(owner));
        };
        collect_numbers(*child.table, prefix + child.name + ".", within, parameters, numbers);
    }
    for (const TableListSchema& list : schema.lists)
        for (std::size_t i = 0; i < list.size(locate(parameters)); ++i) {
            const Locate within = [locate, at = list.at, i](pem::CaseParameters& owner) {
                return at(locate(owner), i);
            };
            collect_numbers(*list.table, fmt::format("{}{}[{}].", prefix, list.name, i + 1), within, parameters,
                            numbers);
        }
}

CaseFile read_document_as_case(Document document, const std::string& name, const std::vector<std::string>& options) {
    for (const std::string& option : options) apply_option(document, case_schema(), option);
    CaseFile file{.name = name, .document = std::move(document)};
    read_table(file.document, case_schema(), &file.without_effects);
    read_irregularity_files(file.document, file.without_effects.irregularity);
    file.effects = read_effects(file.document, case_schema());
    file.parameters = with_effects(file.document, file.without_effects, file.effects);
    try {
        pem::check(file.parameters);
    } catch (const ParameterError& error) {
        throw refused(file.document, error);
    }
    return file;
}

}  // namespace

const TableSchema& case_schema() {
    static const std::shared_ptr<const TableSchema> schema = case_table().schema();
    return *schema;
}

CaseFile read_case(const std::string& path, const std::vector<std::string>& options) {
    return read_document_as_case(read_document(path), std::filesystem::path(path).stem().string(), options);
}

CaseFile parse_case(const std::string& name, const std::string& text, const std::vector<std::string>& options) {
    return read_document_as_case(parse_document(name, text), std::filesystem::path(name).stem().string(), options);
}

CaseFile changed_case(const CaseFile& file, const std::vector<std::string>& options) {
    return read_document_as_case(file.document, file.name, options);
}

std::string write_case(const pem::CaseParameters& parameters, const std::vector<diagnosis::EffectInstance>& effects) {
    const pem::CaseParameters defaults;
    return write_table(case_schema(), &parameters, &defaults) + write_effects(effects);
}

std::string describe_case() {
    const pem::CaseParameters defaults;
    return describe_table("The case file", kCaseIntroduction, case_schema(), &defaults);
}

std::vector<CaseNumber> case_numbers(const pem::CaseParameters& parameters) {
    std::vector<CaseNumber> numbers;
    pem::CaseParameters shape = parameters;
    collect_numbers(
        case_schema(), "", [](pem::CaseParameters& owner) -> void* { return &owner; }, shape, numbers);
    for (CaseNumber& number : numbers) {
        std::vector<Step> steps = key_steps(number.key);
        for (const bool with_elements : {false, true}) {
            std::vector<Step> named = steps;
            if (!with_elements)
                for (Step& step : named) step.element = 0;
            const auto stated = parameters.tolerances.find(key_text(named));
            if (stated != parameters.tolerances.end()) number.tolerance = stated->second;
        }
    }
    return numbers;
}

}  // namespace railpem::app
