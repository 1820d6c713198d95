/// \file
/// The sparse factor that goes with the half-spaces which are active.
#pragma once

#include "projection/tolerances.hpp"
#include "projection/unit_normals.hpp"

#include <span>
#include <vector>

namespace carom {

/// The factor of I + sum a_i a_i^T / small_epsilon over the active ones among unit normals a_i. Dependent normals need
/// no care: the matrix is the unit matrix and more.
class ActiveFactor {
public:
    /// \param vectors their number \param normals sparsity is that of all, active or not; they outlive this
    ActiveFactor(std::size_t vectors, std::span<const UnitNormal> normals);

    /// Factors the matrix of these active normals.
    void follow(const std::vector<char>& active);

    /// Multipliers x that nearly make (sum_j x_j a_j) . a_i = wanted_i for the active ones, dependent normals among
    /// them; 0 for the others. Asked again for what they leave, they leave small_epsilon / sigma^2 of it, sigma the
    /// singular values of the normals (the method of multipliers; Bertsekas, Constrained Optimization and Lagrange
    /// Multiplier Methods, 1982, chapter 2). \pre follow was called
    std::vector<double> multipliers(std::span<const double> wanted) const;

    /// Solves in place. \pre follow was called
    void solve(std::span<BlockCholesky::Vector> b) const { cholesky_.solve(b); }

private:
    std::span<const UnitNormal> normals_;
    std::size_t vectors_;
    BlockCholesky cholesky_;
    std::vector<char> active_;  ///< by normal
};

}  // namespace carom
