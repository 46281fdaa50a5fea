#include "recordings/files/hdf5_statement.hpp"

#include <fmt/format.h>

#include <cmath>

#include "recordings/files/hdf5_attribute.hpp"

namespace railpem::recordings {
namespace {

/// An attribute, and which it was.
template <class Value>
struct Found {
    Value value;
    const char* name;
};

std::optional<Found<std::string>> first_text(hid_t object, const std::vector<const char*>& names, std::size_t element) {
    for (const char* name : names)
        if (const auto text = text_attribute(object, name, element); text && !text->empty())
            return Found<std::string>{*text, name};
    return std::nullopt;
}

std::optional<Found<double>> first_number(hid_t object, const std::vector<const char*>& names, std::size_t element) {
    for (const char* name : names)
        if (const auto number = number_attribute(object, name, element); number && std::isfinite(*number))
            return Found<double>{*number, name};
    return std::nullopt;
}

}  // namespace

std::optional<StatedRate> hdf5_rate(hid_t object) {
    static const std::vector<const char*> rates = {"sampling_rate_hz",   "sampling_rate", "sample_rate",
                                                   "sampling_frequency", "SampleRate",    "fs"};
    if (const auto rate = first_number(object, rates, 0); rate && rate->value > 0.0)
        return StatedRate{rate->value, fmt::format("attribute '{}'", rate->name)};
    if (const auto step = first_number(object, {"wf_increment"}, 0); step && step->value > 0.0)
        return StatedRate{1.0 / step->value, fmt::format("attribute '{}'", step->name)};
    return std::nullopt;
}

ColumnStatement hdf5_statement(hid_t dataset, hid_t group, std::size_t channel) {
    static const std::vector<const char*> units = {"units", "unit",        "Units",
                                                   "Unit",  "unit_string", "NI_UnitDescription"};
    ColumnStatement says;
    for (const hid_t object : {dataset, group}) {
        if (object < 0) continue;
        const auto unit = first_text(object, units, channel);
        if (unit && says.unit.empty()) {
            says.unit = unit->value;
            says.unit_where = fmt::format("attribute '{}'", unit->name);
        }
        const auto scale = number_attribute(object, "scale_factor", channel),
                   offset = number_attribute(object, "add_offset", channel);
        if ((scale || offset) && !says.scale && !says.offset) {
            says.scale = scale;
            says.offset = offset;
            says.scale_where = scale && offset ? "attributes 'scale_factor' and 'add_offset'"
                               : scale         ? "attribute 'scale_factor'"
                                               : "attribute 'add_offset'";
        }
        if (const auto rate = hdf5_rate(object); rate && !says.sampling_rate_hz) says.sampling_rate_hz = rate->hz;
        if (const auto start = number_attribute(object, "wf_start_offset"); start && !says.start_s)
            says.start_s = start;
    }
    return says;
}

std::vector<double> hdf5_fill_values(hid_t dataset) {
    // Zero is a value that sensors at rest have.
    std::vector<double> values;
    for (const char* name : {"_FillValue", "missing_value"})
        if (const auto value = number_attribute(dataset, name); value && *value != 0.0) values.push_back(*value);
    return values;
}

std::vector<std::string> hdf5_unused_scales(hid_t dataset) {
    std::vector<std::string> found;
    for (const char* name : {"scale", "gain", "slope", "offset", "sensitivity", "calibration", "calibration_factor"})
        if (const auto value = number_attribute(dataset, name); value && *value != 1.0 && *value != 0.0)
            found.push_back(fmt::format("'{}' = {:g}", name, *value));
    return found;
}

}  // namespace railpem::recordings
