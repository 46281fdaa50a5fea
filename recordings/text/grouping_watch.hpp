#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "recordings/text/csv_dialect.hpp"

namespace railpem::recordings {

/// Looks whether what is taken for decimals is in truth thousands: "1.234" in a column in which "999" stands, too. With
/// decimals written out such numbers cannot stand side by side, and without trailing zeros some would have one or two.
class GroupingWatch {
  public:
    /// Fewest numbers of exactly three decimals before a column is doubted: of numbers without trailing zeros, one in
    /// ten loses a digit, so that eight that lost none, beside an integer, which lost three, are one in thousands.
    static constexpr int fewest = 8;

    GroupingWatch(std::size_t columns, char decimal) : decimal_(decimal), seen_(columns) {}

    /// False once a column has shown that its decimals are decimals: it needs no more watching.
    bool watches(std::size_t column) const { return !seen_[column].settled; }

    /// Takes a field that is a number. True when its column has become doubtful with it.
    bool observe(std::size_t column, std::string_view field);

    bool doubtful(std::size_t column) const;
    bool any_settled() const;  ///< some column shows decimals that cannot be groups
    const std::string& example(std::size_t column) const { return seen_[column].example; }

  private:
    struct Seen {
        bool settled = false;
        int whole = 0, grouped = 0;
        std::string example;
    };
    char decimal_;
    std::vector<Seen> seen_;
};

}  // namespace railpem::recordings
