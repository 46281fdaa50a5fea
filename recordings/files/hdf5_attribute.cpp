#include "recordings/files/hdf5_attribute.hpp"

#include <algorithm>
#include <vector>

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

constexpr hssize_t most_elements = 4096;

/// An attribute that is there, and how many elements it has.
struct Attribute {
    Hdf5Handle handle, type;
    std::size_t elements = 0;

    /// Of several elements the one asked for, of one always that.
    std::size_t place(std::size_t element) const { return elements == 1 ? 0 : element; }
};

std::optional<Attribute> attribute_of(hid_t object, const char* name) {
    if (H5Aexists(object, name) <= 0) return std::nullopt;
    Hdf5Handle handle(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
    const Hdf5Handle space(handle.valid() ? H5Aget_space(handle) : -1, H5Sclose);
    const hssize_t elements = space.valid() ? H5Sget_simple_extent_npoints(space) : 0;
    if (elements < 1 || elements > most_elements) return std::nullopt;
    Hdf5Handle type(H5Aget_type(handle), H5Tclose);
    return Attribute{std::move(handle), std::move(type), static_cast<std::size_t>(elements)};
}

std::optional<std::string> free_text(const Attribute& attribute, std::size_t place) {
    std::vector<char*> letters(attribute.elements, nullptr);
    if (H5Aread(attribute.handle, attribute.type, letters.data()) < 0) return std::nullopt;
    std::optional<std::string> text;
    if (letters[place]) text = trimmed(letters[place]);
    for (char* one : letters) H5free_memory(one);
    return text;
}

/// Read as it is stored: a conversion to a text that ends in a zero would drop the last letter of one without.
std::optional<std::string> fixed_text(const Attribute& attribute, std::size_t place) {
    const std::size_t size = H5Tget_size(attribute.type);
    if (size == 0 || size > longest_text) return std::nullopt;
    std::string all(size * attribute.elements, '\0');
    if (H5Aread(attribute.handle, attribute.type, all.data()) < 0) return std::nullopt;
    return trimmed(all.substr(place * size, size));
}

}  // namespace

std::optional<std::string> text_attribute(hid_t object, const char* name, std::size_t element) {
    const std::optional<Attribute> attribute = attribute_of(object, name);
    if (!attribute || H5Tget_class(attribute->type) != H5T_STRING) return std::nullopt;
    const std::size_t place = attribute->place(element);
    if (place >= attribute->elements) return std::nullopt;
    return H5Tis_variable_str(attribute->type) > 0 ? free_text(*attribute, place) : fixed_text(*attribute, place);
}

std::optional<double> number_attribute(hid_t object, const char* name, std::size_t element) {
    const std::optional<Attribute> attribute = attribute_of(object, name);
    if (!attribute) return std::nullopt;
    const H5T_class_t kind = H5Tget_class(attribute->type);
    const std::size_t place = attribute->place(element);
    std::vector<double> values(attribute->elements);
    if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || place >= values.size() ||
        H5Aread(attribute->handle, H5T_NATIVE_DOUBLE, values.data()) < 0)
        return std::nullopt;
    return values[place];
}

}  // namespace railpem::recordings
