#pragma once

namespace railpem::recordings {

/// A value with the ends of its interval.
struct Interval {
    double low = 0.0;
    double high = 0.0;
};

/// Factors on an estimated spectrum that bound the true one: 2K/χ²_{1−p/2}(2K) and 2K/χ²_{p/2}(2K), p = 1 − confidence.
/// `averages`: independent averages K, need not be whole, > 0.
Interval spectrum_interval(double averages, double confidence = 0.9);

/// Coherence γ² that the estimate between two unrelated channels exceeds with probability `false_alarm`:
/// 1 − p^{1/(K−1)} (Goodman 1957). 1 when K ≤ 1.
double coherence_limit(double averages, double false_alarm = 0.05);

/// Probability that a value is exceeded: χ² with n degrees of freedom, F with (n, m), standard normal, Student with n,
/// Poisson (at least `count` when `mean` is expected).
double chi_squared_exceeded(double value, double degrees);
double f_exceeded(double value, double numerator_degrees, double denominator_degrees);
double normal_exceeded(double value);
double student_exceeded(double value, double degrees);
double poisson_at_least(double count, double mean);

/// The value that a standard normal exceeds with probability p.
double normal_quantile_exceeded(double p);

}  // namespace railpem::recordings
