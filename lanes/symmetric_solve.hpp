#pragma once

#include <cassert>
#include <vector>

#include "lanes/complex_lanes.hpp"

namespace railpem::lanes {

/// A dense complex symmetric (not Hermitian) matrix per lane, lower triangle, factorised in place as L·D·Lᵀ without
/// pivoting. Dynamic stiffness matrices of damped structures are regular in every leading block unless an undamped
/// substructure resonates exactly on a line.
class SymmetricMatrix {
  public:
    explicit SymmetricMatrix(int size) : size_(size), entries_(static_cast<std::size_t>(size * (size + 1) / 2)) {}

    int size() const { return size_; }
    void clear() {
        for (Complex& entry : entries_) entry = Complex{};
    }
    /// Entry (row, column) of the lower triangle: row ≥ column.
    Complex& operator()(int row, int column) {
        assert(row >= column);
        return entries_[static_cast<std::size_t>(row * (row + 1) / 2 + column)];
    }
    const Complex& operator()(int row, int column) const {
        assert(row >= column);
        return entries_[static_cast<std::size_t>(row * (row + 1) / 2 + column)];
    }

    /// Replaces the matrix by its factors; D is stored inverted.
    void factorise() {
        for (int j = 0; j < size_; ++j) {
            (*this)(j, j) = reciprocal((*this)(j, j));
            for (int i = j + 1; i < size_; ++i) {
                const Complex l = (*this)(i, j) * (*this)(j, j);
                for (int k = j + 1; k <= i; ++k) (*this)(i, k) -= l * (*this)(k, j);
            }
            for (int i = j + 1; i < size_; ++i) (*this)(i, j) = (*this)(i, j) * (*this)(j, j);
        }
    }

    /// Solves in place for one right-hand side that is zero before row `first` (after factorise()).
    void solve(Complex* x, int first = 0) const {
        for (int j = first; j < size_; ++j)
            for (int i = j + 1; i < size_; ++i) x[i] -= (*this)(i, j) * x[j];
        for (int j = first; j < size_; ++j) x[j] = x[j] * (*this)(j, j);
        for (int j = size_ - 1; j >= 0; --j)
            for (int i = j + 1; i < size_; ++i) x[j] -= (*this)(i, j) * x[i];
    }

  private:
    int size_;
    std::vector<Complex> entries_;
};

}  // namespace railpem::lanes
