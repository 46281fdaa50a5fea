#include "app/tables/level_differences.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/program_version.hpp"
#include "pem/response_names.hpp"
#include "spectra/integrate_psd.hpp"
#include "spectra/third_octaves.hpp"

namespace railpem::app {

using Json = nlohmann::ordered_json;

namespace {

/// Differences of all responses in one band; no value where the lines of a case do not cover it or nothing moves.
std::optional<std::vector<double>> band_differences(const ResponseSpectra& first, const ResponseSpectra& second,
                                                    const spectra::ThirdOctaveBand& band) {
    std::vector<double> differences;
    for (std::size_t response = 0; response < first.psd.size(); ++response) {
        const auto one = spectra::mean_square_between(first.integrated_hz(), first.integrated_psd(response),
                                                      band.low_hz, band.high_hz);
        const auto two = spectra::mean_square_between(second.integrated_hz(), second.integrated_psd(response),
                                                      band.low_hz, band.high_hz);
        if (!one || !two || (*one == 0.0 && *two == 0.0)) return std::nullopt;
        differences.push_back(10.0 * std::log10(*two / *one));
    }
    return differences;
}

std::string column_name(const pem::ResponseName& name) {
    if (name.where == "trackbed") return "trackbed_force_insertion_gain_db";
    return name.where + (name.quantity == pem::Quantity::acceleration ? "_acceleration" : "_force") +
           "_level_difference_db";
}

Json response_summary(const LevelDifferences& speed, std::size_t response) {
    const bool acceleration = pem::response_names()[response].quantity == pem::Quantity::acceleration;
    const char* unit = acceleration ? "_m_per_s2" : "_n";
    Json summary = {{std::string("rms_1") + unit, speed.rms_1[response]},
                    {std::string("rms_2") + unit, speed.rms_2[response]},
                    {"rms_difference_db", 20.0 * std::log10(speed.rms_2[response] / speed.rms_1[response])}};
    const std::vector<double>& differences = speed.difference_db[response];
    if (differences.empty()) return summary;
    const auto largest = std::max_element(differences.begin(), differences.end(),
                                          [](double a, double b) { return std::abs(a) < std::abs(b); });
    summary["largest_difference_db"] = *largest;
    summary["largest_difference_centre_hz"] = speed.centre_hz[static_cast<std::size_t>(largest - differences.begin())];
    return summary;
}

Json speed_summary(const LevelDifferences& speed) {
    Json accelerations = Json::object(), forces = Json::object();
    for (std::size_t response = 0; response < speed.difference_db.size(); ++response) {
        const pem::ResponseName& name = pem::response_names()[response];
        (name.quantity == pem::Quantity::acceleration ? accelerations : forces)[name.where] =
            response_summary(speed, response);
    }
    return {{"speed_1_m_per_s", speed.speed_1_m_per_s},
            {"speed_2_m_per_s", speed.speed_2_m_per_s},
            {"acceleration", std::move(accelerations)},
            {"force", std::move(forces)},
            {"warnings", speed.warnings}};
}

}  // namespace

LevelDifferences level_differences(const ResponseSpectra& first, const ResponseSpectra& second) {
    LevelDifferences result{.speed_1_m_per_s = first.speed_m_per_s, .speed_2_m_per_s = second.speed_m_per_s};
    result.difference_db.resize(first.psd.size());
    for (const std::string& warning : first.warnings) result.warnings.push_back("case 1: " + warning);
    for (const std::string& warning : second.warnings) result.warnings.push_back("case 2: " + warning);
    for (std::size_t response = 0; response < first.psd.size(); ++response) {
        result.rms_1.push_back(spectra::root_mean_square(first.integrated_hz(), first.integrated_psd(response)));
        result.rms_2.push_back(spectra::root_mean_square(second.integrated_hz(), second.integrated_psd(response)));
    }
    for (const spectra::ThirdOctaveBand& band :
         spectra::third_octave_bands(first.frequency_hz.front(), first.frequency_hz.back())) {
        const auto differences = band_differences(first, second, band);
        if (!differences) continue;
        result.centre_hz.push_back(band.nominal_hz);
        for (std::size_t response = 0; response < differences->size(); ++response)
            result.difference_db[response].push_back((*differences)[response]);
    }
    return result;
}

NumberTable difference_table(const std::vector<LevelDifferences>& speeds) {
    const bool several = speeds.size() > 1;
    NumberTable table;
    if (several) table.names.push_back("speed_m_per_s");
    table.names.push_back("centre_hz");
    for (const pem::ResponseName& name : pem::response_names()) table.names.push_back(column_name(name));
    table.columns.resize(table.names.size());
    for (const LevelDifferences& speed : speeds) {
        auto column = table.columns.begin();
        const auto append = [&](const std::vector<double>& values) {
            column->insert(column->end(), values.begin(), values.end());
            ++column;
        };
        if (several) append(std::vector<double>(speed.centre_hz.size(), speed.speed_1_m_per_s));
        append(speed.centre_hz);
        for (const std::vector<double>& differences : speed.difference_db) append(differences);
    }
    return table;
}

std::string difference_summary_text(const std::string& case_1, const std::string& case_2,
                                    const std::vector<LevelDifferences>& speeds) {
    Json summary = {{"case_1", case_1},
                    {"case_2", case_2},
                    {"railpem_version", program_version()},
                    {"sign", "positive where case_2 has more"},
                    {"speeds", Json::array()}};
    for (const LevelDifferences& speed : speeds) summary["speeds"].push_back(speed_summary(speed));
    return summary.dump(2) + "\n";
}

}  // namespace railpem::app
