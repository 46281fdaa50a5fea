#include "simulate/numerics/relaxation_chain.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulate/numerics/nonnegative_least_squares.hpp"

namespace railpem::simulate {

namespace {

using std::numbers::pi;

std::vector<double> logarithmic(double from, double to, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(from * std::pow(to / from, double(i) / (count - 1)));
    return values;
}

double interpolate_logarithmic(const std::vector<double>& x, const std::vector<double>& y, double at) {
    if (at <= x.front()) return y.front();
    if (at >= x.back()) return y.back();
    const auto i = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
    const double share = std::log(at / x[i - 1]) / std::log(x[i] / x[i - 1]);
    return y[i - 1] + share * (y[i] - y[i - 1]);
}

/// Twelve branches whose corner frequencies reach a decade beyond the fitted range on either side.
std::vector<double> relaxation_times() {
    std::vector<double> times;
    for (const double corner : logarithmic(0.06, 8000.0, 13)) times.push_back(1.0 / (2.0 * pi * corner));
    return times;
}

double largest_error(const RelaxationChain& chain, const std::function<Complex(double)>& modulus) {
    double largest = 0.0;
    for (const double f : logarithmic(1.0, 400.0, 200)) {
        const Complex law = modulus(f);
        largest = std::max(largest, std::abs(chain.modulus({0.0, 2.0 * pi * f}) / law - 1.0));
    }
    return largest;
}

}  // namespace

Complex RelaxationChain::modulus(Complex s) const {
    Complex sum = equilibrium;
    for (std::size_t b = 0; b < strength.size(); ++b) sum += strength[b] * s * time_s[b] / (1.0 + s * time_s[b]);
    return sum;
}

double RelaxationChain::glassy() const {
    double sum = equilibrium;
    for (const double value : strength) sum += value;
    return sum;
}

RelaxationChain fit_chain(const std::function<Complex(double)>& modulus) {
    const std::vector<double> frequencies = logarithmic(chain_from_hz, chain_to_hz, 120);
    const std::vector<double> times = relaxation_times();
    const auto lines = static_cast<Eigen::Index>(frequencies.size());
    const auto branches = static_cast<Eigen::Index>(times.size());
    Eigen::MatrixXd a(2 * lines, branches + 1);
    Eigen::VectorXd b(2 * lines);
    for (Eigen::Index i = 0; i < lines; ++i) {
        const double f = frequencies[static_cast<std::size_t>(i)];
        const Complex law = modulus(f);
        for (Eigen::Index j = 0; j <= branches; ++j) {
            const Complex s(0.0, 2.0 * pi * f);
            const Complex branch = j == 0 ? Complex(1.0)
                                          : s * times[static_cast<std::size_t>(j - 1)] /
                                                (1.0 + s * times[static_cast<std::size_t>(j - 1)]);
            a(2 * i, j) = (branch / law).real();
            a(2 * i + 1, j) = (branch / law).imag();
        }
        b[2 * i] = 1.0;
        b[2 * i + 1] = 0.0;
    }
    const Eigen::VectorXd x = nonnegative_least_squares(a, b);
    RelaxationChain chain;
    chain.equilibrium = x[0];
    for (Eigen::Index j = 0; j < branches; ++j) {
        if (x[j + 1] <= 0.0) continue;
        chain.strength.push_back(x[j + 1]);
        chain.time_s.push_back(times[static_cast<std::size_t>(j)]);
    }
    chain.largest_error = largest_error(chain, modulus);
    return chain;
}

std::function<Complex(double)> pad_modulus(const track::PadParameters& pads) {
    if (!pads.table_frequency_hz.empty())
        return [pads](double f) {
            const double storage = interpolate_logarithmic(pads.table_frequency_hz, pads.table_storage_ratio, f);
            const double loss = interpolate_logarithmic(pads.table_frequency_hz, pads.table_loss_factor, f);
            return storage * Complex(1.0, loss);
        };
    const double loss_exponent = 2.0 / pi * std::atan(pads.loss_factor);
    return [pads, loss_exponent](double f) {
        const double storage = std::pow(f / pads.reference_frequency_hz, pads.exponent) *
                               std::pow(f / pads.loss_reference_hz, loss_exponent);
        return storage * Complex(1.0, std::tan(0.5 * pi * pads.exponent)) * Complex(1.0, pads.loss_factor);
    };
}

double pad_dashpot_n_s_per_m(const track::PadParameters& pads) {
    const bool replaced = pads.loss_factor > 0.0 && pads.loss_law == track::LossLaw::causal;
    return replaced ? 0.0 : pads.damping_n_s_per_m;
}

RelaxationChain pad_chain(const track::PadParameters& pads) {
    if (pads.exponent == 0.0 && pads.loss_factor == 0.0 && pads.table_frequency_hz.empty()) return {};
    return fit_chain(pad_modulus(pads));
}

}  // namespace railpem::simulate
