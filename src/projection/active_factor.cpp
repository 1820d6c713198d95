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
    : normals_(normals), cholesky_(static_cast<int>(vectors), edges(normals))
{
}

void ActiveFactor::take_epsilon(double epsilon)
{
    epsilon_ = epsilon;
    factored_.clear();
}

void ActiveFactor::follow(const std::vector<char>& active)
{
    const double scale = 1 / std::sqrt(epsilon_);
    std::vector<std::size_t> changed;
    double cost = 0;
    for (std::size_t i = 0; i < factored_.size(); ++i)
        if (active[i] != factored_[i]) {
            changed.push_back(i);
            cost += update_price * cholesky_.update_cost(normals_[i]);
        }
    if (factored_.empty() || cost > cholesky_.factor_cost()) {
        std::vector<BlockCholesky::Column> columns;
        for (std::size_t i = 0; i < active.size(); ++i)
            if (active[i]) columns.push_back(normals_[i].scaled(scale));
        cholesky_.factor(columns);
        ++factorisations_;
    } else {
        for (const std::size_t i : changed) cholesky_.update(normals_[i].scaled(scale), active[i] ? 1 : -1);
        updates_ += static_cast<int>(changed.size());
    }
    factored_ = active;
}

}  // namespace carom
