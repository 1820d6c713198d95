/// \file
/// Can contacts with these normals push like this?
#pragma once

#include <carom/types.hpp>

#include <vector>

namespace carom::verification {

/// Is the vector a sum of the normals with coefficients >= 0, but for `slack`? By Caratheodory three of them are
/// enough: all sets of up to three are tried, of those that point most along the vector.
bool is_in_cone(std::vector<Vec3> normals, const Vec3& vector, double slack);

}  // namespace carom::verification
