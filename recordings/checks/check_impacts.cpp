#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numeric>

#include "recordings/checks/checks.hpp"
#include "recordings/estimates/confidence.hpp"
#include "recordings/estimates/fourier_transform.hpp"

namespace railpem::recordings::checks {
namespace {

constexpr std::size_t order = 32;

/// Coefficients a of x_n ≈ Σ a_k x_{n−k}, by the autocorrelation method (Levinson–Durbin). A billionth of the power is
/// added to the zero lag, so that a band-limited channel does not make the equations singular.
std::vector<double> autoregression(const std::vector<double>& x) {
    std::vector<double> r(order + 1, 0.0);
    for (std::size_t n = 0; n < std::min(order, x.size()); ++n)
        for (std::size_t lag = 0; lag <= n; ++lag) r[lag] += x[n] * x[n - lag];
    std::array<double, order + 1> sum{};  // side by side, so that the compiler adds several lags at once
    std::copy(r.begin(), r.end(), sum.begin());
    for (std::size_t n = order; n < x.size(); ++n)
        for (std::size_t lag = 0; lag <= order; ++lag) sum[lag] += x[n] * x[n - lag];
    std::copy(sum.begin(), sum.end(), r.begin());
    r[0] *= 1.0 + 1e-9;
    std::vector<double> a(order + 1, 0.0);
    double error = r[0];
    for (std::size_t m = 1; m <= order && error > 0.0; ++m) {
        double reflection = r[m];
        for (std::size_t k = 1; k < m; ++k) reflection -= a[k] * r[m - k];
        reflection /= error;
        std::vector<double> next = a;
        next[m] = reflection;
        for (std::size_t k = 1; k < m; ++k) next[k] = a[k] - reflection * a[m - k];
        a = std::move(next);
        error *= 1.0 - reflection * reflection;
    }
    return a;
}

std::vector<double> prediction_errors(const std::vector<double>& x, const std::vector<double>& a) {
    std::vector<double> e(x.size(), 0.0);
    constexpr std::size_t together = 512;  // neighbours, so that the compiler predicts several at once
    for (std::size_t begin = order; begin < x.size(); begin += together) {
        const std::size_t end = std::min(x.size(), begin + together);
        std::copy(x.begin() + static_cast<std::ptrdiff_t>(begin), x.begin() + static_cast<std::ptrdiff_t>(end),
                  e.begin() + static_cast<std::ptrdiff_t>(begin));
        for (std::size_t k = 1; k <= order; ++k)
            for (std::size_t n = begin; n < end; ++n) e[n] -= a[k] * x[n - k];
    }
    return e;
}

double median_magnitude(const std::vector<double>& e, std::size_t begin, std::size_t end) {
    std::vector<double> magnitudes;
    for (std::size_t n = begin; n < end; ++n)
        if (e[n] != 0.0) magnitudes.push_back(std::abs(e[n]));
    if (magnitudes.size() < 16) return 0.0;
    const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(magnitudes.size() / 2);
    std::nth_element(magnitudes.begin(), middle, magnitudes.end());
    return *middle;
}

}  // namespace

void check_impacts(const Evidence& evidence, std::vector<Fault>& faults) {
    const double rate = evidence.series().sampling_rate_hz;
    for (std::size_t i = 0; i < evidence.detrended.size(); ++i) {
        const auto& x = evidence.detrended[i];
        if (x.size() < 1000) continue;
        const std::vector<double> e = prediction_errors(x, autoregression(x));
        // Scatter from the median over about two seconds (2000 values at least): level changes along the record are not
        // impacts. The scale is then known within 3 %; a tenth is added to the threshold for it.
        const std::size_t part = std::max<std::size_t>(2000, static_cast<std::size_t>(2.0 * rate));
        const double threshold = 1.1 * normal_quantile_exceeded(1e-6 / (2.0 * static_cast<double>(x.size())));
        std::size_t count = 0, last = 0, worst_at = 0;
        double worst = 0.0;
        bool any = false;
        for (std::size_t begin = order; begin < x.size(); begin += part) {
            const std::size_t end = std::min(x.size(), begin + part);
            const double scale =
                median_magnitude(e, end - begin < part / 2 && begin > part ? begin - part : begin, end) / 0.6745;
            if (scale <= 0.0) continue;
            for (std::size_t n = begin; n < end; ++n) {
                const double z = std::abs(e[n]) / scale;
                if (z < threshold) continue;
                // Beside a gap the prediction starts from nothing.
                bool beside_gap = false;
                for (std::size_t k = 0; k <= order && k <= n; ++k)
                    beside_gap = beside_gap || !std::isfinite(evidence.series().channels[i].samples[n - k]);
                if (beside_gap) continue;
                if (!any || static_cast<double>(n - last) > 0.05 * rate) ++count;
                any = true;
                last = n;
                if (z > worst) {
                    worst = z;
                    worst_at = n;
                }
            }
        }
        if (!any) continue;
        Fault found;
        found.kind = FaultKind::impacts;
        found.severity = Severity::note;
        found.channels = {evidence.name(i)};
        found.says =
            fmt::format("{} impact{}, {:.1f} per minute, the strongest {:.0f} times the usual scatter at {:.3f} s",
                        count, count > 1 ? "s" : "", 60.0 * static_cast<double>(count) / evidence.series().duration_s(),
                        worst, static_cast<double>(worst_at) / rate);
        found.from_s = static_cast<double>(worst_at) / rate;
        found.to_s = found.from_s;
        found.value = static_cast<double>(count);
        found.unit = "1";
        found.false_alarm = std::min(1.0, 2.0 * static_cast<double>(x.size()) * normal_exceeded(worst / 1.1));
        faults.push_back(std::move(found));
    }
}

}  // namespace railpem::recordings::checks
