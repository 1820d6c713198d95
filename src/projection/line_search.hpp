/// \file
/// Exact line search on |y|^2 / 2 + epsilon/2 sum max(0, t_i)^2, whose derivative along a line is piecewise linear.
#pragma once

#include "projection/unit_normals.hpp"

namespace carom {

/// \param y, direction the line y + tau direction
/// \param t at y; along the line t_i - tau rate_i / epsilon
/// \returns tau >= 0 of the minimum
double line_search(const UnitVectors& y, const UnitVectors& direction, std::span<const double> t,
                   std::span<const double> rate, double epsilon);

}  // namespace carom
