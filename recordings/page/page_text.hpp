#pragma once
// What every page of the program is put together with: it needs nothing beside it, and no text from a file can harm it.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace railpem::recordings {

/// Text that comes from files, made harmless in HTML and in quoted attributes.
std::string escaped(std::string_view text);

/// From the doctype to the opened main element, with page/page.css and `style`. The title is escaped here.
std::string page_head(const std::string& title, std::string_view style);

/// Closes the main element; brings Chart.js, page/charts.js and the data, then runs `script`, which finds the data with
/// pageData(). The data cannot end the script element that holds them.
std::string page_end(const nlohmann::json& data, std::string_view script);

}  // namespace railpem::recordings
