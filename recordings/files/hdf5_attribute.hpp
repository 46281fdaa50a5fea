#pragma once

#include <hdf5.h>

#include <optional>
#include <string>

namespace railpem::recordings {

/// The text of an attribute, however it is ended: by a zero, filled with zeros or blanks, of fixed or free length; as
/// UTF-8. Of an attribute that holds several, that of `element`. Nothing when there is none, or no text.
std::optional<std::string> text_attribute(hid_t object, const char* name, std::size_t element = 0);

/// The number of an attribute, or of its element when it holds several; nothing when there is none, or no number.
std::optional<double> number_attribute(hid_t object, const char* name, std::size_t element = 0);

}  // namespace railpem::recordings
