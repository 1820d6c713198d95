/// \file
/// Sets of numbers that are joined (Galler and Fischer 1964), each known by its smallest number; paths are halved.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace carom {

class DisjointSets {
public:
    /// The numbers 0 to count - 1, each in a set of its own.
    explicit DisjointSets(std::size_t count) : parent_(count)
    {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }

    /// The smallest number of x's set.
    std::size_t smallest(std::size_t x)
    {
        while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
        return x;
    }

    void join(std::size_t x, std::size_t y)
    {
        const std::size_t p = smallest(x), q = smallest(y);
        parent_[std::max(p, q)] = std::min(p, q);
    }

private:
    std::vector<std::size_t> parent_;
};

}  // namespace carom
