// What is said to remain where a name is withheld.

#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/diagnose.hpp"
#include "diagnosis/effects/effect.hpp"
#include "tests/unit/diagnosis/synthesised_fixture.hpp"

namespace railpem::diagnosis {
namespace {

// Bogies three times as heavy are a wrong number. Where no level may be off at all, by however little, the same set
// does not stand, and what remains says by how much it is.
TEST(WhatRemains, LevelsThatStayOffAreSaid) {
    DiagnoseOptions options{.threads = 2};
    for (const Effect& effect : effects())
        if (effect.id != "parameter-error") options.naming.without.push_back(effect.id);
    for (const double allowed_db : {VerdictThresholds{}.level_db, -1.0}) {
        options.thresholds.level_db = allowed_db;
        Synthesised made =
            synthesised(paper_believed({"vehicle.bogie_mass_kg"}), {20.0}, 60.0, {"bogie_1", "wheel_1"}, kSmall);
        made.believed.uncertain.front().tolerance = 0.005;  // so well known that retuning does not follow
        made.truth.numbers.vehicle.bogie_mass_kg *= 3.0;
        made.draw(7);
        const Diagnosis found = diagnose(made.believed, made.observations, options);
        const bool said = std::any_of(found.remains.begin(), found.remains.end(), [](const std::string& own) {
            return own.starts_with("third octaves stay off by 0.");
        });
        EXPECT_EQ(found.verdict, allowed_db > 0.0 ? Verdict::explained : Verdict::unexplained) << found.statement;
        EXPECT_EQ(said, allowed_db < 0.0);
    }
}

}  // namespace
}  // namespace railpem::diagnosis
