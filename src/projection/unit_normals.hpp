/// \file
/// Half-spaces in the metric's own coordinates y_k = (x_k - start_k) / sqrt(w_k), with normals of length 1: there the
/// metric is the Euclidean one and nothing has a scale.
#pragma once

#include "linear_algebra/block_cholesky.hpp"
#include "projection/half_space.hpp"

namespace carom {

using UnitVectors = std::vector<BlockCholesky::Vector>;

/// A half-space's normal: of length 1, not zero in the blocks of at most two vectors.
struct UnitNormal : BlockCholesky::Column {
    double length = 1;  ///< before it was made 1

    UnitNormal(const HalfSpace& h, std::span<const double> w)
        : BlockCholesky::Column{h.a, h.b, {}, {}}, length(std::sqrt(normal_length2(h, w)))
    {
        const double part_a = std::sqrt(w[static_cast<std::size_t>(h.a)]) / length;
        const double part_b = h.b ? -std::sqrt(w[static_cast<std::size_t>(*h.b)]) / length : 0;
        for (std::size_t k = 0; k < 3; ++k) {
            first[k] = part_a * h.normal[static_cast<int>(k)];
            second[k] = part_b * h.normal[static_cast<int>(k)];
        }
    }

    double dot(const UnitVectors& y) const
    {
        const auto part = [](const BlockCholesky::Vector& p, const BlockCholesky::Vector& q) {
            return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
        };
        const double at_a = part(first, y[static_cast<std::size_t>(a)]);
        return b ? at_a + part(second, y[static_cast<std::size_t>(*b)]) : at_a;
    }

    /// y += factor times this
    void add_to(UnitVectors& y, double factor) const
    {
        for (std::size_t k = 0; k < 3; ++k) y[static_cast<std::size_t>(a)][k] += factor * first[k];
        if (!b) return;
        for (std::size_t k = 0; k < 3; ++k) y[static_cast<std::size_t>(*b)][k] += factor * second[k];
    }

    BlockCholesky::Column scaled(double factor) const
    {
        BlockCholesky::Column out = *this;
        for (double& x : out.first) x *= factor;
        for (double& x : out.second) x *= factor;
        return out;
    }
};

inline std::vector<UnitNormal> unit_normals(const ProjectionProblem& problem)
{
    std::vector<UnitNormal> out;
    out.reserve(problem.half_spaces.size());
    for (const HalfSpace& h : problem.half_spaces) out.emplace_back(h, problem.w);
    return out;
}

}  // namespace carom
