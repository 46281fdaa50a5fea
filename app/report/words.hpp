#pragma once
// How the report says numbers, places and effects. All results are harmless HTML.

#include <string>
#include <vector>

#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::app::report {

/// So many significant digits: "1770", "0.151", "1.31e8"; "–" when there is no value.
std::string figure(double value, int digits = 3);

/// A probability or share: "97 %", "99.8 %", "> 99.9 %", "< 0.1 %", "–".
std::string percent(double share);

/// "3.4 dB", "+3.1 dB" with `sign`.
std::string decibels(double value, bool sign = false);

/// A chance of false alarm: "1e-6", "< 1e-12", "0.02".
std::string chance(double probability);

/// The first letter large and a full stop at the end.
std::string sentence(const std::string& text);

/// "the rail pads", "the secondary suspension" …
std::string place_words(diagnosis::Element element);

/// Names of effects of a set, joined by " + "; "nothing is missing" for none, "something without a name" for "unknown".
std::string set_words(const std::vector<std::string>& effects);

/// An instance's choices as " (wheel 2, order 3)", or nothing.
std::string choice_words(const diagnosis::EffectInstance& instance);

/// The verdict in one sentence.
std::string headline(const diagnosis::Diagnosis& diagnosis);

/// A list element with every text escaped; nothing for an empty list.
std::string plain_list(const std::vector<std::string>& items);

}  // namespace railpem::app::report
