#include "app/tables/truth_file.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/program_version.hpp"
#include "app/schema/case_file.hpp"

namespace railpem::app {

using nlohmann::ordered_json;

std::string truth_text(const Truth& truth, const simulate::Recording& recording) {
    const simulate::Options& options = truth.options;
    ordered_json effects = ordered_json::array();
    for (const simulate::Hidden& hidden : truth.hidden)
        effects.push_back(ordered_json::parse(simulate::hidden_json(hidden)));
    const auto is_forced = [](const simulate::Hidden& hidden) { return hidden.forced; };
    ordered_json json{{"case", truth.case_path},
                      {"set", truth.set_options},
                      {"seed", options.seed},
                      {"effects", effects},
                      {"forced", std::any_of(truth.hidden.begin(), truth.hidden.end(), is_forced)},
                      {"seconds", options.seconds},
                      {"sampling_rate_hz", recording.sampling_rate_hz},
                      {"speed_m_per_s", recording.speed_m_per_s},
                      {"speed_fluctuation", options.speed_fluctuation},
                      {"wheels", options.mode == simulate::Mode::moving ? "moving" : "standing"},
                      {"noise_rms_m_per_s2", options.noise_rms_m_per_s2}};
    if (options.profile_seed) json["profile_seed"] = *options.profile_seed;
    const simulate::Making& making = recording.making;
    json["making"] = {{"step_s", making.step_s},
                      {"profile_rms_m", making.profile_rms_m},
                      {"profile_length_m", making.profile_length_m},
                      {"shortest_wavelength_m", making.shortest_wavelength_m},
                      {"relaxation_chain_error", making.chain_error},
                      {"contact_lost_share", making.contact_lost_share}};
    json["program"] = "railpem " + program_version();
    json["true_case"] = write_case(truth.parameters);
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace railpem::app
