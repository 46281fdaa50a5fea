// Every way to write an [[effect]] table wrong, with the whole message that the user sees.

#include <gtest/gtest.h>

#include "program_run.hpp"

namespace railpem::tests {
namespace {

constexpr const char* kIds =
    "\"pad-frequency-stiffening\", \"pad-preload-stiffening\", \"pad-hysteresis\", \"rail-shear\", "
    "\"support-compliance\", \"sleeper-flexibility\", \"rail-damper\", \"failed-fasteners\", \"sleeper-passing\", "
    "\"wheel-out-of-roundness\", \"rail-corrugation\", \"rail-joints\", \"irregularity-spectrum\", \"body-bending\", "
    "\"wheelset-bending\", \"bogie-mounted-mass\", \"primary-damper-series-stiffness\", "
    "\"secondary-damper-series-stiffness\", \"suspension-friction\", \"contact-nonlinearity\", \"contact-filter\", "
    "\"sensor-gain\", \"sensor-resonance\", \"sensor-noise\", \"timing-skew\", \"parameter-error\"";

/// The effects stand before the rest of the minimal case, so that their lines are the first.
void expect_effects_refused(const std::string& effects, const std::string& message,
                            const std::vector<std::string>& options = {}) {
    expect_refused(effects + "\n" + minimal_case(), message, options);
}

TEST(RefusedEffects, WithoutAnIdentifier) {
    expect_effects_refused("[[effect]]\nexponent = 0.1\n",
                           std::string("case.toml:1:1: [effect] has no 'id' (which effect)\n"
                                       "  1 | [[effect]]\n"
                                       "    | ^^^^^^^^^^\n"
                                       "allowed: ") +
                               kIds);
}

TEST(RefusedEffects, UnknownIdentifier) {
    expect_effects_refused("[[effect]]\nid = \"rail-sheer\"\n",
                           std::string("case.toml:2:6: 'id' cannot be \"rail-sheer\"\n"
                                       "  2 | id = \"rail-sheer\"\n"
                                       "    |      ^^^^^^^^^^^^\n"
                                       "allowed: ") +
                               kIds + "\ndid you mean \"rail-shear\"?");
}

TEST(RefusedEffects, UnknownParameter) {
    expect_effects_refused("[[effect]]\nid = \"rail-damper\"\nmass_kg = 10.0\n",
                           "case.toml:3:1: unknown key 'mass_kg' in [effect]\n"
                           "  3 | mass_kg = 10.0\n"
                           "    | ^^^^^^^\n"
                           "allowed: id, mass_kg_per_m, frequency_hz, loss_factor, loss_exponent\n"
                           "did you mean 'mass_kg_per_m', in kg/m?");
}

TEST(RefusedEffects, ParameterOfAnotherEffect) {
    expect_effects_refused("[[effect]]\nid = \"rail-shear\"\nexponent = 0.1\n",
                           "case.toml:3:1: unknown key 'exponent' in [effect]\n"
                           "  3 | exponent = 0.1\n"
                           "    | ^^^^^^^^\n"
                           "allowed: id, shear_coefficient\n"
                           "did you mean 'track.pads.exponent' or 'irregularity.band.exponent'?");
}

TEST(RefusedEffects, OutOfRange) {
    expect_effects_refused("[[effect]]\nid = \"pad-frequency-stiffening\"\nexponent = 0.5\n",
                           "case.toml:3:12: 'exponent' cannot be 0.5\n"
                           "  3 | exponent = 0.5\n"
                           "    |            ^^^\n"
                           "allowed: a number between 0.02 and 0.35");
}

TEST(RefusedEffects, WrongChoice) {
    expect_effects_refused("[[effect]]\nid = \"suspension-friction\"\nstage = \"primery\"\n",
                           "case.toml:3:9: 'stage' cannot be \"primery\"\n"
                           "  3 | stage = \"primery\"\n"
                           "    |         ^^^^^^^^^\n"
                           "allowed: \"primary\", \"secondary\"\n"
                           "did you mean \"primary\"?");
}

TEST(RefusedEffects, MissingChoice) {
    expect_effects_refused("[[effect]]\nid = \"wheel-out-of-roundness\"\nwheel = 1\n",
                           "case.toml:1:1: [effect] has no 'order' (number of waves around the circumference)\n"
                           "  1 | [[effect]]\n"
                           "    | ^^^^^^^^^^\n"
                           "allowed: an integer between 1 and 60");
}

TEST(RefusedEffects, WholeNumbersOnly) {
    expect_effects_refused("[[effect]]\nid = \"wheel-out-of-roundness\"\nwheel = 1.5\norder = 3\n",
                           "case.toml:3:9: 'wheel' cannot be a number\n"
                           "  3 | wheel = 1.5\n"
                           "    |         ^^^\n"
                           "allowed: an integer between 1 and 4");
}

TEST(RefusedEffects, TwoThatExcludeEachOther) {
    expect_effects_refused("[[effect]]\nid = \"failed-fasteners\"\nfraction = 0.1\nevery = 8\n",
                           "case.toml:4:9: effect[1].every: 'failed-fasteners' has both 'every' and 'fraction'\n"
                           "  4 | every = 8\n"
                           "    |         ^\n"
                           "allowed: one of them");
}

/// The case forbids the effect: the message is at the table that asks for it, the second here.
TEST(RefusedEffects, WhatTheCaseForbids) {
    expect_effects_refused(
        "[[effect]]\nid = \"rail-shear\"\n[[effect]]\nid = \"sleeper-flexibility\"\n",
        "case.toml:4:6: effect[2].id: no 'sleeper-flexibility': there is no sleeper in the case that could "
        "bend\n"
        "  4 | id = \"sleeper-flexibility\"\n"
        "    |      ^^^^^^^^^^^^^^^^^^^^^\n"
        "allowed: a case with track.support.model = \"two-layer\", or support-compliance beside it");
}

TEST(RefusedEffects, KeyThatTheCaseDoesNotHave) {
    expect_effects_refused("[[effect]]\nid = \"parameter-error\"\nparameter = \"vehicle.bogie_mas_kg\"\n",
                           "case.toml:3:13: the case has no physical number 'vehicle.bogie_mas_kg'\n"
                           "  3 | parameter = \"vehicle.bogie_mas_kg\"\n"
                           "    |             ^^^^^^^^^^^^^^^^^^^^^^\n"
                           "allowed: a dotted key of a number that the case states or has by default\n"
                           "did you mean 'vehicle.bogie_mass_kg'?");
}

TEST(RefusedEffects, KeyThatWouldLeaveItsRange) {
    expect_effects_refused(
        "[[effect]]\nid = \"parameter-error\"\nparameter = \"track.rail.shear_coefficient\"\nfactor = 3.0\n",
        "case.toml:4:10: effect[1].factor: 'track.rail.shear_coefficient' would be 1.2\n"
        "  4 | factor = 3.0\n"
        "    |          ^^^\n"
        "allowed: a number between 0.05 and 1");
}

TEST(RefusedEffects, KeyThatNoFactorChanges) {
    expect_effects_refused("[[effect]]\nid = \"parameter-error\"\nparameter = \"vehicle.payload_kg\"\n",
                           "case.toml:3:13: effect[1].parameter: 'vehicle.payload_kg' is 0 and no factor changes that\n"
                           "  3 | parameter = \"vehicle.payload_kg\"\n"
                           "    |             ^^^^^^^^^^^^^^^^^^^^\n"
                           "allowed: a number of the case that is neither 0 nor infinite");
}

TEST(RefusedEffects, OneTableInsteadOfAList) {
    expect_effects_refused("[effect]\nid = \"rail-shear\"\n",
                           "case.toml:1:2: 'effect' is a list of tables, not a table\n"
                           "  1 | [effect]\n"
                           "    |  ^^^^^^\n"
                           "allowed: tables [[effect]], as many as there are");
}

TEST(RefusedEffects, OptionBeforeTheIdentifier) {
    expect_effects_refused("",
                           std::string("--set effect.exponent=0.1: unknown key 'exponent' in [effect]\n"
                                       "allowed: id\n"
                                       "did you mean 'track.pads.exponent' or 'irregularity.band.exponent'?"),
                           {"effect.exponent=0.1"});
}

}  // namespace
}  // namespace railpem::tests
