/// \file
/// The products of the half-spaces' normals that are active, as a sparse factor has them.
#pragma once

#include "math/shortest_change.hpp"

namespace carom {

/// As DenseProducts, for thousands of normals that each concern one vector or two. Those that depend on each other get
/// multipliers all the same, in the sense of least squares.
class SparseProducts {
public:
    /// \param normals outlive this
    SparseProducts(std::span<const UnitNormal> normals, std::size_t vectors)
        : normals_(normals), vectors_(vectors), factor_(vectors, normals)
    {
        factor_.take_epsilon(epsilon);
    }

    bool follow(const std::vector<char>& active)
    {
        factor_.follow(active);
        active_ = active;
        return true;
    }

    std::vector<double> multipliers(std::span<const double> wanted) const
    {
        return shortest_change(normals_, active_, wanted, vectors_, {&factor_, {}}).multipliers;
    }

private:
    /// Against squares of singular values, at most about 10: that of a tower of a thousand is 2.5e-6.
    static constexpr double epsilon = 1e-6;

    std::span<const UnitNormal> normals_;
    const std::size_t vectors_;
    ActiveFactor factor_;
    std::vector<char> active_;
};

}  // namespace carom
