#include "app/prove/trial_truth.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/prove/effect_draws.hpp"
#include "app/schema/case_file.hpp"
#include "effects/catalogue.hpp"

namespace railpem::app {

namespace {

std::string place_of(const simulate::Hidden& hidden) {
    const effects::EffectDescription& effect = *effects::find_description(hidden.id);
    if (effect.wrong_number) return element_name(diagnosis::element_of_key(hidden.values.texts.at("parameter")));
    for (const effects::EffectChoice& choice : effect.choices)
        if (choice.is_element) return hidden.values.texts.at(choice.name);
    return place_text(effect);
}

}  // namespace

nlohmann::ordered_json world_json(const World& world) {
    nlohmann::ordered_json parameters = nlohmann::ordered_json::object();
    for (const simulate::WorldKey& key : simulate::world_keys()) parameters[key.name] = world.parameters.*key.member;
    return {{"grade", world.name()}, {"parameters", parameters}};
}

std::string kind_name(TrialKind kind) {
    switch (kind) {
        case TrialKind::nothing:
            return "nothing";
        case TrialKind::single:
            return "single";
        case TrialKind::pair:
            return "pair";
        case TrialKind::sensor:
            return "sensor";
        case TrialKind::parameter_error:
            return effects::wrong_number_id();
        case TrialKind::outside:
            return "outside";
    }
    return {};
}

std::vector<std::string> true_places(const TrialTruth& truth) {
    std::vector<std::string> places;
    for (const simulate::Hidden& hidden : truth.hidden) {
        const std::string place = place_of(hidden);
        if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
    }
    return places;
}

double true_strength(const TrialTruth& truth) {
    if (truth.hidden.size() != 1) return NAN;
    const simulate::Hidden& hidden = truth.hidden.front();
    const EffectDraw* draw = find_draw(hidden.id);
    if (!draw || draw->strength.empty() || !hidden.values.numbers.count(draw->strength)) return NAN;
    return hidden.values.numbers.at(draw->strength);
}

double true_value(const TrialTruth& truth, const std::string& effect, const std::string& key,
                  const std::string& parameter) {
    for (const simulate::Hidden& hidden : truth.hidden) {
        if (hidden.id != effect) continue;
        if (effect == effects::wrong_number_id()) {
            if (hidden.values.texts.at("parameter") != key) continue;
            for (const TrueNumber& number : truth.numbers)
                if (number.key == key) return number.truth / number.believed;
        }
        const auto found = hidden.values.numbers.find(parameter);
        if (found == hidden.values.numbers.end()) continue;
        return parameter == "level_db" ? found->second + truth.level_db : found->second;
    }
    return NAN;
}

std::string trial_truth_text(const TrialTruth& truth) {
    using nlohmann::ordered_json;
    ordered_json effects = ordered_json::array(), numbers = ordered_json::array(), records = ordered_json::array();
    for (const simulate::Hidden& hidden : truth.hidden)
        effects.push_back(ordered_json::parse(simulate::hidden_json(hidden)));
    for (const TrueNumber& number : truth.numbers)
        numbers.push_back({{"key", number.key}, {"believed", number.believed}, {"true", number.truth}});
    for (const TrialRecord& record : truth.records)
        records.push_back({{"speed_m_per_s", record.speed_m_per_s},
                           {"stated_speed_m_per_s", record.stated_speed_m_per_s},
                           {"payload_kg", record.payload_kg},
                           {"seed", record.seed}});
    ordered_json json{{"trial", truth.trial},
                      {"kind", kind_name(truth.kind)},
                      {"effects", effects},
                      {"places", true_places(truth)},
                      {"irregularity_level_db", truth.level_db},
                      {"noise_rms_m_per_s2", truth.noise_rms_m_per_s2},
                      {"seconds", truth.seconds},
                      {"records", records},
                      {"numbers", numbers},
                      {"true_case", write_case(truth.parameters)}};
    if (!truth.world.is_ideal()) json["world"] = world_json(truth.world);
    return json.dump(2) + "\n";
}

}  // namespace railpem::app
