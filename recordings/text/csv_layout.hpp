#pragma once

#include <string>
#include <vector>

#include "recordings/files/file_statements.hpp"
#include "recordings/text/column_address.hpp"
#include "recordings/text/csv_dialect.hpp"
#include "recordings/text/grouping_watch.hpp"
#include "recordings/text/preamble.hpp"

namespace railpem::recordings {

/// What the beginning of a text file shows of all of it.
struct CsvLayout {
    CsvDialect dialect;
    ColumnNames columns;
    std::vector<ColumnStatement> says;  ///< per column: its unit, from a row of units or from behind its name
    Preamble preamble;
    GroupingWatch watch{0, '.'};  ///< has seen the first rows of the table
    std::size_t first_row = 0;    ///< index into the lines of the first row of the table
    std::vector<std::string> notes;
};

/// Finds table, header and units in the first lines of a file: the table begins with the first row that has numbers
/// where the rows after it have them; the rows of the same length right above it are its header. Of several the names
/// are the one that has most of the `wanted` names, else most different words, else the first; a row of units is one
/// of which at least half are known as units. What stands above is a preamble. Without a header the last comment is
/// one, if it has as many words. `lines` holds at least one line that is no comment.
CsvLayout find_layout(const std::vector<NumberedLine>& lines, const std::vector<std::string>& wanted);

}  // namespace railpem::recordings
