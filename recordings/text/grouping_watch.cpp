#include "recordings/text/grouping_watch.hpp"

#include <algorithm>

namespace railpem::recordings {

bool GroupingWatch::observe(std::size_t column, std::string_view field) {
    Seen& seen = seen_[column];
    if (field.find(decimal_) == std::string_view::npos) {
        // A zero may stand for "nothing" among numbers with decimals, and an exponent for decimals.
        const bool counts = field.find_first_of("123456789") != std::string_view::npos &&
                            field.find_first_of("eEdD") == std::string_view::npos;
        seen.whole += counts ? 1 : 0;
    } else if (may_be_grouped(field, decimal_)) {
        if (seen.grouped++ == 0) seen.example = std::string(field);
    } else {
        seen.settled = true;
    }
    return doubtful(column);
}

bool GroupingWatch::doubtful(std::size_t column) const {
    const Seen& seen = seen_[column];
    return !seen.settled && seen.whole > 0 && seen.grouped >= fewest;
}

bool GroupingWatch::any_settled() const {
    return std::any_of(seen_.begin(), seen_.end(), [](const Seen& seen) { return seen.settled; });
}

}  // namespace railpem::recordings
