#pragma once

#include <cstddef>
#include <utility>

namespace railpem::app {

/// So many of so many.
struct Proportion {
    std::size_t hits = 0, of = 0;
    void count(bool hit) {
        ++of;
        hits += hit;
    }
    /// NaN of none.
    double value() const;
};

/// Wilson's score interval of 95 % for the probability behind a proportion; 0 to 1 of none. E. B. Wilson, J. Am. Stat.
/// Assoc. 22 (1927) 209; Newcombe, Statistics in Medicine 17 (1998) 857, method 3.
std::pair<double, double> wilson_interval(const Proportion& proportion);

}  // namespace railpem::app
