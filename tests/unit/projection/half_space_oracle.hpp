/// \file
/// Projection by trying every set of active half-spaces, in long double: slow, and shares nothing with the engine.
#pragma once

#include "projection/half_space.hpp"

#include <Eigen/Dense>
#include <optional>

namespace carom::test {

using Long = long double;
using LongMatrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<Long, Eigen::Dynamic, 1>;

/// The half-spaces' normals as columns, in coordinates x_k / sqrt(w_k).
inline LongMatrix normals_of(const ProjectionProblem& problem)
{
    const auto n = static_cast<Eigen::Index>(3 * problem.start.size());
    LongMatrix out = LongMatrix::Zero(n, static_cast<Eigen::Index>(problem.half_spaces.size()));
    for (std::size_t i = 0; i < problem.half_spaces.size(); ++i) {
        const HalfSpace& h = problem.half_spaces[i];
        const auto column = static_cast<Eigen::Index>(i);
        out.block(3 * h.a, column, 3, 1) =
            std::sqrt(static_cast<Long>(problem.w[static_cast<std::size_t>(h.a)])) * h.normal.cast<Long>();
        if (h.b)
            out.block(3 * *h.b, column, 3, 1) =
                -std::sqrt(static_cast<Long>(problem.w[static_cast<std::size_t>(*h.b)])) * h.normal.cast<Long>();
    }
    return out;
}

/// Of all independent active sets the one whose point and multipliers satisfy every condition best.
inline std::vector<Vec3> project_by_trying(const ProjectionProblem& problem)
{
    const LongMatrix normals = normals_of(problem);
    const auto m = normals.cols();
    LongVector start(normals.rows()), offset(m);
    for (std::size_t k = 0; k < problem.start.size(); ++k)
        start.segment(static_cast<Eigen::Index>(3 * k), 3) =
            problem.start[k].cast<Long>() / std::sqrt(static_cast<Long>(problem.w[k]));
    for (Eigen::Index i = 0; i < m; ++i) offset[i] = problem.half_spaces[static_cast<std::size_t>(i)].offset;
    const LongVector slack = normals.transpose() * start + offset;

    Long least = 1e300L;
    LongVector best = start;
    for (unsigned set = 0; set < 1u << m; ++set) {
        std::vector<Eigen::Index> active;
        for (Eigen::Index i = 0; i < m; ++i)
            if (set >> i & 1u) active.push_back(i);
        LongMatrix columns(normals.rows(), static_cast<Eigen::Index>(active.size()));
        LongVector wanted(columns.cols());
        for (std::size_t j = 0; j < active.size(); ++j) {
            const auto column = static_cast<Eigen::Index>(j);
            columns.col(column) = normals.col(active[j]);
            wanted[column] = -slack[active[j]];
        }
        LongVector point = start;
        Long fault = 0;
        if (!active.empty()) {
            Eigen::FullPivLU<LongMatrix> gram(columns.transpose() * columns);
            gram.setThreshold(1e-15L);
            if (gram.rank() < columns.cols()) continue;
            const LongVector multipliers = gram.solve(wanted);
            point += columns * multipliers;
            for (Eigen::Index j = 0; j < columns.cols(); ++j)
                fault = std::max(fault, -multipliers[j] * columns.col(j).norm());
        }
        const LongVector after = normals.transpose() * point + offset;
        for (Eigen::Index i = 0; i < m; ++i) fault = std::max(fault, -after[i] / normals.col(i).norm());
        if (fault < least) {
            least = fault;
            best = point;
        }
    }
    std::vector<Vec3> out;
    for (std::size_t k = 0; k < problem.start.size(); ++k)
        out.push_back((best.segment(static_cast<Eigen::Index>(3 * k), 3) * std::sqrt(static_cast<Long>(problem.w[k])))
                          .cast<double>());
    return out;
}

}  // namespace carom::test
