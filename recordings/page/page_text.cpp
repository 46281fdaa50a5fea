#include "recordings/page/page_text.hpp"

#include <nlohmann/json.hpp>

#include "recordings/files/visible_text.hpp"
#include "recordings/page/page_parts.hpp"

namespace railpem::recordings {
namespace {

/// JSON inside a script element: nothing in it may end the element.
std::string script_json(const nlohmann::json& json) {
    const std::string text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    std::string out;
    out.reserve(text.size());
    for (const char c : text) {
        if (c == '<')
            out += "\\u003c";
        else
            out += c;
    }
    return out;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : visible_lines(text)) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else if (c == '\'')
            out += "&#39;";
        else
            out += c;
    }
    return out;
}

std::string page_head(const std::string& title, std::string_view style) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
           "content=\"width=device-width, initial-scale=1\"><title>" +
           escaped(title) + "</title>\n<style>\n" + std::string(page_style()) + std::string(style) +
           "</style></head>\n<body><main>\n";
}

std::string page_end(const nlohmann::json& data, std::string_view script) {
    return "</main>\n<script>" + std::string(chart_library()) +
           "</script>\n<script type=\"application/json\" id=\"report\">" + script_json(data) + "</script>\n<script>\n" +
           std::string(charts_script()) + std::string(script) + "</script>\n</body></html>\n";
}

}  // namespace railpem::recordings
