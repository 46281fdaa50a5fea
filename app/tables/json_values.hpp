#pragma once
// Values as they stand in the JSON files that the program writes.

#include <nlohmann/json.hpp>
#include <optional>

#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::app {

using Json = nlohmann::ordered_json;

/// JSON knows neither NaN nor infinity: null.
Json or_null(double value);
Json or_null(const std::optional<double>& value);

/// How well a case fits.
Json figures_json(const diagnosis::FitFigures& fit);

/// All of a list as an array, also when it is empty.
template <typename List, typename ToJson>
Json array_of(const List& list, const ToJson& to_json) {
    Json array = Json::array();
    for (const auto& item : list) array.push_back(to_json(item));
    return array;
}

}  // namespace railpem::app
