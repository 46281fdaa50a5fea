#include "recordings/estimates/slepian_tapers.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace railpem::recordings {
namespace {

/// Symmetric tridiagonal matrix: off[n] couples n and n + 1.
struct Tridiagonal {
    std::vector<double> diagonal, off;
};

Tridiagonal commuting_matrix(std::size_t length, double half_bandwidth) {
    const double n = static_cast<double>(length), cosine = std::cos(2.0 * std::numbers::pi * half_bandwidth / n);
    Tridiagonal matrix;
    for (std::size_t i = 0; i < length; ++i) {
        const double x = static_cast<double>(i), half = 0.5 * (n - 1.0 - 2.0 * x);
        matrix.diagonal.push_back(half * half * cosine);
        if (i + 1 < length) matrix.off.push_back(0.5 * (x + 1.0) * (n - x - 1.0));
    }
    return matrix;
}

/// Number of eigenvalues greater than `value`: positive pivots of the factorisation of T − value.
std::size_t count_above(const Tridiagonal& matrix, double value) {
    std::size_t above = 0;
    double pivot = matrix.diagonal[0] - value;
    above += pivot > 0.0 ? 1 : 0;
    for (std::size_t i = 1; i < matrix.diagonal.size(); ++i) {
        if (pivot == 0.0) pivot = std::numeric_limits<double>::min();
        pivot = matrix.diagonal[i] - value - matrix.off[i - 1] * matrix.off[i - 1] / pivot;
        above += pivot > 0.0 ? 1 : 0;
    }
    return above;
}

/// The eigenvalue with `rank` eigenvalues above it.
double eigenvalue(const Tridiagonal& matrix, std::size_t rank) {
    double low = 0.0, high = 0.0;
    for (std::size_t i = 0; i < matrix.diagonal.size(); ++i) {  // Gershgorin
        const double radius = (i > 0 ? matrix.off[i - 1] : 0.0) + (i < matrix.off.size() ? matrix.off[i] : 0.0);
        high = std::max(high, matrix.diagonal[i] + radius);
        low = std::min(low, matrix.diagonal[i] - radius);
    }
    while (high - low > 4.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(low), std::abs(high))) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) break;
        (count_above(matrix, middle) > rank ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Solves (T − shift) x = right by elimination with row exchanges; the last pivot is kept away from zero.
void solve_shifted(const Tridiagonal& matrix, double shift, std::vector<double>& x) {
    const std::size_t n = matrix.diagonal.size();
    std::vector<double> main(n), upper(n, 0.0), second(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) main[i] = matrix.diagonal[i] - shift;
    for (std::size_t i = 0; i + 1 < n; ++i) upper[i] = matrix.off[i];
    for (std::size_t i = 0; i + 1 < n; ++i) {
        double below = matrix.off[i];
        if (std::abs(below) > std::abs(main[i])) {
            std::swap(main[i], below);
            std::swap(upper[i], main[i + 1]);
            std::swap(second[i], upper[i + 1]);
            std::swap(x[i], x[i + 1]);
        }
        const double factor = below / main[i];
        main[i + 1] -= factor * upper[i];
        upper[i + 1] -= factor * second[i];
        x[i + 1] -= factor * x[i];
    }
    const double tiny = std::numeric_limits<double>::epsilon() * std::abs(shift) + std::numeric_limits<double>::min();
    for (std::size_t i = n; i-- > 0;) {
        if (std::abs(main[i]) < tiny) main[i] = tiny;
        double sum = x[i];
        if (i + 1 < n) sum -= upper[i] * x[i + 1];
        if (i + 2 < n) sum -= second[i] * x[i + 2];
        x[i] = sum / main[i];
    }
}

void scale_to_unit_energy(std::vector<double>& x) {
    const double largest =
        std::abs(*std::max_element(x.begin(), x.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
    for (double& value : x) value /= largest;
    const double norm = std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0));
    for (double& value : x) value /= norm;
}

void remove_others(std::vector<double>& x, const std::vector<std::vector<double>>& others) {
    for (const auto& other : others) {
        const double share = std::inner_product(x.begin(), x.end(), other.begin(), 0.0);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] -= share * other[i];
    }
}

}  // namespace

std::vector<std::vector<double>> slepian_tapers(std::size_t length, double half_bandwidth, std::size_t count) {
    assert(length >= 8 && count >= 1 && half_bandwidth > 0.0 && half_bandwidth < 0.5 * static_cast<double>(length));
    const Tridiagonal matrix = commuting_matrix(length, half_bandwidth);
    std::vector<std::vector<double>> tapers;
    for (std::size_t rank = 0; rank < count; ++rank) {
        const double value = eigenvalue(matrix, rank);
        std::vector<double> x(length);
        // Neither even nor odd, so that the start has a share of every eigenvector.
        for (std::size_t i = 0; i < length; ++i)
            x[i] = 1.0 + 0.3 * std::sin(1.7 * static_cast<double>(i) + 0.3 * static_cast<double>(rank));
        for (int iteration = 0; iteration < 3; ++iteration) {
            solve_shifted(matrix, value, x);
            scale_to_unit_energy(x);
            remove_others(x, tapers);
            scale_to_unit_energy(x);
        }
        double sign = 0.0;
        for (std::size_t i = 0; i < length; ++i)
            sign += rank % 2 == 0 ? x[i] : (0.5 * static_cast<double>(length) - static_cast<double>(i)) * x[i];
        if (sign < 0.0)
            for (double& v : x) v = -v;
        tapers.push_back(std::move(x));
    }
    return tapers;
}

}  // namespace railpem::recordings
