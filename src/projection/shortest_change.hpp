/// \file
/// The shortest of all changes that do what is wanted along given directions.
#pragma once

#include "projection/active_factor.hpp"

namespace carom {

struct ShortestChange {
    UnitVectors change;
    std::vector<double> multipliers;  ///< by normal, change = sum multiplier_i a_i (not always the only ones)
};

struct ShortestChangeOptions {
    /// Of these normals, the same ones active: saves steps. Null for none.
    const ActiveFactor* factor = nullptr;
    /// By vector, or empty: no vector changes by more. Where it would, what was found until then is the result.
    std::span<const double> furthest = {};
};

/// min |y| with a_i.y = wanted_i, in the sense of least squares where these contradict one another; normals whose
/// `active` is 0 want nothing and get no multiplier. CGLS (Hestenes and Stiefel 1952; Bjoerck, Numerical Methods for
/// Least Squares Problems, 1996, sections 7.4 and 7.4.1), which dependent normals do no harm; work is bounded. Ours:
/// the factor's matrix as a preconditioner. It is a function of the normals' own matrix, so that the result stays the
/// shortest; directions along which the normals hardly act (singular values below sqrt(epsilon)) come last.
ShortestChange shortest_change(std::span<const UnitNormal> normals, const std::vector<char>& active,
                               std::span<const double> wanted, std::size_t vectors,
                               const ShortestChangeOptions& options = {});

}  // namespace carom
