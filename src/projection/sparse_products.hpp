/// \file
/// The products of the half-spaces' normals that are active, as a sparse factor has them.
#pragma once

#include "projection/active_factor.hpp"
#include "projection/tolerances.hpp"

namespace carom {

/// As DenseProducts, for thousands of normals that each concern one vector or two. Those that depend on each other get
/// multipliers all the same. These are nearly right: asked again for what they leave, they leave epsilon / sigma^2 of
/// it, sigma the singular values of the normals (the method of multipliers; Bertsekas, Constrained Optimization and
/// Lagrange Multiplier Methods, 1982, chapter 2).
class SparseProducts {
public:
    /// \param normals outlive this
    SparseProducts(std::span<const UnitNormal> normals, std::size_t vectors)
        : normals_(normals), vectors_(vectors), factor_(vectors, normals)
    {
        factor_.take_epsilon(small_epsilon);
    }

    bool follow(const std::vector<char>& active)
    {
        factor_.follow(active);
        active_ = active;
        return true;
    }

    /// (epsilon I + A A^T)^-1 wanted = (wanted - A (epsilon I + A^T A)^-1 A^T wanted) / epsilon, A = (a_1 a_2 ...)^T
    std::vector<double> multipliers(std::span<const double> wanted) const
    {
        UnitVectors y(vectors_, BlockCholesky::Vector{});
        for (std::size_t i = 0; i < normals_.size(); ++i)
            if (active_[i]) normals_[i].add_to(y, wanted[i] / small_epsilon);
        factor_.solve(y);
        std::vector<double> out(normals_.size(), 0);
        for (std::size_t i = 0; i < normals_.size(); ++i)
            if (active_[i]) out[i] = (wanted[i] - normals_[i].dot(y)) / small_epsilon;
        return out;
    }

    static constexpr int refinements = sparse_refinements;  ///< see DenseProducts

private:
    std::span<const UnitNormal> normals_;
    const std::size_t vectors_;
    ActiveFactor factor_;
    std::vector<char> active_;
};

}  // namespace carom
