#pragma once

#include <string_view>

namespace railpem::recordings {

/// True for what measuring systems and spreadsheets write where there is no sample: NaN in its spellings, NA, #N/A,
/// #DIV/0! and the other errors of a spreadsheet, -1.#IND, 1.#QNAN, nan(ind), Inf, OVL and other words for an overload,
/// null, none, dashes, asterisks, question marks. Capitals do not matter. An empty field is not a word.
bool is_missing_word(std::string_view field);

/// The words of the message that refuses another: "NaN, NA, #N/A, …".
inline constexpr const char* missing_words = "NaN, NA, N/A, #N/A, #DIV/0!, -1.#IND, Inf, OVL, null, ---";

}  // namespace railpem::recordings
