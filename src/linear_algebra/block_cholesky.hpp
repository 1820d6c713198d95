/// \file
/// Sparse Cholesky factorisation of symmetric positive definite matrices made of 3 x 3 blocks: one row and column of
/// blocks a body, one block off the diagonal for bodies in contact. The sparsity is analysed once. Sums run in a fixed
/// order, so that every compiler gives the same bits.
#pragma once

#include "linear_algebra/block_pattern.hpp"

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace carom {

/// Left-looking; fill-reducing order: approximate minimum degree (Amestoy, Davis and Duff 1996, Eigen's). Davis, Direct
/// Methods for Sparse Linear Systems, 2006, https://doi.org/10.1137/1.9780898718881, section 4.
class BlockCholesky {
public:
    using Block = std::array<double, 9>;  ///< row after row
    using Vector = std::array<double, 3>;

    /// \param edges pairs of different blocks that may be coupled, each once
    BlockCholesky(int blocks, const std::vector<std::pair<int, int>>& edges);

    /// A term c c^T of the matrix, c = (first at block a, second at block b, if there is one).
    struct Column {
        int a = 0;
        std::optional<int> b;
        Vector first{}, second{};
    };

    /// Factors the unit matrix plus the terms of all columns. \pre a column's pair of blocks is an edge
    void factor(std::span<const Column> columns);

    /// Solves in place. \pre factor was called
    void solve(std::span<Vector> b) const;

private:
    const std::shared_ptr<const BlockPattern> pattern_;
    std::vector<Block> blocks_;  ///< of the factor, in the order of the pattern's rows
};

}  // namespace carom
