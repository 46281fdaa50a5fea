#include "app/prove/hidden_draw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "effects/catalogue.hpp"
#include "simulate/recording.hpp"

namespace railpem::app {

namespace {

constexpr double kLeastLine_hz = 4.0, kMostLine_hz = 150.0;

double draw_value(const DrawnParameter& parameter, const std::map<std::string, double>& others, DrawStream& stream) {
    double x = parameter.spacing == DrawSpacing::whole
                   ? parameter.low +
                         static_cast<double>(stream.index(static_cast<std::size_t>(parameter.high - parameter.low) + 1))
               : parameter.spacing == DrawSpacing::logarithmic ? stream.logarithmic(parameter.low, parameter.high)
                                                               : stream.uniform(parameter.low, parameter.high);
    if (!parameter.scaled_by.empty()) x *= std::pow(others.at(parameter.scaled_by), parameter.power);
    if (parameter.mirror == DrawMirror::sign && stream.chance(0.5)) x = -x;
    if (parameter.mirror == DrawMirror::inverse && stream.chance(0.5)) x = 1.0 / x;
    const bool upside_down = parameter.upside_down > 0.0 && stream.chance(parameter.upside_down);
    return upside_down ? -1.0 : parameter.offset + x;
}

std::map<std::string, double> draw_values(const EffectDraw& draw, DrawStream& stream) {
    std::map<std::string, double> values;
    for (const DrawnParameter& parameter : draw.parameters)
        values[parameter.name] = draw_value(parameter, values, stream);
    return values;
}

std::map<std::string, std::string> draw_texts(const std::string& id, const diagnosis::BelievedCase& believed,
                                              DrawStream& stream) {
    std::map<std::string, std::string> texts;
    for (const effects::EffectChoice& choice : effects::find_description(id)->choices) {
        if (choice.whole_number) continue;  // drawn as a number
        if (choice.options.empty())
            texts[choice.name] = believed.uncertain[stream.index(believed.uncertain.size())].key;
        else if (choice.name == "channel")
            texts[choice.name] = simulate::channel_names()[stream.index(simulate::channel_names().size())];
        else
            texts[choice.name] = choice.options[stream.index(choice.options.size())];
    }
    return texts;
}

/// Whether what is periodic shows somewhere in the band.
bool shows(const EffectDraw& draw, const std::map<std::string, double>& values, const CaseFile& file,
           const std::vector<TrialRecord>& records) {
    double wavelength = 0.0;
    if (!draw.waves_per_turn.empty())
        wavelength = 2.0 * std::numbers::pi * file.parameters.vehicle.wheel_radius_m / values.at(draw.waves_per_turn);
    if (!draw.wavelength.empty()) wavelength = values.at(draw.wavelength);
    if (wavelength == 0.0) return true;
    return std::any_of(records.begin(), records.end(), [&](const TrialRecord& record) {
        const double line = record.speed_m_per_s / wavelength;
        return line >= kLeastLine_hz && line <= kMostLine_hz;
    });
}

/// Whether `simulate` would take the values without --force: a strength that is scaled by another parameter may leave
/// its range.
bool is_physical(const std::string& id, const std::map<std::string, double>& values) {
    for (const simulate::HiddenEffect& effect : simulate::hidden_effects())
        for (const simulate::HiddenParameter& parameter : effect.parameters)
            if (const auto own = values.find(parameter.name);
                effect.id == id && own != values.end() && !parameter.is_text)
                if (own->second < parameter.low || own->second > parameter.high) return false;
    return true;
}

const EffectDraw& choose_draw(const std::string& id, DrawStream& stream) {
    std::vector<const EffectDraw*> found;
    for (const std::vector<EffectDraw>* list : {&physics_draws(), &sensor_draws(), &outside_draws()})
        for (const EffectDraw& draw : *list)
            if (draw.id == id) found.push_back(&draw);
    return found.empty() ? parameter_error_draw() : *found[stream.index(found.size())];
}

}  // namespace

simulate::Hidden draw_effect(const std::string& id, const CaseFile& file, const diagnosis::BelievedCase& believed,
                             const std::vector<TrialRecord>& records, DrawStream& stream) {
    const EffectDraw& draw = choose_draw(id, stream);
    std::map<std::string, double> values;
    do values = draw_values(draw, stream);
    while (!shows(draw, values, file, records) || !is_physical(id, values));
    std::string text = id;
    char separator = ':';
    const auto add = [&](const std::string& name, const std::string& value) {
        text += fmt::format("{}{}={}", separator, name, value);
        separator = ',';
    };
    for (const auto& [name, value] : draw_texts(id, believed, stream)) add(name, value);
    for (const auto& [name, value] : values) add(name, fmt::format("{:.17g}", value));
    return simulate::parse_hidden(text);
}

}  // namespace railpem::app
