// The committed reference page is the one that the library prints.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "diagnosis/effects/effect.hpp"
#include "effects/describe_effects.hpp"

namespace railpem::diagnosis {
namespace {

TEST(EffectsPage, IsUpToDate) {
    std::ifstream file(RAILPEM_SOURCE_DIR "/docs/effects.md");
    std::stringstream committed;
    committed << file.rdbuf();
    EXPECT_EQ(committed.str(), effects::describe_effects())
        << "refresh it with: build/release/railpem describe effects > docs/effects.md";
}

TEST(EffectsPage, EveryEffectHasItsFigure) {
    for (const Effect& effect : effects())
        EXPECT_TRUE(std::filesystem::exists(RAILPEM_SOURCE_DIR "/docs/effects/" + effect.id + ".png"))
            << "make it with: /usr/bin/python3 scripts/plot_effects.py " << effect.id;
}

}  // namespace
}  // namespace railpem::diagnosis
