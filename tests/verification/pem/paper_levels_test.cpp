// What Wei et al. (2016) quote, against the case files that ship: the static numbers of Figures 4 and 5, the twelve
// levels and the six frequencies of sections 4.3.2 to 4.3.4. docs/paper/README.md holds the same comparison as a table.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "app/schema/case_file.hpp"
#include "pem/coupling/solution.hpp"
#include "pem/coupling/solve_case.hpp"
#include "pem/rail/case_equilibrium.hpp"
#include "pem/response_names.hpp"

namespace {

using namespace railpem;

struct PublishedPeak {
    const char* response;
    int number;  ///< of the case
    double frequency_hz;
    double psd;
};

/// Wheel: section 4.3.3, rail: section 4.3.4; m²/s⁴/Hz.
const std::vector<PublishedPeak> published_peaks{{"wheel_1", 1, 57.6, 4.2}, {"wheel_1", 2, 66.7, 7.0},
                                                 {"wheel_1", 3, 75.1, 7.8}, {"rail_1", 1, 76.1, 4.1},
                                                 {"rail_1", 2, 84.7, 6.2},  {"rail_1", 3, 85.0, 6.9}};

/// A maximum of the paper is looked for within 1.5 Hz: a sixth of the distance of two teeth of the comb, v/2.4 m.
constexpr double kPeakWindowHz = 1.5;

using Options = std::vector<std::string>;

pem::CaseParameters shipped_case(const std::string& name, const Options& options = {}) {
    return app::read_case(std::string(RAILPEM_SOURCE_DIR) + "/cases/wei2016/" + name + ".toml", options).parameters;
}

/// The three cases of the paper, 1 to 3, with one of the two static variants as case 3.
std::map<int, pem::Solution> solve_cases(const std::string& third, const Options& options = {}) {
    std::map<int, pem::Solution> solved;
    for (const auto& [number, name] : std::map<int, std::string>{{1, "case1"}, {2, "case2"}, {3, third}}) {
        pem::CaseParameters parameters = shipped_case(name, options);
        // From here the short waves of equation (9) alone excite; 0.1 Hz as in the file keeps the grid of the paper's
        // digits.
        parameters.frequency.from_hz = 20.0;
        parameters.frequency.to_hz = 90.0;
        solved.emplace(number, pem::solve_case(parameters, parameters.running.speeds_m_per_s.front(), {.threads = 1}));
    }
    return solved;
}

std::vector<double> psd(const pem::Solution& solution, const std::string& where) {
    return pem::response_psd(solution, pem::response_index(where));
}

struct FoundPeak {
    double frequency_hz;
    double psd;
    bool is_local_maximum;  ///< not merely the largest value at a side of the window
};

FoundPeak highest_near(const pem::Solution& solution, const std::string& where, double frequency_hz) {
    const std::vector<double> values = psd(solution, where);
    std::size_t highest = 0;
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        const bool is_near = std::abs(solution.frequency_hz[i] - frequency_hz) <= kPeakWindowHz + 1e-9;
        if (is_near && (highest == 0 || values[i] > values[highest])) highest = i;
    }
    const bool is_local_maximum = values[highest] > values[highest - 1] && values[highest] > values[highest + 1];
    return {solution.frequency_hz[highest], values[highest], is_local_maximum};
}

/// At a line of the grid; every frequency at which the paper quotes the bogie is one.
double bogie_at(const pem::Solution& solution, double frequency_hz) {
    const auto line =
        std::ranges::min_element(solution.frequency_hz, {}, [&](double f) { return std::abs(f - frequency_hz); });
    EXPECT_NEAR(*line, frequency_hz, 1e-9);
    return psd(solution, "bogie_1")[static_cast<std::size_t>(line - solution.frequency_hz.begin())];
}

/// Computed over published: six maxima, then points A (37 Hz) and B (73.7 Hz) of Figure 8 with the other cases relative
/// to them.
std::vector<double> ratios(const std::map<int, pem::Solution>& solved) {
    std::vector<double> result;
    for (const PublishedPeak& peak : published_peaks)
        result.push_back(highest_near(solved.at(peak.number), peak.response, peak.frequency_hz).psd / peak.psd);
    const auto bogie = [&](int number, double f) { return bogie_at(solved.at(number), f); };
    result.push_back(bogie(1, 37.0) / 0.087);
    result.push_back(bogie(2, 37.0) / bogie(1, 37.0) / 0.931);
    result.push_back(bogie(3, 37.0) / bogie(1, 37.0) / 0.908);
    result.push_back(bogie(3, 73.7) / 0.12);
    result.push_back(bogie(2, 73.7) / bogie(3, 73.7) / 0.833);
    result.push_back(bogie(1, 73.7) / bogie(3, 73.7) / 0.370);
    return result;
}

