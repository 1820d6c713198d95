#include "verify/cone.hpp"

#include "verify/tolerances.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace carom::verification {

namespace {

/// Rest of v after the best multiple >= 0 of n.
Vec3 beside(const Vec3& n, const Vec3& v)
{
    return v - std::max(0.0, n.dot(v)) / n.squaredNorm() * n;
}

bool in_two(const Vec3& n, const Vec3& m, const Vec3& v, double slack)
{
    // Not by products of lengths: nearly opposite normals would cancel.
    const Vec3 across = n.cross(m);
    const double det = across.squaredNorm();
    if (!(det > 0)) return false;
    const double x = v.cross(m).dot(across) / det, y = n.cross(v).dot(across) / det;
    return x >= 0 && y >= 0 && x + y <= largest_multiple * v.norm() &&
           (v - x * n - y * m).norm() <= slack + normal_rounding * (x + y);
}

bool in_three(const Vec3& n, const Vec3& m, const Vec3& l, const Vec3& v, double slack)
{
    const double det = n.dot(m.cross(l));
    if (det == 0) return false;
    const double x = v.dot(m.cross(l)) / det, y = n.dot(v.cross(l)) / det, z = n.dot(m.cross(v)) / det;
    return x >= 0 && y >= 0 && z >= 0 && x + y + z <= largest_multiple * v.norm() &&
           (v - x * n - y * m - z * l).norm() <= slack + normal_rounding * (x + y + z);
}

}  // namespace

bool is_in_cone(std::vector<Vec3> normals, const Vec3& v, double slack)
{
    if (v.norm() <= slack) return true;
    std::sort(normals.begin(), normals.end(), [&](const Vec3& n, const Vec3& m) { return n.dot(v) > m.dot(v); });
    const std::size_t count = std::min(normals.size(), most_normals);
    for (std::size_t i = 0; i < count; ++i)
        if (beside(normals[i], v).norm() <= slack) return true;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (in_two(normals[i], normals[j], v, slack)) return true;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < i; ++j)
            for (std::size_t k = 0; k < j; ++k)
                if (in_three(normals[i], normals[j], normals[k], v, slack)) return true;
    return false;
}

}  // namespace carom::verification
