#pragma once

#include <array>
#include <vector>

#include "simulate/numerics/radau_step.hpp"

namespace railpem::simulate {

/// Complex 2×2 block, row by row, and the pair of values at a node.
using Block = std::array<Complex, 4>;
struct Pair {
    Complex w, theta;
};

/// Complex symmetric block-tridiagonal matrix with 2×2 blocks: the rail with all that hangs on its nodes.
struct BlockTridiagonal {
    std::vector<Block> diagonal;  ///< symmetric blocks
    std::vector<Block> upper;     ///< block (k, k + 1); the lower one is its transpose
};

/// Block elimination from both ends towards the middle, without pivoting: the real part of every leading block is
/// positive definite for the matrices M·s² + C·s + K with the Radau step's s (|arg s| < 45°). Two ends at once because
/// each elimination waits for the one before it: the processor works on both chains at a time.
struct BlockFactors {
    std::vector<Block> inverse;  ///< of the reduced diagonal blocks
    std::vector<Block> carry;    ///< what node k hands on to its neighbour nearer to the middle
};

void factorise(const BlockTridiagonal& matrix, BlockFactors& factors);

/// Solves in place: `values` is the right-hand side, then the solution.
void solve(const BlockFactors& factors, std::vector<Pair>& values);

}  // namespace railpem::simulate
