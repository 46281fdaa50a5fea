#include "parameters/field.hpp"

#include <fmt/format.h>

#include <cmath>

namespace railpem::parameters {

bool Range::contains(double value) const {
    if (std::isnan(value)) return false;
    const bool above = low_open ? value > low : value >= low;
    const bool below = high_open ? value < high : value <= high;
    return above && below;
}

std::string Range::text() const {
    const bool has_low = std::isfinite(low);
    const bool has_high = std::isfinite(high);
    if (has_low && has_high && !low_open && !high_open) return fmt::format("between {:g} and {:g}", low, high);
    std::string words;
    if (has_low) words = fmt::format("{} {:g}", low_open ? "greater than" : "at least", low);
    if (has_high)
        words += fmt::format("{}{} {:g}", words.empty() ? "" : " and ", high_open ? "less than" : "at most", high);
    if (words.empty()) words = "any number";
    return has_high || high_open ? words : words + ", or inf";
}

Range positive() {
    return {.low = 0.0, .low_open = true, .high_open = true};
}
Range not_negative() {
    return {.low = 0.0, .high_open = true};
}
Range positive_or_infinite() {
    return {.low = 0.0, .low_open = true};
}
Range between(double low, double high) {
    return {.low = low, .high = high};
}
Range any_number() {
    const double infinity = std::numeric_limits<double>::infinity();
    return {.low = -infinity, .high = infinity, .low_open = true, .high_open = true};
}

}  // namespace railpem::parameters
