/// \file
/// A thin QR factorisation whose columns come and go: A = Q R, Q with orthonormal columns. Sums run in the order of the
/// rows, so that every compiler gives the same bits.
#pragma once

#include <span>
#include <vector>

namespace carom {

/// Daniel, Gragg, Kaufman and Stewart, Reorthogonalization and stable algorithms for updating the Gram-Schmidt QR
/// factorization, Mathematics of Computation 30 (1976), https://doi.org/10.1090/S0025-5718-1976-0431641-8
class ThinQr {
public:
    explicit ThinQr(int rows) : rows_(rows) {}

    int rows() const { return rows_; }
    int columns() const { return static_cast<int>(triangle_.size()); }

    /// A column seen from A: column = A coefficients + residual, the residual orthogonal to A.
    struct Split {
        std::vector<double> along;         ///< Q^T column
        std::vector<double> coefficients;  ///< R^-1 Q^T column
        std::vector<double> residual;
        double residual_norm2 = 0;
    };
    Split split(std::span<const double> column) const;

    /// \pre residual_norm2 > 0, and no column came or went since the split
    void append(const Split& column);
    void remove(int column);

    /// (A^T A)^-1 b
    std::vector<double> solve_normal(std::span<const double> b) const;

private:
    double* q(int column) { return basis_.data() + static_cast<std::size_t>(column) * static_cast<std::size_t>(rows_); }
    const double* q(int column) const
    {
        return basis_.data() + static_cast<std::size_t>(column) * static_cast<std::size_t>(rows_);
    }
    void back_substitute(std::vector<double>& b) const;

    int rows_;
    std::vector<double> basis_;                  ///< Q, column after column
    std::vector<std::vector<double>> triangle_;  ///< column j of R, j + 1 numbers
};

}  // namespace carom
