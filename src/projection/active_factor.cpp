#include "projection/active_factor.hpp"

#include <cmath>

namespace carom {

namespace {

std::vector<std::pair<int, int>> edges(std::span<const UnitNormal> normals)
{
    std::vector<std::pair<int, int>> out;
    for (const UnitNormal& n : normals)
        if (n.b) out.emplace_back(n.a, *n.b);
    return out;
}

}  // namespace

ActiveFactor::ActiveFactor(std::size_t vectors, std::span<const UnitNormal> normals)
    : normals_(normals), vectors_(vectors), cholesky_(static_cast<int>(vectors), edges(normals))
{
}

void ActiveFactor::follow(const std::vector<char>& active)
{
    const double scale = 1 / std::sqrt(small_epsilon);
    std::vector<BlockCholesky::Column> columns;
    for (std::size_t i = 0; i < active.size(); ++i)
        if (active[i]) columns.push_back(normals_[i].scaled(scale));
    cholesky_.factor(columns);
    active_ = active;
}

// (epsilon I + A A^T)^-1 wanted = (wanted - A (epsilon I + A^T A)^-1 A^T wanted) / epsilon, A = (a_1 a_2 ...)^T.
std::vector<double> ActiveFactor::multipliers(std::span<const double> wanted) const
{
    UnitVectors y(vectors_, BlockCholesky::Vector{});
    for (std::size_t i = 0; i < normals_.size(); ++i)
        if (active_[i]) normals_[i].add_to(y, wanted[i] / small_epsilon);
    cholesky_.solve(y);
    std::vector<double> out(normals_.size(), 0);
    for (std::size_t i = 0; i < normals_.size(); ++i)
        if (active_[i]) out[i] = (wanted[i] - normals_[i].dot(y)) / small_epsilon;
    return out;
}

}  // namespace carom
