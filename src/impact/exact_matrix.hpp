/// \file
/// Small dense matrices in double-double.
#pragma once

#include "math/double_double.hpp"

#include <span>
#include <vector>

namespace carom {

using Numbers = std::vector<DoubleDouble>;

/// A square matrix, row by row.
struct Matrix {
    std::size_t size = 0;
    Numbers entries = Numbers(size * size);

    DoubleDouble& operator()(std::size_t i, std::size_t j) { return entries[i * size + j]; }
    const DoubleDouble& operator()(std::size_t i, std::size_t j) const { return entries[i * size + j]; }
};

inline Matrix operator*(const Matrix& a, const Matrix& b)
{
    Matrix out{a.size};
    for (std::size_t i = 0; i < a.size; ++i)
        for (std::size_t k = 0; k < a.size; ++k)
            for (std::size_t j = 0; j < a.size; ++j) out(i, j) = out(i, j) + a(i, k) * b(k, j);
    return out;
}

inline Numbers operator*(const Matrix& a, const Numbers& x)
{
    Numbers out(a.size);
    for (std::size_t i = 0; i < a.size; ++i)
        for (std::size_t j = 0; j < a.size; ++j) out[i] = out[i] + a(i, j) * x[j];
    return out;
}

/// Solves with a positive definite matrix, for several right sides: `columns` numbers a row.
inline void solve(Matrix a, std::span<DoubleDouble> right, std::size_t columns)
{
    const std::size_t n = a.size;
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t i = k + 1; i < n; ++i) {
            const DoubleDouble factor = a(i, k) / a(k, k);
            for (std::size_t j = k + 1; j < n; ++j) a(i, j) = a(i, j) - factor * a(k, j);
            for (std::size_t c = 0; c < columns; ++c)
                right[i * columns + c] = right[i * columns + c] - factor * right[k * columns + c];
        }
    }
    for (std::size_t i = n; i-- > 0;)
        for (std::size_t c = 0; c < columns; ++c) {
            for (std::size_t j = i + 1; j < n; ++j)
                right[i * columns + c] = right[i * columns + c] - a(i, j) * right[j * columns + c];
            right[i * columns + c] = right[i * columns + c] / a(i, i);
        }
}

}  // namespace carom
