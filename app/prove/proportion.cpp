#include "app/prove/proportion.hpp"

#include <cmath>
#include <limits>

namespace railpem::app {

double Proportion::value() const {
    return of > 0 ? static_cast<double>(hits) / static_cast<double>(of) : std::numeric_limits<double>::quiet_NaN();
}

std::pair<double, double> wilson_interval(const Proportion& proportion) {
    if (proportion.of == 0) return {0.0, 1.0};
    constexpr double z = 1.959963984540054;  // 97.5 % point of the normal distribution
    const double n = static_cast<double>(proportion.of), p = proportion.value();
    const double centre = p + z * z / (2.0 * n), reach = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
    const double width = 1.0 + z * z / n;
    // At the ends the interval touches 0 and 1 exactly; rounding must not leave it beyond or short of them.
    return {proportion.hits == 0 ? 0.0 : (centre - reach) / width,
            proportion.hits == proportion.of ? 1.0 : (centre + reach) / width};
}

}  // namespace railpem::app
