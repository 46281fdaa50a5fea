#pragma once

#include <hdf5.h>

#include <optional>
#include <string>

namespace railpem::recordings {

/// The text of an attribute, however it is ended: by a zero, filled with zeros or blanks, of fixed or free length; as
/// UTF-8. Nothing when there is none, or no single text.
std::optional<std::string> text_attribute(hid_t object, const char* name);

/// The number of an attribute; nothing when there is none, or no single number.
std::optional<double> number_attribute(hid_t object, const char* name);

}  // namespace railpem::recordings
