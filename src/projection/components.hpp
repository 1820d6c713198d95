/// \file
/// Half-spaces that share vectors, directly or through others.
#pragma once

#include "projection/half_space.hpp"

namespace carom {

struct Component {
    std::vector<int> vectors;      ///< in ascending order
    std::vector<int> half_spaces;  ///< in the order in which they were chosen
};

/// \param chosen indices of half-spaces; vectors that none of them concerns are in no component
/// \returns components in the order of their first half-space
std::vector<Component> components(std::span<const HalfSpace> half_spaces, std::span<const int> chosen,
                                  std::size_t vectors);

/// The component as a problem of its own, vectors and half-spaces in the component's order.
ProjectionProblem part_of(const ProjectionProblem& whole, const Component& part);

}  // namespace carom
