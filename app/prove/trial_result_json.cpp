#include <limits>

#include "app/input_error.hpp"
#include "app/prove/trial_result.hpp"
#include "app/tables/json_values.hpp"

namespace railpem::app {

namespace {

double number_of(const Json& json, const char* name) {
    const Json& value = json.at(name);
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

Json effect_json(const ClaimedEffect& claimed) {
    Json parameters = Json::object();
    for (const diagnosis::FittedParameter& p : claimed.parameters)
        parameters[p.name] = {
            {"value", or_null(p.value)}, {"low", or_null(p.low)}, {"high", or_null(p.high)}, {"unit", p.unit}};
    return {{"effect", claimed.effect},
            {"choices", claimed.choices},
            {"element", claimed.element},
            {"probability", or_null(claimed.probability)},
            {"parameters", parameters}};
}

ClaimedEffect effect_of(const Json& json) {
    ClaimedEffect claimed{.effect = json.at("effect"),
                          .choices = json.at("choices"),
                          .element = json.at("element"),
                          .probability = number_of(json, "probability")};
    for (const auto& [name, value] : json.at("parameters").items())
        claimed.parameters.push_back(
            {name, number_of(value, "value"), number_of(value, "low"), number_of(value, "high"), value.at("unit")});
    return claimed;
}

diagnosis::FitFigures figures_of(const Json& json) {
    return {number_of(json, "rms_db"), number_of(json, "log_likelihood_per_second")};
}

TrialResult result_of(const Json& json) {
    TrialResult result{.trial = json.at("trial"), .failure = json.at("failure"), .verdict = json.at("verdict")};
    for (const Json& item : json.at("omitted")) result.omitted.push_back(effect_of(item));
    for (const Json& item : json.at("rivals")) {
        result.rivals.push_back({.probability = number_of(item, "probability")});
        for (const Json& effect : item.at("effects")) result.rivals.back().effects.push_back(effect_of(effect));
    }
    for (const Json& item : json.at("posterior"))
        result.posterior.push_back({item.at("effects"), number_of(item, "probability")});
    for (const Json& item : json.at("places"))
        result.places.emplace_back(item.at("element"), number_of(item, "probability"));
    const Json& fit = json.at("fit");
    result.before = figures_of(fit.at("before"));
    result.retuned = figures_of(fit.at("retuned"));
    result.after = figures_of(fit.at("after"));
    result.held_out_before = figures_of(fit.at("held_out_before"));
    result.held_out_retuned = figures_of(fit.at("held_out_retuned"));
    result.held_out_after = figures_of(fit.at("held_out_after"));
    result.hidden_by_retuning = number_of(json, "hidden_by_retuning");
    result.retuned_outside = json.at("retuned_outside").get<std::vector<std::string>>();
    for (const Json& item : json.at("numbers"))
        result.numbers.push_back(
            {item.at("key"), number_of(item, "value"), number_of(item, "low"), number_of(item, "high")});
    result.bic_gain = number_of(json, "bic_gain");
    result.seconds_simulated = number_of(json, "seconds_simulated");
    result.seconds_diagnosed = number_of(json, "seconds_diagnosed");
    result.program = json.at("program");
    return result;
}

}  // namespace

std::string trial_result_text(const TrialResult& result, const std::string& label) {
    const auto set = [](const ClaimedSet& s) -> Json {
        return {{"effects", array_of(s.effects, effect_json)}, {"probability", or_null(s.probability)}};
    };
    const auto probable = [](const diagnosis::EffectSet& s) -> Json {
        return {{"effects", s.effects}, {"probability", or_null(s.probability)}};
    };
    const auto place = [](const auto& p) -> Json { return {{"element", p.first}, {"probability", or_null(p.second)}}; };
    const auto value = [](const ClaimedNumber& n) -> Json {
        return {{"key", n.key}, {"value", or_null(n.value)}, {"low", or_null(n.low)}, {"high", or_null(n.high)}};
    };
    const Json fit{{"before", figures_json(result.before)},
                   {"retuned", figures_json(result.retuned)},
                   {"after", figures_json(result.after)},
                   {"held_out_before", figures_json(result.held_out_before)},
                   {"held_out_retuned", figures_json(result.held_out_retuned)},
                   {"held_out_after", figures_json(result.held_out_after)}};
    const Json json{{"trial", result.trial},
                    {"hidden", Json::parse(label)},
                    {"failure", result.failure},
                    {"verdict", result.verdict},
                    {"omitted", array_of(result.omitted, effect_json)},
                    {"rivals", array_of(result.rivals, set)},
                    {"posterior", array_of(result.posterior, probable)},
                    {"places", array_of(result.places, place)},
                    {"fit", fit},
                    {"hidden_by_retuning", or_null(result.hidden_by_retuning)},
                    {"retuned_outside", result.retuned_outside},
                    {"numbers", array_of(result.numbers, value)},
                    {"bic_gain", or_null(result.bic_gain)},
                    {"seconds_simulated", or_null(result.seconds_simulated)},
                    {"seconds_diagnosed", or_null(result.seconds_diagnosed)},
                    {"program", result.program}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

TrialResult read_trial_result(const std::string& name, const std::string& text) {
    try {
        return result_of(Json::parse(text));
    } catch (const Json::exception& error) {
        throw InputError(name + ": is no result of a trial: " + error.what() +
                         "\nallowed: a file that railpem prove wrote; delete it to run the trial again");
    }
}

}  // namespace railpem::app
