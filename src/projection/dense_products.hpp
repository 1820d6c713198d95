/// \file
/// The products of the half-spaces' normals that are active, factored as a dense matrix.
#pragma once

#include "projection/tolerances.hpp"
#include "projection/unit_normals.hpp"

#include <span>
#include <vector>

namespace carom {

/// L D L^T of (a_i . a_j), a_i unit normals. For some hundred at most.
class DenseProducts {
public:
    /// \param normals outlive this
    explicit DenseProducts(std::span<const UnitNormal> normals) : normals_(normals) {}

    /// \returns false where active normals depend on each other
    bool follow(const std::vector<char>& active);

    /// Multipliers x of the active ones, with (sum_j x_j a_j) . a_i = wanted_i. Those of the others are 0.
    /// \pre follow returned true
    std::vector<double> multipliers(std::span<const double> wanted) const;

    static constexpr int refinements = dense_refinements;  ///< what multipliers leave is worth asking for so often

private:
    double product(std::size_t k, std::size_t l) const;

    std::span<const UnitNormal> normals_;
    std::vector<std::size_t> active_;
    std::vector<double> factor_;  ///< lower triangle by columns: those of L times D
};

}  // namespace carom
