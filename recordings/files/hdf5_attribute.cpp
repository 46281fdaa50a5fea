#include "recordings/files/hdf5_attribute.hpp"

#include "recordings/files/hdf5_handle.hpp"
#include "recordings/files/text_encoding.hpp"

namespace railpem::recordings {
namespace {

constexpr std::size_t longest_text = 65536;

std::string trimmed(std::string text) {
    text.resize(std::min(text.size(), text.find('\0')));
    text.resize(text.find_last_not_of(" \t\r\n") + 1);
    bool converted = false;
    return to_utf8(text, converted);
}

/// The attribute when it is there and holds one element.
std::optional<Hdf5Handle> single_attribute(hid_t object, const char* name) {
    if (H5Aexists(object, name) <= 0) return std::nullopt;
    Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
    const Hdf5Handle space(attribute.valid() ? H5Aget_space(attribute) : -1, H5Sclose);
    if (!space.valid() || H5Sget_simple_extent_npoints(space) != 1) return std::nullopt;
    return attribute;
}

}  // namespace

std::optional<std::string> text_attribute(hid_t object, const char* name) {
    const std::optional<Hdf5Handle> attribute = single_attribute(object, name);
    if (!attribute) return std::nullopt;
    const Hdf5Handle type(H5Aget_type(*attribute), H5Tclose);
    if (H5Tget_class(type) != H5T_STRING) return std::nullopt;
    if (H5Tis_variable_str(type) > 0) {
        char* letters = nullptr;
        if (H5Aread(*attribute, type, &letters) < 0 || !letters) return std::nullopt;
        std::string text(letters);
        H5free_memory(letters);
        return trimmed(std::move(text));
    }
    // Read as it is stored: a conversion to a text that ends in a zero would drop the last letter of one without.
    std::string text(H5Tget_size(type), '\0');
    if (text.empty() || text.size() > longest_text || H5Aread(*attribute, type, text.data()) < 0) return std::nullopt;
    return trimmed(std::move(text));
}

std::optional<double> number_attribute(hid_t object, const char* name) {
    const std::optional<Hdf5Handle> attribute = single_attribute(object, name);
    if (!attribute) return std::nullopt;
    const Hdf5Handle type(H5Aget_type(*attribute), H5Tclose);
    const H5T_class_t kind = H5Tget_class(type);
    double value = 0.0;
    if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || H5Aread(*attribute, H5T_NATIVE_DOUBLE, &value) < 0)
        return std::nullopt;
    return value;
}

}  // namespace railpem::recordings
