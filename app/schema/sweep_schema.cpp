#include "app/schema/sweep_schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "app/schema/case_file.hpp"
#include "app/schema/case_numbers.hpp"
#include "app/schema/describe_table.hpp"
#include "app/schema/nearest_key.hpp"
#include "app/schema/read_table.hpp"
#include "pem/response_names.hpp"
#include "spectra/third_octaves.hpp"

namespace railpem::app {

using namespace parameters;

namespace {

constexpr const char* kSpeeds = "running.speeds_m_per_s";
constexpr double kMostCases = 1e8;

Table<SweepDescription> sweep_table() {
    using S = SweepDescription;
    using V = VarySection;
    using K = KeepSection;
    Table<S> table(Fields<S>{
        text(&S::title, "title", "one line that names the sweep"),
        text(&S::case_path, "case", "the case file, relative to the sweep file").required(),
        choice(&S::design, "design", {"grid", "list", "latin-hypercube"},
               "grid: every combination, the last vary fastest; list: the n-th values together; latin-hypercube: "
               "samples spread evenly"),
        integer(&S::samples, "samples", between(0, 1e8), "number of cases of a Latin hypercube"),
        integer(&S::seed, "seed", between(0, 2147483647), "draws the Latin hypercube"),
        choice(&S::format, "format", {"automatic", "csv", "hdf5"},
               "the table; automatic: HDF5 where the CSV would exceed 100 MB"),
    });
    table
        .list("vary", &S::vary, "A number of the case that varies; at least one",
              Table(Fields<V>{
                  text(&V::key, "key", "dotted key of the case, elements of lists counted from 1").required(),
                  numbers(&V::values, "values", "", any_number(), "the values (grid, list)"),
                  number(&V::from, "from", "", any_number(), "first value, or lower end of a Latin hypercube"),
                  number(&V::to, "to", "", any_number(), "last value, or upper end"),
                  integer(&V::count, "count", between(0, 1e7), "number of values from `from` to `to`, ends included"),
                  boolean(&V::logarithmic, "logarithmic", "equal ratios instead of equal steps"),
              }))
        .list(
            "keep", &S::keep, "What is kept of every case; at least one",
            Table(Fields<K>{
                text(&K::response, "response", "body, body_front, …, wheel_1, rail_1, contact_1, trackbed").required(),
                choice(&K::quantity, "quantity",
                       {"rms", "peak-level", "peak-frequency", "bands", "spectrum", "weighted-rms-iso2631",
                        "mean-comfort-en12299", "sperling-index"},
                       "bands: third-octave levels; spectrum: every frequency line; the last three: vertical ride "
                       "comfort, of "
                       "a response of the body"),
            }));
    return table;
}

constexpr const char* kSweepIntroduction =
    "A sweep file is TOML. It names a case, the numbers of it that vary, and what is kept of every case. `railpem "
    "sweep` writes one\n"
    "long table: the case number, the varied values, the speed, the quantity, the response, the frequency where there "
    "is one, and the\n"
    "value. This page is printed by `railpem describe sweep`.";

const Node* list_element(const Document& document, const char* list, std::size_t index) {
    const Entry* entry = document.root.find(list);
    return entry && index < entry->node.elements.size() ? &entry->node.elements[index] : nullptr;
}

/// The message for something wrong in element `index` of a list, at one of its keys.
InputError refused_in(const Document& document, const char* list, std::size_t index, const char* key,
                      const Problem& problem) {
    const Node* element = list_element(document, list, index);
    const Entry* entry = element ? element->find(key) : nullptr;
    return document.error(entry ? entry->node.place : element ? element->place : Place{}, problem);
}

struct Varied {
    Description description;
    std::function<void(pem::CaseParameters&, double)> set;
};

/// The number of the case that a key means; speeds count as one number.
Varied varied_number(const Document& document, std::size_t index, const std::string& key,
                     const pem::CaseParameters& base) {
    if (key == kSpeeds) {
        Description description{.key = kSpeeds, .unit = "m/s", .range = {.low = 0.0, .high = 200.0, .low_open = true}};
        return {description,
                [](pem::CaseParameters& parameters, double value) { parameters.running.speeds_m_per_s = {value}; }};
    }
    std::vector<std::string> known{kSpeeds};
    for (const CaseNumber& number : case_numbers(base)) {
        std::vector<Step> steps = key_steps(number.key);
        if (number.key == key || key_text(steps) == key_text(key_steps(key))) return {number.description, number.set};
        known.push_back(number.key);
    }
    throw refused_in(document, "vary", index, "key",
                     {.what = fmt::format("the case has no number '{}'", key),
                      .allowed = "a dotted key of a number; railpem describe case lists them",
                      .hint = did_you_mean(key, known)});
}

std::vector<double> stepped_values(const VarySection& vary) {
    std::vector<double> values;
    for (int i = 0; i < vary.count; ++i) {
        const double share = vary.count > 1 ? static_cast<double>(i) / (vary.count - 1) : 0.0;
        values.push_back(vary.logarithmic ? vary.from * std::pow(vary.to / vary.from, share)
                                          : vary.from + share * (vary.to - vary.from));
    }
    return values;
}

pem::SweepAxis read_axis(const Document& document, std::size_t index, const VarySection& vary, pem::Design design,
                         const pem::CaseParameters& base) {
    const Varied varied = varied_number(document, index, vary.key, base);
    pem::SweepAxis axis{.key = vary.key,
                        .set = varied.set,
                        .values = vary.values,
                        .low = vary.from,
                        .high = vary.to,
                        .logarithmic = vary.logarithmic};
    const auto refuse = [&](const char* key, std::string what, std::string allowed) {
        throw refused_in(document, "vary", index, key,
                         {.what = std::move(what), .allowed = std::move(allowed), .hint = ""});
    };
    if (vary.logarithmic && (vary.from <= 0.0 || vary.to <= 0.0))
        refuse("from", "equal ratios need ends greater than 0", "from and to greater than 0");
    if (design == pem::Design::latin_hypercube) {
        if (!(vary.from < vary.to))
            refuse("from", fmt::format("the range of '{}' is empty", vary.key), "from less than to");
        axis.values = {vary.from, vary.to};  // the ends are what has to be allowed
    } else if (vary.values.empty()) {
        axis.values = stepped_values(vary);
        if (axis.values.empty())
            refuse("key", fmt::format("no values for '{}'", vary.key), "values, or from, to and count");
    }
    for (const double value : axis.values)
        if (!varied.description.range.contains(value))
            refuse(vary.values.empty() ? "from" : "values", fmt::format("'{}' cannot be {:g}", vary.key, value),
                   allowed_text(varied.description));
    if (design == pem::Design::latin_hypercube) axis.values.clear();
    return axis;
}

pem::BandRule band_rule(const pem::CaseParameters& base) {
    pem::BandRule rule;
    const std::vector<double> lines = pem::frequency_lines(base.frequency);
    for (const spectra::ThirdOctaveBand& band : spectra::third_octave_bands(lines.front(), lines.back()))
        rule.centre_hz.push_back(band.nominal_hz);
    rule.levels = [](const std::vector<double>& frequency, const std::vector<double>& psd) {
        std::vector<double> levels;
        for (const spectra::ThirdOctaveLevel& level : spectra::third_octave_levels(frequency, psd))
            levels.push_back(level.mean_square > 0.0 ? level.level_db : std::numeric_limits<double>::quiet_NaN());
        return levels;
    };
    return rule;
}

/// Comfort is of people: of the body, over the frequencies that its standards ask for.
void check_comfort(const Document& document, std::size_t index, const KeepSection& keep,
                   const pem::CaseParameters& base) {
    if (keep.quantity < pem::QuantityKind::weighted_rms_iso2631) return;
    if (!keep.response.starts_with("body"))
        throw refused_in(
            document, "keep", index, "response",
            {.what = "comfort is of people in the car", .allowed = "body, body_front, body_rear", .hint = ""});
    constexpr double kFrom_hz = 0.5, kTo_hz = 80.0;
    if (base.frequency.from_hz > kFrom_hz || pem::frequency_lines(base.frequency).back() < kTo_hz)
        throw refused_in(document, "keep", index, "quantity",
                         {.what = fmt::format("the lines of the case reach from {:g} to {:g} Hz",
                                              base.frequency.from_hz, base.frequency.to_hz),
                          .allowed = fmt::format("lines that cover {:g} to {:g} Hz", kFrom_hz, kTo_hz),
                          .hint = ""});
}

std::vector<pem::SweepQuantity> read_quantities(const Document& document, const SweepDescription& description,
                                                const pem::CaseParameters& base) {
    std::vector<std::string> known;
    for (const pem::ResponseName& name : pem::response_names()) known.push_back(name.where);
    std::vector<pem::SweepQuantity> quantities;
    for (std::size_t i = 0; i < description.keep.size(); ++i) {
        const KeepSection& keep = description.keep[i];
        if (std::find(known.begin(), known.end(), keep.response) == known.end()) {
            throw refused_in(document, "keep", i, "response",
                             {.what = fmt::format("there is no response '{}'", keep.response),
                              .allowed = joined(known),
                              .hint = did_you_mean(keep.response, known)});
        }
        if (keep.quantity == pem::QuantityKind::spectrum && base.frequency.step_hz == 0.0)
            throw refused_in(document, "keep", i, "quantity",
                             {.what = "a spectrum has other lines in every case where the case states no step",
                              .allowed = "a case with frequency.step_hz, or another quantity",
                              .hint = ""});
        check_comfort(document, i, keep, base);
        quantities.push_back({keep.response, keep.quantity});
    }
    return quantities;
}

void check_design(const Document& document, const SweepFile& sweep) {
    const auto refuse = [&](const std::string& key, std::string what, std::string allowed) {
        const Entry* entry = document.root.find(key);
        throw document.error(entry ? entry->place : Place{},
                             {.what = std::move(what), .allowed = std::move(allowed), .hint = ""});
    };
    const SweepDescription& description = sweep.description;
    if (description.vary.empty()) refuse("vary", "nothing varies", "at least one [[vary]]");
    if (description.keep.empty()) refuse("keep", "nothing is kept", "at least one [[keep]]");
    if (description.design == pem::Design::latin_hypercube && description.samples < 1)
        refuse("samples", "a Latin hypercube without samples", "samples of at least 1");
    double cases = 1.0;
    for (const pem::SweepAxis& axis : sweep.plan.axes) {
        cases *= static_cast<double>(std::max<std::size_t>(1, axis.values.size()));
        if (description.design == pem::Design::list && axis.values.size() != sweep.plan.axes.front().values.size())
            refuse("vary",
                   fmt::format("'{}' has {} values and '{}' has {}", axis.key, axis.values.size(),
                               sweep.plan.axes.front().key, sweep.plan.axes.front().values.size()),
                   "lists of the same length");
    }
    if (description.design == pem::Design::grid && cases > kMostCases)
        refuse("vary", fmt::format("{:g} combinations", cases), fmt::format("at most {:g}", kMostCases));
}

/// Every combination must be a possible case, and none may change the number of lines or speeds.
void check_combinations(const Document& document, const SweepFile& sweep) {
    const std::size_t cases = pem::sweep_size(sweep.plan);
    const std::size_t lines = pem::frequency_lines(sweep.plan.base.frequency).size();
    for (std::size_t index = 0; index < cases; ++index) {
        const auto combination = [&] {
            std::string list;
            const std::vector<double> values = pem::sweep_values(sweep.plan, index);
            for (std::size_t axis = 0; axis < values.size(); ++axis)
                list += fmt::format("{}{} = {:g}", axis > 0 ? ", " : "", sweep.plan.axes[axis].key, values[axis]);
            return list;
        };
        const pem::CaseParameters parameters = pem::sweep_case(sweep.plan, index);
        try {
            pem::check(parameters);
            if (pem::frequency_lines(parameters.frequency).size() != lines)
                throw ParameterError("frequency", "the number of frequency lines would change within the sweep",
                                     "keys that leave the grid as it is");
        } catch (const ParameterError& error) {
            throw refused_in(document, "vary", 0, "key",
                             {.what = fmt::format("case {} ({}) cannot be: {}: {}", index + 1, combination(),
                                                  error.key(), error.problem()),
                              .allowed = error.allowed(),
                              .hint = ""});
        }
    }
}

}  // namespace

const TableSchema& sweep_schema() {
    static const std::shared_ptr<const TableSchema> schema = sweep_table().schema();
    return *schema;
}

std::string describe_sweep() {
    const SweepDescription defaults;
    return describe_table("The sweep file", kSweepIntroduction, sweep_schema(), &defaults);
}

namespace {

/// The plan of a description that was read from `document`, over `base`.
SweepFile planned(const Document& document, SweepDescription description, const pem::CaseParameters& base) {
    SweepFile sweep{.name = std::filesystem::path(document.name).stem().string(),
                    .description = std::move(description),
                    .plan = {}};
    pem::SweepPlan& plan = sweep.plan;
    plan.base = base;
    plan.design = sweep.description.design;
    plan.samples = static_cast<std::size_t>(sweep.description.samples);
    plan.seed = static_cast<std::uint64_t>(sweep.description.seed);
    plan.quantities = read_quantities(document, sweep.description, base);
    for (std::size_t i = 0; i < sweep.description.vary.size(); ++i) {
        plan.axes.push_back(read_axis(document, i, sweep.description.vary[i], plan.design, plan.base));
        if (plan.axes.back().key == kSpeeds) plan.base.running.speeds_m_per_s.resize(1);
    }
    plan.bands = band_rule(plan.base);
    check_design(document, sweep);
    check_combinations(document, sweep);
    return sweep;
}

}  // namespace

SweepFile read_sweep(const std::string& path, const std::vector<std::string>& options, Refuse refuse) {
    const Document document = read_document(path);
    SweepDescription description;
    Refusals found;
    read_table(document, sweep_schema(), &description, refuse == Refuse::all ? &found : nullptr);
    throw_all(found);
    const std::filesystem::path case_path = std::filesystem::path(path).parent_path() / description.case_path;
    if (!std::filesystem::exists(case_path)) {
        const Entry* entry = document.root.find("case");
        throw document.error(entry->node.place, {.what = fmt::format("there is no case file '{}'", case_path.string()),
                                                 .allowed = "a path relative to the sweep file",
                                                 .hint = ""});
    }
    return planned(document, std::move(description), read_case(case_path.string(), options, refuse).parameters);
}

SweepFile parse_sweep(const std::string& name, const std::string& text, const pem::CaseParameters& base) {
    const Document document = parse_document(name, text);
    SweepDescription description;
    read_table(document, sweep_schema(), &description);
    return planned(document, std::move(description), base);
}

}  // namespace railpem::app
