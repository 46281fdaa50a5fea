#include "app/tables/response_summary.hpp"

#include <algorithm>
#include <cmath>

#include "app/program_version.hpp"
#include "app/tables/json_values.hpp"
#include "pem/response_names.hpp"
#include "spectra/comfort.hpp"
#include "spectra/integrate_psd.hpp"
#include "spectra/irregularity_spectrum.hpp"

namespace railpem::app {

namespace {

Json response_summary(const ResponseSpectra& speed, std::size_t response) {
    const std::vector<double>& psd = speed.psd[response];
    const std::size_t peak = static_cast<std::size_t>(std::max_element(psd.begin(), psd.end()) - psd.begin());
    const bool acceleration = pem::response_names()[response].quantity == pem::Quantity::acceleration;
    return {{acceleration ? "rms_m_per_s2" : "rms_n", spectra::root_mean_square(speed.frequency_hz, psd)},
            {acceleration ? "peak_psd_m2_per_s4_per_hz" : "peak_psd_n2_per_hz", psd[peak]},
            {"peak_frequency_hz", speed.frequency_hz[peak]}};
}

/// What the wheels met: the broadband spectrum over the frequency lines, and the wavelengths that these lines are.
Json irregularity_summary(const pem::CaseParameters& parameters, const ResponseSpectra& speed) {
    std::vector<double> psd;
    for (const double f : speed.frequency_hz)
        psd.push_back(spectra::irregularity_psd_m2_per_hz(parameters.irregularity, f, speed.speed_m_per_s));
    return {{"rms_m", spectra::root_mean_square(speed.frequency_hz, psd)},
            {"shortest_wavelength_m", speed.speed_m_per_s / speed.frequency_hz.back()},
            {"longest_wavelength_m", speed.speed_m_per_s / speed.frequency_hz.front()}};
}

/// Ride comfort where people sit; null where the frequency lines do not cover what the standard asks for.
Json comfort_summary(const ResponseSpectra& speed) {
    Json comfort = Json::object();
    for (const char* where : {"body", "body_front", "body_rear"}) {
        const std::vector<double>& psd = speed.psd[pem::response_index(where)];
        const auto weighted = spectra::weighted_rms_iso2631(speed.frequency_hz, psd);
        const auto vertical = spectra::vertical_comfort_en12299(speed.frequency_hz, psd);
        const auto sperling = spectra::sperling_index_vertical(speed.frequency_hz, psd);
        comfort[where] = {
            {"weighted_rms_iso2631_m_per_s2", or_null(weighted)},
            {"weighted_rms_en12299_m_per_s2", vertical ? Json(vertical->weighted_rms_m_per_s2) : Json(nullptr)},
            {"percentile_95_en12299_m_per_s2", vertical ? Json(vertical->percentile_95_m_per_s2) : Json(nullptr)},
            {"mean_comfort_en12299", vertical ? Json(vertical->mean_comfort) : Json(nullptr)},
            {"sperling_index", or_null(sperling)}};
    }
    return comfort;
}

Json speed_summary(const pem::CaseParameters& parameters, const ResponseSpectra& speed) {
    Json accelerations = Json::object(), forces = Json::object();
    for (std::size_t response = 0; response < speed.psd.size(); ++response) {
        const pem::ResponseName& name = pem::response_names()[response];
        (name.quantity == pem::Quantity::acceleration ? accelerations : forces)[name.where] =
            response_summary(speed, response);
    }
    return {{"speed_m_per_s", speed.speed_m_per_s},     {"irregularity", irregularity_summary(parameters, speed)},
            {"acceleration", std::move(accelerations)}, {"force", std::move(forces)},
            {"comfort", comfort_summary(speed)},        {"warnings", speed.warnings}};
}

}  // namespace

std::string summary_text(const std::string& case_name, const pem::CaseParameters& parameters,
                         const std::vector<ResponseSpectra>& speeds) {
    const std::vector<double>& lines = speeds.front().frequency_hz;
    Json summary = {{"case", case_name},
                    {"title", parameters.title},
                    {"railpem_version", program_version()},
                    {"payload_kg", parameters.vehicle.payload_kg},
                    {"wheel_load_n", pem::wheel_load_n(parameters)},
                    {"frequency",
                     {{"from_hz", lines.front()},
                      {"to_hz", lines.back()},
                      {"step_hz", parameters.frequency.step_hz},
                      {"lines", lines.size()}}},
                    {"speeds", Json::array()}};
    for (const ResponseSpectra& speed : speeds) summary["speeds"].push_back(speed_summary(parameters, speed));
    return summary.dump(2) + "\n";
}

}  // namespace railpem::app
