#include "simulate/numerics/block_tridiagonal.hpp"

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

Block transposed(const Block& a) {
    return {a[0], a[2], a[1], a[3]};
}

/// target −= a·x.
inline void subtract(Pair& target, const Block& a, const Pair& x) {
    target.w -= product(a[0], x.w) + product(a[1], x.theta);
    target.theta -= product(a[2], x.w) + product(a[3], x.theta);
}

/// own = inverse·own − carryᵀ·solved: back substitution at one node.
inline void substitute(Pair& own, const Block& inverse, const Block& carry, const Pair& solved) {
    const Complex w = product(inverse[0], own.w) + product(inverse[1], own.theta);
    const Complex theta = product(inverse[2], own.w) + product(inverse[3], own.theta);
    own.w = w - product(carry[0], solved.w) - product(carry[2], solved.theta);
    own.theta = theta - product(carry[1], solved.w) - product(carry[3], solved.theta);
}

Block reduced(const Block& diagonal, const Block& carry, const Block& coupling) {
    const Block removed = times(carry, coupling);
    Block left = diagonal;
    for (std::size_t i = 0; i < 4; ++i) left[i] -= removed[i];
    return left;
}

}  // namespace

void factorise(const BlockTridiagonal& matrix, BlockFactors& factors) {
    const std::size_t n = matrix.diagonal.size();
    const std::size_t middle = n / 2;
    factors.inverse.resize(n);
    factors.carry.assign(n, Block{});
    std::vector<Block> diagonal = matrix.diagonal;
    for (std::size_t k = 0; k < middle; ++k) {
        factors.inverse[k] = inverse_of(diagonal[k]);
        factors.carry[k] = times(transposed(matrix.upper[k]), factors.inverse[k]);
        diagonal[k + 1] = reduced(diagonal[k + 1], factors.carry[k], matrix.upper[k]);
    }
    for (std::size_t k = n - 1; k > middle; --k) {
        factors.inverse[k] = inverse_of(diagonal[k]);
        factors.carry[k] = times(matrix.upper[k - 1], factors.inverse[k]);
        diagonal[k - 1] = reduced(diagonal[k - 1], factors.carry[k], transposed(matrix.upper[k - 1]));
    }
    factors.inverse[middle] = inverse_of(diagonal[middle]);
}

void solve(const BlockFactors& factors, std::vector<Pair>& values) {
    const std::size_t n = values.size();
    const std::size_t middle = n / 2;          // nodes before it
    const std::size_t after = n - 1 - middle;  // nodes behind it: as many, or one fewer
    if (middle > after) subtract(values[1], factors.carry[0], values[0]);
    const std::size_t first = middle - after;
    for (std::size_t i = 0; i < after; ++i) {
        const std::size_t left = first + i;
        const std::size_t right = n - 1 - i;
        subtract(values[left + 1], factors.carry[left], values[left]);
        subtract(values[right - 1], factors.carry[right], values[right]);
    }
    substitute(values[middle], factors.inverse[middle], Block{}, Pair{});
    for (std::size_t i = after; i-- > 0;) {
        const std::size_t left = first + i;
        const std::size_t right = n - 1 - i;
        substitute(values[left], factors.inverse[left], factors.carry[left], values[left + 1]);
        substitute(values[right], factors.inverse[right], factors.carry[right], values[right - 1]);
    }
    if (middle > after) substitute(values[0], factors.inverse[0], factors.carry[0], values[1]);
}

}  // namespace railpem::simulate
