#include "simulate/block_tridiagonal.hpp"

namespace railpem::simulate {

namespace {

Block inverse_of(const Block& a) {
    const Complex d = 1.0 / (product(a[0], a[3]) - product(a[1], a[2]));
    return {product(a[3], d), -product(a[1], d), -product(a[2], d), product(a[0], d)};
}

Block times(const Block& a, const Block& b) {
    return {product(a[0], b[0]) + product(a[1], b[2]), product(a[0], b[1]) + product(a[1], b[3]),
            product(a[2], b[0]) + product(a[3], b[2]), product(a[2], b[1]) + product(a[3], b[3])};
}

Block transposed(const Block& a) { return {a[0], a[2], a[1], a[3]}; }

Pair times(const Block& a, const Pair& x) {
    return {product(a[0], x.w) + product(a[1], x.theta), product(a[2], x.w) + product(a[3], x.theta)};
}

}  // namespace

void factorise(const BlockTridiagonal& matrix, BlockFactors& factors) {
    const std::size_t n = matrix.diagonal.size();
    factors.inverse.resize(n);
    factors.lower.resize(n);
    factors.inverse[0] = inverse_of(matrix.diagonal[0]);
    for (std::size_t k = 1; k < n; ++k) {
        factors.lower[k] = times(transposed(matrix.upper[k - 1]), factors.inverse[k - 1]);
        const Block removed = times(factors.lower[k], matrix.upper[k - 1]);
        Block reduced = matrix.diagonal[k];
        for (std::size_t i = 0; i < 4; ++i) reduced[i] -= removed[i];
        factors.inverse[k] = inverse_of(reduced);
    }
}

void solve(const BlockFactors& factors, std::vector<Pair>& values) {
    const std::size_t n = values.size();
    for (std::size_t k = 1; k < n; ++k) {
        const Pair carried = times(factors.lower[k], values[k - 1]);
        values[k].w -= carried.w;
        values[k].theta -= carried.theta;
    }
    values[n - 1] = times(factors.inverse[n - 1], values[n - 1]);
    for (std::size_t k = n - 1; k-- > 0;) {
        const Pair own = times(factors.inverse[k], values[k]);
        const Block& l = factors.lower[k + 1];
        const Pair& next = values[k + 1];
        values[k].w = own.w - product(l[0], next.w) - product(l[2], next.theta);
        values[k].theta = own.theta - product(l[1], next.w) - product(l[3], next.theta);
    }
}

}  // namespace railpem::simulate
