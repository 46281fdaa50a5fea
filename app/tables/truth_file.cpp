#include "app/tables/truth_file.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/program_version.hpp"
#include "app/schema/case_file.hpp"
#include "simulate/world_grades.hpp"

namespace railpem::app {

using nlohmann::ordered_json;

namespace {

ordered_json drawn_json(const simulate::WorldDraws& draws) {
    ordered_json json = ordered_json::object();
    if (draws.rough_to_m > draws.rough_from_m) json["rough_stretch_m"] = {draws.rough_from_m, draws.rough_to_m};
    for (const simulate::Dip& dip : draws.dips)
        json["dips"].push_back({{"position_m", dip.position_m}, {"depth_m", dip.depth_m}, {"length_m", dip.length_m}});
    for (std::size_t c = 0; c < draws.channels.size(); ++c)
        json["channels"].push_back({{"channel", simulate::channel_names()[c]},
                                    {"gain", draws.channels[c].gain},
                                    {"drift", draws.channels[c].drift}});
    if (!draws.tone_channel.empty()) json["tone_channel"] = draws.tone_channel;
    if (!draws.pad_stiffness.empty())
        json["seats"] = {{"first", draws.first_seat},
                         {"pad_stiffness", draws.pad_stiffness},
                         {"support_stiffness", draws.support_stiffness}};
    return json;
}

/// The grade, every number of it, the speed as it was, and what was drawn.
ordered_json world_json(const Truth& truth, const simulate::WorldDraws& draws) {
    ordered_json parameters = ordered_json::object();
    for (const simulate::WorldKey& key : simulate::world_keys()) parameters[key.name] = truth.options.world.*key.member;
    return {{"grade", truth.world},
            {"parameters", parameters},
            {"speed_m_per_s",
             {{"mean", draws.mean_speed_m_per_s},
              {"least", draws.least_speed_m_per_s},
              {"most", draws.most_speed_m_per_s},
              {"rms", draws.speed_rms_m_per_s}}},
            {"drawn", drawn_json(draws)}};
}

}  // namespace

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
    json["world"] = world_json(truth, making.draws);
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
