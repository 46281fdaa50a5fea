#include "app/report/words.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "recordings/page/page_text.hpp"

namespace railpem::app::report {

using diagnosis::Diagnosis;
using diagnosis::Element;
using diagnosis::Verdict;
using recordings::escaped;

std::string figure(double value, int digits) {
    if (!std::isfinite(value)) return "–";
    const std::string text = fmt::format("{:.{}e}", value, digits - 1);
    const double shown = std::stod(text);
    if (shown == 0.0 || (std::abs(shown) >= 1e-3 && std::abs(shown) < 1e5)) return fmt::format("{:.10g}", shown);
    const std::size_t e = text.find('e');
    std::string mantissa = text.substr(0, e);
    if (mantissa.find('.') != std::string::npos) {
        mantissa.erase(mantissa.find_last_not_of('0') + 1);
        if (mantissa.back() == '.') mantissa.pop_back();
    }
    return mantissa + "e" + std::to_string(std::stoi(text.substr(e + 1)));
}

std::string percent(double share) {
    if (!std::isfinite(share)) return "–";
    if (share > 0.999 && share < 1.0) return "&gt; 99.9 %";
    if (share > 0.0 && share < 0.001) return "&lt; 0.1 %";
    const bool whole = share >= 0.0995 && share < 0.9895;
    return fmt::format("{:.{}f} %", 100.0 * share, whole || share == 0.0 || share == 1.0 ? 0 : 1);
}

std::string decibels(double value, bool sign) {
    if (!std::isfinite(value)) return "–";
    const int digits = std::abs(value) < 1.0 ? 2 : 1;
    return sign ? fmt::format("{:+.{}f} dB", value, digits) : fmt::format("{:.{}f} dB", value, digits);
}

std::string chance(double probability) {
    if (!std::isfinite(probability)) return "–";
    return probability < 1e-12 ? "&lt; 1e-12" : figure(probability, 1);
}

std::string sentence(const std::string& text) {
    if (text.empty()) return "";
    std::string out = text;
    out[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out[0])));
    const char last = out.back();
    return escaped(last == '.' || last == '!' || last == '?' ? out : out + ".");
}

std::string place_words(Element element) {
    static const char* const words[] = {"the secondary suspension",
                                        "the primary suspension",
                                        "the car body",
                                        "the bogie frames",
                                        "the wheelsets",
                                        "the contact",
                                        "the rail",
                                        "the rail pads",
                                        "the support",
                                        "the irregularity",
                                        "a sensor"};
    return words[static_cast<std::size_t>(element)];
}

std::string set_words(const std::vector<std::string>& effects) {
    if (effects.empty()) return "nothing is missing";
    std::string out;
    for (const std::string& effect : effects)
        out += (out.empty() ? "" : " + ") + (effect == "unknown" ? "something without a name" : escaped(effect));
    return out;
}

std::string choice_words(const diagnosis::EffectInstance& instance) {
    std::string out;
    for (const auto& [name, value] : instance.choices) out += (out.empty() ? " (" : ", ") + escaped(name + " " + value);
    return out.empty() ? out : out + ")";
}

namespace {

std::string named(const Diagnosis& diagnosis) {
    if (diagnosis.omitted.empty()) return "";
    if (diagnosis.omitted.size() == 1)
        return escaped(diagnosis.omitted[0].says) + choice_words(diagnosis.omitted[0].instance) + ".";
    std::string out;
    for (const diagnosis::NamedEffect& effect : diagnosis.omitted)
        out += (out.empty() ? "" : ", and ") + escaped(effect.instance.effect) + choice_words(effect.instance);
    return out + ".";
}

/// Wrong values and nothing else: "track.pads.stiffness_n_per_m × 1.40"; empty when an effect is among them.
std::string wrong_values(const Diagnosis& diagnosis) {
    std::string out;
    for (const diagnosis::NamedEffect& effect : diagnosis.omitted) {
        const auto key = effect.instance.choices.find("parameter");
        const auto factor = effect.instance.values.find("factor");
        if (!is_wrong_number(effect.instance) || key == effect.instance.choices.end() ||
            factor == effect.instance.values.end())
            return "";
        out += (out.empty() ? "" : ", ") + escaped(key->second) + " is " + figure(factor->second) +
               " times what was believed";
    }
    return out;
}

std::string rivals_named(const Diagnosis& diagnosis) {
    std::string out;
    for (std::size_t i = 0; i < diagnosis.rivals.size(); ++i)
        out += (i == 0                             ? ""
                : i + 1 == diagnosis.rivals.size() ? " or "
                                                   : ", ") +
               set_words(diagnosis.rivals[i].effects);
    return fmt::format("{} explanations stand: {}.", diagnosis.rivals.size(), out);
}

}  // namespace

std::string headline(const Diagnosis& diagnosis) {
    switch (diagnosis.verdict) {
        case Verdict::consistent:
            return "Nothing significant is missing from the simulation.";
        case Verdict::explained:
            if (const std::string wrong = wrong_values(diagnosis); !wrong.empty())
                return "Nothing is left out: " + wrong + ".";
            return "Left out: " + named(diagnosis);
        case Verdict::ambiguous:
            return rivals_named(diagnosis);
        case Verdict::recording_fault:
            return "The recording is at fault, not the simulation: " + named(diagnosis);
        case Verdict::unexplained:
            break;
    }
    if (diagnosis.places.empty()) return "Something is missing that no known effect explains.";
    return fmt::format("Something is missing at {} that no known effect explains.",
                       place_words(diagnosis.places[0].element));
}

std::string plain_list(const std::vector<std::string>& items) {
    if (items.empty()) return "";
    std::string out = "<ul class=\"plain\">";
    for (const std::string& item : items) out += "<li>" + escaped(item) + "</li>";
    return out + "</ul>\n";
}

}  // namespace railpem::app::report
