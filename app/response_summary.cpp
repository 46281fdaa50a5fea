#include "app/response_summary.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/program_version.hpp"
#include "spectra/comfort.hpp"
#include "spectra/integrate_psd.hpp"

namespace railpem::app {

using Json = nlohmann::ordered_json;

namespace {

Json response_summary(const ResponseSpectra& speed, std::size_t response) {
    const std::vector<double>& psd = speed.psd[response];
    const std::size_t peak = static_cast<std::size_t>(std::max_element(psd.begin(), psd.end()) - psd.begin());
    const bool acceleration = pem::response_names()[response].quantity == pem::Quantity::acceleration;
    return {{acceleration ? "rms_m_per_s2" : "rms_n", spectra::root_mean_square(speed.frequency_hz, psd)},
            {acceleration ? "peak_psd_m2_per_s4_per_hz" : "peak_psd_n2_per_hz", psd[peak]},
            {"peak_frequency_hz", speed.frequency_hz[peak]}};
}

/// Ride comfort where people sit; null where the frequency lines do not cover what the standard asks for.
Json comfort_summary(const ResponseSpectra& speed) {
    Json comfort = Json::object();
    for (const char* where : {"body", "body_front", "body_rear"}) {
        const std::optional<double> weighted =
            spectra::weighted_rms_iso2631(speed.frequency_hz, speed.psd[pem::response_index(where)]);
        comfort[where] = {{"weighted_rms_iso2631_m_per_s2", weighted ? Json(*weighted) : Json(nullptr)}};
    }
    return comfort;
}

Json speed_summary(const ResponseSpectra& speed) {
    Json accelerations = Json::object(), forces = Json::object();
    for (std::size_t response = 0; response < speed.psd.size(); ++response) {
        const pem::ResponseName& name = pem::response_names()[response];
        (name.quantity == pem::Quantity::acceleration ? accelerations : forces)[name.where] =
            response_summary(speed, response);
    }
    return {{"speed_m_per_s", speed.speed_m_per_s},
            {"acceleration", std::move(accelerations)},
            {"force", std::move(forces)},
            {"comfort", comfort_summary(speed)},
            {"warnings", speed.warnings}};
}

}  // namespace

std::string summary_text(const std::string& case_name, const pem::CaseParameters& parameters,
                         const std::vector<ResponseSpectra>& speeds) {
    const std::vector<double>& lines = speeds.front().frequency_hz;
    Json summary = {{"case", case_name},
                    {"title", parameters.title},
                    {"railpem_version", program_version()},
                    {"wheel_load_n", pem::wheel_load_n(parameters)},
                    {"frequency",
                     {{"from_hz", lines.front()},
                      {"to_hz", lines.back()},
                      {"step_hz", parameters.frequency.step_hz},
                      {"lines", lines.size()}}},
                    {"speeds", Json::array()}};
    for (const ResponseSpectra& speed : speeds) summary["speeds"].push_back(speed_summary(speed));
    return summary.dump(2) + "\n";
}

}  // namespace railpem::app