double rms_log(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += std::log(value) * std::log(value);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

class PaperLevels : public testing::TestWithParam<const char*> {};

/// Found 0.4 Hz at most, 0.7 Hz demanded: a thirteenth of the distance of two teeth, 9.26 Hz, so that no other tooth
/// passes. The slope under the comb moves its maxima by as much: the paper's own stand 9.1 and 8.4 Hz apart.
TEST_P(PaperLevels, MaximaAtThePublishedFrequencies) {
    const std::map<int, pem::Solution> solved = solve_cases(GetParam());
    for (const PublishedPeak& peak : published_peaks) {
        const FoundPeak found = highest_near(solved.at(peak.number), peak.response, peak.frequency_hz);
        EXPECT_NEAR(found.frequency_hz, peak.frequency_hz, 0.7) << peak.response << ", case " << peak.number;
        EXPECT_TRUE(found.is_local_maximum) << peak.response << ", case " << peak.number;
    }
}

INSTANTIATE_TEST_SUITE_P(BothVariants, PaperLevels, testing::Values("case3", "case3_consistent"));

/// As published: 8.45 % found, 9 % demanded of an untuned model. docs/paper/hunt.md: what the rest may and may not be.
TEST(PaperLevelsRms, AsPublished) {
    const std::vector<double> found = ratios(solve_cases("case3"));
    ASSERT_EQ(found.size(), 12u);
    EXPECT_LE(rms_log(found), 0.09);
}

/// A simply supported rail of 22.2 m with its modes up to 380 Hz, neither of which the paper excludes: 4.57 % found, 5
/// % is the goal of docs/paper/hunt.md. Its receptances are those of the modal rail, tested in
/// tests/verification/track.
TEST(PaperLevelsRms, ShortTruncatedRail) {
    const std::vector<double> found =
        ratios(solve_cases("case3", {"solver.rail=modal", "solver.pads=37", "solver.modes=19"}));
    EXPECT_LE(rms_log(found), 0.05);
}

/// With Table 2's stiffness in statics and dynamics: all that the paper quotes of the bogie at 37 Hz comes within 2 %
/// (found 1.018, 1.006, 1.002; the paper's digits leave 0.6 %), which tells the two variants apart: as published the
/// third is 0.970.
TEST(PaperLevelsRms, BogieAt37HzPrefersOneRail) {
    const std::vector<double> consistent = ratios(solve_cases("case3_consistent")),
                              published = ratios(solve_cases("case3"));
    for (std::size_t i = 6; i < 9; ++i) EXPECT_NEAR(consistent[i], 1.0, 0.02) << i;
    EXPECT_LT(published[8], 0.98);
}

struct StaticNumbers {
    const char* name;
    double largest_compression_mm;
    double largest_stiffness_kn_per_mm;
};

class PaperStatics : public testing::TestWithParam<StaticNumbers> {};

/// Tolerance: half of the last digit written here. The numbers are those of a dense finite-element solution (tested in
/// tests/verification/track); as published they round to the paper's 3.4 mm, 37.9, 1.8 mm and 19.1 kN/mm.
TEST_P(PaperStatics, ToThreeDigits) {
    const track::StaticEquilibrium found = pem::case_equilibrium(shipped_case(GetParam().name));
    EXPECT_NEAR(1e3 * std::ranges::max(found.compression_m), GetParam().largest_compression_mm, 5e-4);
    EXPECT_NEAR(1e-6 * std::ranges::max(found.static_stiffness_n_per_m), GetParam().largest_stiffness_kn_per_mm, 5e-3);
    EXPECT_NEAR(1e3 * found.unloaded_compression_m, 1.785, 5e-4);
    EXPECT_NEAR(1e-6 * found.unloaded_static_stiffness_n_per_m, 19.13, 5e-3);
}

INSTANTIATE_TEST_SUITE_P(BothVariants, PaperStatics,
                         testing::Values(StaticNumbers{"case3", 3.360, 37.90},
                                         StaticNumbers{"case3_consistent", 2.865, 31.12}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
