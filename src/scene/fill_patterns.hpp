/// \file
/// The places of a fill's spheres: one function for each pattern. Internal to `expand_fill`.
#pragma once

#include "scene/fill.hpp"

namespace carom {

struct Places {
    std::vector<Vec3> centres;  ///< one for each radius, in the same order [length]
    std::string problem;        ///< as in Filled
};

Places place(const LinePattern& line, const std::vector<double>& radii);
Places place(const TrianglePattern& triangle, const std::vector<double>& radii);
Places place(const CubicPattern& cubic, const std::vector<double>& radii);
Places place(const RandomPattern& random, const std::vector<double>& radii, const Scene& scene, std::uint64_t stream,
             Patience& patience);

}  // namespace carom
