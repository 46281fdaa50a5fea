#pragma once
// What the numbers of a case are in the field: data beside the schema, wide enough for every railway.

#include <string>
#include <vector>

namespace railpem::app {

/// Values of a number that are believed without a question. Beyond them the program computes all the same.
struct BelievedRange {
    std::string key;  ///< dotted, elements of lists not stated
    double low, high;
    std::string reason;  ///< what the range comes from, as part of a sentence
};

/// For numbers of the case file. Zero and a default are never out of range: they mean that something is not there.
const std::vector<BelievedRange>& believed_ranges();

/// The same for what follows from the numbers (case_figures.hpp), by the name of the figure.
const std::vector<BelievedRange>& believed_figures();

}  // namespace railpem::app
