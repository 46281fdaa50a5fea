#include "recordings/estimates/confidence.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/poisson.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>

namespace railpem::recordings {

namespace bm = boost::math;

Interval spectrum_interval(double averages, double confidence) {
    assert(averages > 0.0);
    const bm::chi_squared distribution(2.0 * averages);
    const double tail = 0.5 * (1.0 - confidence);
    return {2.0 * averages / bm::quantile(bm::complement(distribution, tail)),
            2.0 * averages / bm::quantile(distribution, tail)};
}

double coherence_limit(double averages, double false_alarm) {
    return averages > 1.0 ? 1.0 - std::pow(false_alarm, 1.0 / (averages - 1.0)) : 1.0;
}

double chi_squared_exceeded(double value, double degrees) {
    return value <= 0.0 ? 1.0 : bm::cdf(bm::complement(bm::chi_squared(degrees), value));
}

double f_exceeded(double value, double numerator_degrees, double denominator_degrees) {
    return value <= 0.0 ? 1.0 : bm::cdf(bm::complement(bm::fisher_f(numerator_degrees, denominator_degrees), value));
}

double normal_exceeded(double value) {
    return bm::cdf(bm::complement(bm::normal(), value));
}
double student_exceeded(double value, double degrees) {
    return bm::cdf(bm::complement(bm::students_t(degrees), value));
}
double poisson_at_least(double count, double mean) {
    return count <= 0.0 ? 1.0 : bm::cdf(bm::complement(bm::poisson(mean), count - 1.0));
}
double normal_quantile_exceeded(double p) {
    return bm::quantile(bm::complement(bm::normal(), p));
}

}  // namespace railpem::recordings
