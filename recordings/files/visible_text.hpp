#pragma once

#include <string>
#include <string_view>

namespace railpem::recordings {

/// Text from a file or a name as it may be shown: what would move a terminal's cursor, hide or turn the text around it
/// is written out. Control characters become \n, \t or \u001b, marks that turn the direction of writing \u202e, bytes
/// that are not UTF-8 \xff. Everything else stays.
std::string visible(std::string_view text);

/// The same for whole messages and reports, whose line ends are meant.
std::string visible_lines(std::string_view text);

}  // namespace railpem::recordings
