#include "app/schema/world_option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/input_error.hpp"
#include "app/schema/nearest_key.hpp"

namespace railpem::app {

using simulate::WorldKey;

namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& what, const std::string& allowed) {
    throw input_error("", "", {.option = option}, {.what = what, .allowed = allowed, .hint = ""});
}

std::string range_text(const WorldKey& key) {
    return fmt::format("between {:g} and {:g}{}", key.low, key.high, key.unit == "1" ? "" : " " + key.unit);
}

const WorldKey& find_key(const std::string& option, const std::string& name) {
    std::vector<std::string> known;
    for (const WorldKey& key : simulate::world_keys()) {
        if (key.name == name) return key;
        known.push_back(key.name);
    }
    throw unknown_name(option, "number of a world", name, known);
}

/// Stores one `key=value`.
void read_item(const std::string& option, const std::string& item, World& world, std::vector<std::string>& given) {
    const std::size_t equals = item.find('=');
    const WorldKey& key = find_key(option, item.substr(0, equals));
    const std::string text = equals == std::string::npos ? "" : item.substr(equals + 1);
    if (text.empty()) refuse(option, fmt::format("'{}' has no value", key.name), key.name + "=VALUE");
    if (std::find(given.begin(), given.end(), key.name) != given.end())
        refuse(option, fmt::format("'{}' is given twice", key.name), "once");
    given.push_back(key.name);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !(value >= key.low && value <= key.high))
        refuse(option, fmt::format("'{}' cannot be {}", key.name, text), range_text(key));
    world.parameters.*key.member = value;
}

}  // namespace

std::string World::name() const {
    return parameters == simulate::world_of_grade(grade) ? grade : grade + " (changed)";
}

World read_world_option(const std::string& text) {
    if (text.empty()) return {};
    const std::string option = "--world " + text;
    const std::size_t colon = text.find(':');
    World world{.grade = text.substr(0, colon), .parameters = {}};
    const std::vector<std::string>& grades = simulate::world_grades();
    if (std::find(grades.begin(), grades.end(), world.grade) == grades.end())
        throw unknown_name(option, "grade", world.grade, grades);
    world.parameters = simulate::world_of_grade(world.grade);
    std::vector<std::string> given;
    for (std::size_t at = colon; at != std::string::npos;) {
        const std::size_t comma = text.find(',', at + 1);
        const std::string item = text.substr(at + 1, comma == std::string::npos ? comma : comma - at - 1);
        if (!item.empty()) read_item(option, item, world, given);
        at = comma;
    }
    return world;
}

std::string world_list() {
    std::string text =
        "\nHow imperfect the world is, --world ideal, good or worn; after each number its values in these grades:\n";
    const simulate::WorldParameters ideal;
    for (const WorldKey& key : simulate::world_keys())
        text +=
            fmt::format("    {:<26} {:g}, {:g}, {:g}{}; {}: {}\n        {}\n", key.name, ideal.*key.member, key.good,
                        key.worn, key.unit == "1" ? "" : " " + key.unit, range_text(key), key.says, key.source);
    return text;
}

}  // namespace railpem::app
