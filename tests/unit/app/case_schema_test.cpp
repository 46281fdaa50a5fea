#include "app/schema/case_schema.hpp"
#include "app/schema/case_file.hpp"
#include "app/schema/case_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

#include "app/input_error.hpp"
#include "app/schema/read_table.hpp"
#include "file_text.hpp"

namespace railpem::app {
namespace {

const std::filesystem::path kPaper = std::filesystem::path(RAILPEM_SOURCE_DIR) / "cases/wei2016";

pem::CaseParameters paper_case(const std::vector<std::string>& options = {}) {
    return read_case((kPaper / "case3.toml").string(), options).parameters;
}

TEST(CaseSchema, ReadsThePaperAsItStandsInItsTables) {
    const pem::CaseParameters parameters = paper_case();
    EXPECT_DOUBLE_EQ(parameters.vehicle.body_mass_kg, 38500.0);
    EXPECT_DOUBLE_EQ(parameters.vehicle.secondary.damping_n_s_per_m, 2.0e5);
    EXPECT_DOUBLE_EQ(parameters.track.rail.mass_kg_per_m, 60.64);
    EXPECT_DOUBLE_EQ(parameters.track.statics.second_moment_of_area_m4, 5.24e-6);
    ASSERT_EQ(parameters.irregularity.bands.size(), 2u);
    EXPECT_EQ(parameters.irregularity.bands[1].family, spectra::Family::power_law);
    EXPECT_EQ(parameters.running.speeds_m_per_s, std::vector<double>{80.0 / 3.6});
    EXPECT_EQ(parameters.solver.rail, pem::RailSolution::exact);
    EXPECT_TRUE(std::isinf(parameters.vehicle.primary.damper_series_stiffness_n_per_m));
}

TEST(CaseSchema, PolynomialOfThePaperInNewtonAndMetres) {
    const std::vector<double> c = paper_case().track.pads.force_polynomial_n;
    // Equation (2) at 2 mm, in kN: 0.0401·16 + 0.1228·8 + 3.368·4 + 5.021·2 − 0.4518.
    const double published_kn = 0.0401 * 16 + 0.1228 * 8 + 3.368 * 4 + 5.021 * 2 - 0.4518;
    double force_n = 0.0;
    for (std::size_t i = c.size(); i-- > 0;) force_n = force_n * 2e-3 + c[i];
    EXPECT_NEAR(force_n, published_kn * 1e3, 1e-9 * force_n);  // rounding of five products
}

/// A case in which every key has another value than its default, made through the schema itself.
void set_all(const TableSchema& schema, void* owner) {
    for (const FieldSchema& field : schema.fields) {
        const parameters::Range& range = field.description.range;
        const double low = std::isfinite(range.low) ? range.low : -3.0;
        const double high = std::isfinite(range.high) ? range.high : low + 7.0;
        const double within = low + (high - low) / 3.0;  // periodic in binary: all digits matter
        switch (field.description.kind) {
            case parameters::Kind::boolean:
                field.set(owner, true);
                break;
            case parameters::Kind::integer:
                field.set(owner, static_cast<std::int64_t>(within) + 1);
                break;
            case parameters::Kind::number:
                field.set(owner, within);
                break;
            case parameters::Kind::numbers:
                field.set(owner, std::vector<double>{within, within + 0.1, within + 0.2});
                break;
            case parameters::Kind::choice:
                field.set(owner, field.description.choices.back());
                break;
            case parameters::Kind::text:
                field.set(owner, std::string("a \"quoted\" text with\\ all of it: é"));
                break;
        }
    }
    for (const SubtableSchema& child : schema.tables) set_all(*child.table, child.member(owner));
    for (const TableListSchema& list : schema.lists)
        for (int i = 0; i < 2; ++i) set_all(*list.table, list.append(owner));
    for (const KeyedNumbersSchema& keyed : schema.keyed_numbers)
        keyed.member(owner) = {{"vehicle.body_mass_kg", 1.0 / 3.0}, {"irregularity.band[2].exponent", 0.5}};
}

void expect_same(const TableSchema& schema, void* a, void* b, const std::string& path) {
    for (const FieldSchema& field : schema.fields)
        EXPECT_EQ(field.get(a), field.get(b)) << path << field.description.key;
    for (const SubtableSchema& child : schema.tables)
        expect_same(*child.table, child.member(a), child.member(b), path + child.name + ".");
    for (const TableListSchema& list : schema.lists) {
        ASSERT_EQ(list.size(a), list.size(b)) << path << list.name;
        for (std::size_t i = 0; i < list.size(a); ++i)
            expect_same(*list.table, list.at(a, i), list.at(b, i), path + list.name + ".");
    }
    for (const KeyedNumbersSchema& keyed : schema.keyed_numbers)
        EXPECT_EQ(keyed.member(a), keyed.member(b)) << path << keyed.name;
}

TEST(WriteCase, EveryKeyReadsBackToTheSameBits) {
    pem::CaseParameters written;
    set_all(case_schema(), &written);
    const std::string text = write_case(written);
    pem::CaseParameters read;
    read_table(parse_document("written.toml", text), case_schema(), &read);
    expect_same(case_schema(), &written, &read, "");
}

TEST(WriteCase, ThePaperReadsBackAndStaysShort) {
    pem::CaseParameters written = paper_case();
    const std::string text = write_case(written);
    pem::CaseParameters read = parse_case("written.toml", text, {}).parameters;
    expect_same(case_schema(), &written, &read, "");
    EXPECT_EQ(text.find("series_stiffness"), std::string::npos) << "defaults are left out";
    EXPECT_NE(text.find("speeds_m_per_s = 22.22222222222222"), std::string::npos);
}

TEST(Options, OverrideAddAndAppend) {
    EXPECT_DOUBLE_EQ(paper_case({"vehicle.body_mass_kg=40000"}).vehicle.body_mass_kg, 40000.0);
    EXPECT_DOUBLE_EQ(paper_case({"vehicle.payload_kg=5e3", "vehicle.payload_kg=6e3"}).vehicle.payload_kg, 6e3);
    EXPECT_EQ(paper_case({"solver.rail=modal"}).solver.rail, pem::RailSolution::modal);
    EXPECT_EQ(paper_case({"running.speeds_m_per_s=[10, 20.5]"}).running.speeds_m_per_s,
              (std::vector<double>{10.0, 20.5}));
    EXPECT_DOUBLE_EQ(paper_case({"irregularity.band[2].exponent=3.0"}).irregularity.bands[1].exponent, 3.0);
    EXPECT_DOUBLE_EQ(paper_case({"irregularity.band.2.exponent=3.0"}).irregularity.bands[1].exponent, 3.0);
    const pem::CaseParameters bending =
        paper_case({"vehicle.body_bending.frequency_hz=9.5", "vehicle.body_bending.modal_mass_kg=9000"});
    ASSERT_EQ(bending.vehicle.body_bending.size(), 1u);
    EXPECT_DOUBLE_EQ(bending.vehicle.body_bending[0].frequency_hz, 9.5);
}

TEST(Options, ReplaceATolerance) {
    const std::string text = testing::file_text(kPaper / "case3.toml") +
                             "\n[tolerance]\n\"vehicle.body_mass_kg\" = 0.1\nvehicle.wheelset_mass_kg = 0.2\n";
    const pem::CaseParameters parameters =
        parse_case("case.toml", text, {"tolerance.vehicle.body_mass_kg=0.3", "tolerance.vehicle.wheelset_mass_kg=0.4"})
            .parameters;
    EXPECT_EQ(parameters.tolerances,
              (std::map<std::string, double>{{"vehicle.body_mass_kg", 0.3}, {"vehicle.wheelset_mass_kg", 0.4}}));
}

TEST(CaseNumbers, ReachEveryNumberOfTheCaseOnce) {
    pem::CaseParameters parameters = paper_case();
    std::set<std::string> keys;
    for (const CaseNumber& number : case_numbers(parameters)) {
        EXPECT_TRUE(keys.insert(number.key).second) << number.key;
        const double before = number.get(parameters);
        number.set(parameters, 0.123456789);
        EXPECT_EQ(number.get(parameters), 0.123456789) << number.key;
        number.set(parameters, before);
    }
    for (const char* key : {"vehicle.body_mass_kg", "track.pads.exponent", "irregularity.band[2].coefficient_m3",
                            "track.static.clip_preload_n"})
        EXPECT_TRUE(keys.contains(key)) << key;
    EXPECT_FALSE(keys.contains("vehicle.body_bending[1].frequency_hz")) << "this case has no bending mode";
}

TEST(CaseNumbers, WriteTheMemberTheyName) {
    pem::CaseParameters parameters = paper_case();
    for (const CaseNumber& number : case_numbers(parameters))
        if (number.key == "irregularity.band[2].exponent") number.set(parameters, 2.5);
    EXPECT_DOUBLE_EQ(parameters.irregularity.bands[1].exponent, 2.5);
    EXPECT_DOUBLE_EQ(parameters.irregularity.bands[0].exponent, 0.0);
}

TEST(CaseNumbers, TakeTheToleranceOfTheCaseOrOfTheField) {
    pem::CaseParameters parameters = paper_case();
    parameters.tolerances = {{"track.pads.static_stiffness_n_per_m", 0.01},
                             {"irregularity.band.exponent", 0.2},
                             {"irregularity.band[2].exponent", 0.4}};
    std::map<std::string, double> tolerance;
    for (const CaseNumber& number : case_numbers(parameters)) tolerance[number.key] = number.tolerance;
    EXPECT_EQ(tolerance["vehicle.body_mass_kg"], 0.05);
    EXPECT_EQ(tolerance["track.pads.static_stiffness_n_per_m"], 0.01);
    EXPECT_EQ(tolerance["irregularity.band[1].exponent"], 0.2);
    EXPECT_EQ(tolerance["irregularity.band[2].exponent"], 0.4);
}

TEST(ReferencePage, IsUpToDate) {
    EXPECT_EQ(testing::file_text(std::filesystem::path(RAILPEM_SOURCE_DIR) / "docs/case.md"), describe_case())
        << "run: railpem describe case > docs/case.md";
}

/// Every key that is described says what it is.
void expect_described(const TableSchema& schema, const std::string& path) {
    std::set<std::string> names;
    for (const std::string& name : schema.names())
        EXPECT_TRUE(names.insert(name).second) << path << name << " stands twice";
    for (const FieldSchema& field : schema.fields) {
        EXPECT_FALSE(field.description.says.empty()) << path << field.description.key;
        if (field.description.kind == parameters::Kind::number) {
            EXPECT_FALSE(field.description.unit.empty()) << path << field.description.key;
        }
    }
    for (const SubtableSchema& child : schema.tables) expect_described(*child.table, path + child.name + ".");
    for (const TableListSchema& list : schema.lists) expect_described(*list.table, path + list.name + ".");
}

TEST(CaseSchema, EveryKeyIsDescribed) {
    expect_described(case_schema(), "");
}

}  // namespace
}  // namespace railpem::app
