/// \file
/// The places of the blocks of a sparse factor.
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace carom {

struct BlockPattern {
    std::vector<int> place;  ///< of a block in the order of elimination
    std::vector<int> begin;  ///< of the columns in `rows`; the diagonal comes first
    std::vector<int> rows;   ///< ascending within a column
    struct Left {
        int column, at;
    };
    std::vector<int> left_begin;
    std::vector<Left> left;  ///< by row: the blocks left of the diagonal
};

/// The pattern of the factor of a symmetric matrix of 3 x 3 blocks, in a fill-reducing order: approximate minimum
/// degree (Amestoy, Davis and Duff 1996, Eigen's). The last few are kept, since heaps ask for the same one again and
/// again.
/// \param edges pairs of different blocks that may be coupled, each once
std::shared_ptr<const BlockPattern> block_pattern(int blocks, const std::vector<std::pair<int, int>>& edges);

}  // namespace carom
