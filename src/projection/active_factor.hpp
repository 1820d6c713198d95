/// \file
/// The sparse factor that goes with the half-spaces which are active, as these come and go.
#pragma once

#include "projection/tolerances.hpp"
#include "projection/unit_normals.hpp"

#include <span>
#include <vector>

namespace carom {

/// Of I + sum a_i a_i^T / epsilon over the active ones among unit normals a_i. Dependent ones need no care: it is the
/// unit matrix and more.
class ActiveFactor {
public:
    /// \param vectors their number \param normals sparsity is that of all, active or not; they outlive this
    ActiveFactor(std::size_t vectors, std::span<const UnitNormal> normals);

    double epsilon() const { return epsilon_; }
    /// What was factored is forgotten.
    void take_epsilon(double epsilon);

    bool is_of(const std::vector<char>& active) const { return factored_ == active; }
    /// By updates, or anew where that is less work.
    void follow(const std::vector<char>& active);

    /// Solves in place. \pre follow was called
    void solve(std::span<BlockCholesky::Vector> b) const { cholesky_.solve(b); }

    int factorisations() const { return factorisations_; }
    int updates() const { return updates_; }

private:
    std::span<const UnitNormal> normals_;
    BlockCholesky cholesky_;
    double epsilon_ = 1;
    std::vector<char> factored_;  ///< by normal, or empty
    int factorisations_ = 0, updates_ = 0;
};

}  // namespace carom
