#include "app/tables/diagnosis_json.hpp"

#include <algorithm>
#include <cctype>

#include "app/tables/json_values.hpp"

namespace railpem::app {
namespace {

using diagnosis::Diagnosis;

Json numbers_json(const std::vector<double>& values) {
    Json array = Json::array();
    for (const double value : values) array.push_back(or_null(value));
    return array;
}

/// A choice as the catalogue takes it: wheels and orders are numbers, channels and keys are texts.
Json choice_json(const std::string& text) {
    const bool digits = !text.empty() && text.size() < 10 &&
                        std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    return {{"value", digits ? Json(std::stoi(text)) : Json(text)}};
}

Json parameters_json(const diagnosis::NamedEffect& effect) {
    Json parameters = Json::object();
    for (const auto& [name, text] : effect.instance.choices) parameters[name] = choice_json(text);
    for (const diagnosis::FittedParameter& fitted : effect.parameters) {
        Json& own = parameters[fitted.name];
        own = {{"value", or_null(fitted.value)},
               {"low", or_null(fitted.low)},
               {"high", or_null(fitted.high)},
               {"unit", fitted.unit}};
        if (fitted.by_recording.empty()) continue;
        own["nats_against_one_value"] = or_null(fitted.nats_against_one_value);
        for (const diagnosis::RecordedValue& value : fitted.by_recording)
            own["by_recording"].push_back({{"recording", value.recording}, {"value", or_null(value.value)}});
    }
    return parameters;
}

Json omitted_json(const Diagnosis& diagnosis) {
    Json omitted = Json::array();
    if (diagnosis.verdict == diagnosis::Verdict::consistent || diagnosis.verdict == diagnosis::Verdict::ambiguous)
        return omitted;
    for (const diagnosis::NamedEffect& effect : diagnosis.omitted)
        omitted.push_back({{"effect", effect.instance.effect},
                           {"probability", or_null(effect.probability)},
                           {"says", effect.says},
                           {"parameters", parameters_json(effect)},
                           {"source", effect.source},
                           {"element", element_name(effect.element)},
                           {"nats_fitted", or_null(effect.nats_fitted)},
                           {"nats_held_out", or_null(effect.nats_held_out)}});
    return omitted;
}

Json rival_json(const diagnosis::Rival& rival) {
    Json instances = Json::array();
    for (const diagnosis::EffectInstance& instance : rival.instances) {
        Json parameters = Json::object();
        for (const auto& [name, text] : instance.choices) parameters[name] = choice_json(text);
        for (const auto& [name, value] : instance.values) parameters[name] = {{"value", or_null(value)}};
        instances.push_back({{"effect", instance.effect}, {"parameters", parameters}});
    }
    return {{"effects", rival.effects},
            {"probability", or_null(rival.probability)},
            {"why_not", rival.why_not},
            {"would_separate", rival.would_separate},
            {"nats_behind", or_null(rival.nats_behind)},
            {"nats_held_out", or_null(rival.nats_held_out)},
            {"instances", instances}};
}

Json mismatch_json(const diagnosis::Mismatch& mismatch) {
    Json json = {{"channel", mismatch.channel},
                 {"low_hz", or_null(mismatch.low_hz)},
                 {"high_hz", or_null(mismatch.high_hz)},
                 {"level_db", or_null(mismatch.level_db)},
                 {"false_alarm_probability", or_null(mismatch.false_alarm_probability)},
                 {"element", element_name(mismatch.element)},
                 {"recording", mismatch.recording}};
    if (!mismatch.other_channel.empty()) json["other_channel"] = mismatch.other_channel;
    return json;
}

Json fit_json(const Diagnosis& diagnosis) {
    Json json = {{"before", figures_json(diagnosis.before)},
                 {"retuned", figures_json(diagnosis.retuned)},
                 {"after", figures_json(diagnosis.after)},
                 {"held_out_before", figures_json(diagnosis.held_out_before)},
                 {"held_out_retuned", figures_json(diagnosis.held_out_retuned)},
                 {"held_out_after", figures_json(diagnosis.held_out_after)}};
    if (diagnosis.freely_retuned) {
        json["freely_retuned"] = figures_json(diagnosis.freely_retuned->fitted);
        json["held_out_freely_retuned"] = figures_json(diagnosis.freely_retuned->held_out);
    }
    return json;
}

Json recording_json(const diagnosis::UsedRecording& used) {
    return {{"name", used.name},
            {"speed_m_per_s", or_null(used.speed_m_per_s)},
            {"speed_low_m_per_s", or_null(used.speed_low)},
            {"speed_high_m_per_s", or_null(used.speed_high)},
            {"speed",
             {{"mean_m_per_s", or_null(used.speed_m_per_s)},
              {"lowest_m_per_s", or_null(used.observed_speed.lowest_m_per_s)},
              {"highest_m_per_s", or_null(used.observed_speed.highest_m_per_s)},
              {"read_from", used.observed_speed.read_from}}},
            {"stated_speed_m_per_s", or_null(used.stated_speed_m_per_s)},
            {"payload_kg", or_null(used.payload_kg)},
            {"seconds", or_null(used.seconds)},
            {"held_out_seconds", or_null(used.held_out_seconds)},
            {"low_hz", or_null(used.low_hz)},
            {"high_hz", or_null(used.high_hz)},
            {"window_s", or_null(used.window_s)},
            {"averages", or_null(used.averages)},
            {"channels", used.channels},
            {"channels_not_used", used.channels_not_used},
            {"faults", used.faults},
            {"irregularity_measured", used.irregularity_measured}};
}

Json tuned_json(const std::vector<diagnosis::RetunedNumber>& tuned) {
    Json array = Json::array();
    for (const diagnosis::RetunedNumber& n : tuned)
        array.push_back({{"key", n.key},
                         {"unit", n.unit},
                         {"believed", or_null(n.believed)},
                         {"value", or_null(n.value)},
                         {"low", or_null(n.low)},
                         {"high", or_null(n.high)},
                         {"tolerance", or_null(n.tolerance)},
                         {"tolerances_away", or_null(n.tolerances_away)},
                         {"outside", n.outside}});
    return array;
}

Json complex_json(const std::vector<std::complex<double>>& values) {
    Json real = Json::array(), imaginary = Json::array();
    for (const std::complex<double>& value : values) {
        real.push_back(or_null(value.real()));
        imaginary.push_back(or_null(value.imag()));
    }
    return {{"real", real}, {"imaginary", imaginary}};
}

Json curve_json(const diagnosis::InferredCurve& curve) {
    return {{"element", element_name(curve.element)},
            {"unit", curve.unit},
            {"frequency_hz", numbers_json(curve.frequency_hz)},
            {"value", complex_json(curve.value)},
            {"real_low", numbers_json(curve.real_low)},
            {"real_high", numbers_json(curve.real_high)},
            {"imaginary_low", numbers_json(curve.imaginary_low)},
            {"imaginary_high", numbers_json(curve.imaginary_high)},
            {"retuned", complex_json(curve.retuned)},
            {"diagnosed", complex_json(curve.diagnosed)}};
}

Json imperfection_json(const diagnosis::Imperfection& own) {
    Json json = {{"where", own.where}};
    if (!own.channel.empty()) json["channel"] = own.channel;
    json["share_of_power"] = or_null(own.share_of_power);
    json["low"] = or_null(own.low);
    json["high"] = or_null(own.high);
    json["says"] = own.says;
    return json;
}

}  // namespace

std::string diagnosis_json(const Diagnosis& diagnosis, const std::vector<std::string>& doubts) {
    const auto set = [](const diagnosis::EffectSet& s) -> Json {
        return {{"effects", s.effects}, {"probability", or_null(s.probability)}};
    };
    const auto place = [](const diagnosis::PlaceEvidence& p) -> Json {
        return {
            {"element", element_name(p.element)}, {"probability", or_null(p.probability)}, {"nats", or_null(p.nats)}};
    };
    Json json;
    json["verdict"] = verdict_name(diagnosis.verdict);
    json["statement"] = diagnosis.statement;
    json["omitted"] = omitted_json(diagnosis);
    json["posterior"] = array_of(diagnosis.posterior, set);
    json["rivals"] = array_of(diagnosis.rivals, rival_json);
    json["places"] = array_of(diagnosis.places, place);
    json["mismatch"] = array_of(diagnosis.mismatch, mismatch_json);
    json["fit"] = fit_json(diagnosis);
    json["hidden_by_retuning"] = or_null(diagnosis.hidden_by_retuning);
    json["imperfection"] = array_of(diagnosis.imperfections, imperfection_json);
    json["interrupted"] = diagnosis.interrupted;
    json["recordings"] = array_of(diagnosis.recordings, recording_json);
    json["numbers"] = tuned_json(diagnosis.numbers);
    json["retuned_numbers"] = tuned_json(diagnosis.retuned_numbers);
    json["curves"] = array_of(diagnosis.curves, curve_json);
    json["not_tested"] = diagnosis.not_tested;
    json["case_warnings"] = doubts;
    json["rests_on"] = diagnosis.rests_on;
    json["remains"] = diagnosis.remains;
    json["seconds"] = or_null(diagnosis.seconds_taken);
    // Names come from files: bytes that are no UTF-8 are replaced.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace railpem::app
