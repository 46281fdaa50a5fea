#include "app/tables/response_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plausibility/excited_band.hpp"
#include "app/plausibility/implausible_case.hpp"
#include "app/program_version.hpp"
#include "app/tables/json_values.hpp"
#include "pem/response_names.hpp"
#include "spectra/comfort.hpp"
#include "spectra/integrate_psd.hpp"

namespace railpem::app {

namespace {

Json response_summary(const ResponseSpectra& speed, std::size_t response) {
    const std::vector<double>&f = speed.integrated_hz(), &psd = speed.integrated_psd(response);
    const std::size_t peak = static_cast<std::size_t>(std::max_element(psd.begin(), psd.end()) - psd.begin());
    const bool acceleration = pem::response_names()[response].quantity == pem::Quantity::acceleration;
    return {{acceleration ? "rms_m_per_s2" : "rms_n", spectra::root_mean_square(f, psd)},
            {acceleration ? "peak_psd_m2_per_s4_per_hz" : "peak_psd_n2_per_hz", psd[peak]},
            {"peak_frequency_hz", psd[peak] > 0.0 ? Json(f[peak]) : Json(nullptr)}};
}

/// What the wheels met: the broadband spectrum over the frequency lines, the wavelengths that these lines are, and the
/// frequencies between which there is any of it.
Json irregularity_summary(const pem::CaseParameters& parameters, const ResponseSpectra& speed) {
    const ExcitedBand excited =
        excited_band(parameters, speed.speed_m_per_s, speed.frequency_hz.front(), speed.frequency_hz.back());
    return {{"rms_m", excited.rms_m},
            {"shortest_wavelength_m", speed.speed_m_per_s / speed.frequency_hz.back()},
            {"longest_wavelength_m", speed.speed_m_per_s / speed.frequency_hz.front()},
            {"excited_from_hz", or_null(excited.from_hz)},
            {"excited_to_hz", or_null(excited.to_hz)}};
}

/// Whether the lines show what is there.
Json resolution_summary(const pem::LineJudgement& judgement) {
    Json resonances = array_of(judgement.resonances, [](const pem::Resonance& resonance) {
        return Json{{"motion", resonance.name},
                    {"frequency_hz", resonance.frequency_hz},
                    {"damping_ratio", resonance.damping_ratio}};
    });
    Json json = {{"integrated_lines", judgement.integrated_lines}, {"converged", judgement.converged}};
    if (judgement.narrowest)
        json["narrowest_peak"] = {{"name", judgement.narrowest->name},
                                  {"frequency_hz", judgement.narrowest->frequency_hz},
                                  {"width_hz", judgement.narrowest->width_hz}};
    json["resonances"] = std::move(resonances);
    return json;
}

/// Ride comfort where people sit; null where the frequency lines do not cover what the standard asks for.
Json comfort_summary(const ResponseSpectra& speed) {
    Json comfort = Json::object();
    for (const char* where : {"body", "body_front", "body_rear"}) {
        const std::vector<double>&f = speed.integrated_hz(), &psd = speed.integrated_psd(pem::response_index(where));
        const auto weighted = spectra::weighted_rms_iso2631(f, psd);
        const auto vertical = spectra::vertical_comfort_en12299(f, psd);
        const auto sperling = spectra::sperling_index_vertical(f, psd);
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
    return {{"speed_m_per_s", speed.speed_m_per_s},
            {"irregularity", irregularity_summary(parameters, speed)},
            {"acceleration", std::move(accelerations)},
            {"force", std::move(forces)},
            {"comfort", comfort_summary(speed)},
            {"resolution", resolution_summary(speed.judgement)},
            {"warnings", speed.warnings}};
}

}  // namespace

namespace {

/// The largest rms of responses whose names begin so.
double largest_rms(const ResponseSpectra& speed, const std::string& beginning) {
    double largest = 0.0;
    for (std::size_t response = 0; response < speed.psd.size(); ++response)
        if (pem::response_names()[response].where.starts_with(beginning))
            largest =
                std::max(largest, spectra::root_mean_square(speed.integrated_hz(), speed.integrated_psd(response)));
    return largest;
}

}  // namespace

std::vector<std::string> response_warnings(const CaseFile& file, const std::vector<ResponseSpectra>& speeds) {
    std::vector<std::string> warnings;
    for (const ResponseSpectra& speed : speeds)
        for (const auto& [name, where] :
             {std::pair("rms acceleration of the wheels", "wheel_"), std::pair("rms acceleration of the body", "body")})
            for (const Implausible& own :
                 implausible_figure(name, largest_rms(speed, where), "m/s^2", "an irregularity in another unit?"))
                warnings.push_back(
                    fmt::format("{}: at {:g} m/s: {}", file.document.name, speed.speed_m_per_s, own.says));
    return warnings;
}

std::string levels_text(const std::vector<ResponseSpectra>& speeds) {
    std::string text;
    for (const ResponseSpectra& speed : speeds)
        text += fmt::format("  at {:.3g} m/s rms {:.3g} m/s^2 (wheels), {:.3g} (bogies), {:.3g} (body), at most\n",
                            speed.speed_m_per_s, largest_rms(speed, "wheel_"), largest_rms(speed, "bogie_"),
                            largest_rms(speed, "body"));
    return text;
}

std::string summary_text(const CaseFile& file, const std::vector<std::string>& doubts,
                         const std::vector<ResponseSpectra>& speeds) {
    const pem::CaseParameters& parameters = file.parameters;
    const std::vector<double>& lines = speeds.front().frequency_hz;
    Json summary = {
        {"case", file.name},
        {"title", parameters.title},
        {"railpem_version", program_version()},
        {"payload_kg", parameters.vehicle.payload_kg},
        {"wheel_load_n", pem::wheel_load_n(parameters)},
        {"frequency",
         {{"from_hz", lines.front()},
          {"to_hz", lines.back()},
          {"step_hz", parameters.frequency.step_hz > 0.0 ? Json(parameters.frequency.step_hz) : Json(nullptr)},
          {"lines", lines.size()}}},
        {"warnings", doubts},
        {"speeds", Json::array()}};
    for (const ResponseSpectra& speed : speeds) summary["speeds"].push_back(speed_summary(parameters, speed));
    return summary.dump(2) + "\n";
}

}  // namespace railpem::app
