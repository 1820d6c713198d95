/// \file
/// Rules that a scene must keep, beyond the types of its fields.
#pragma once

#include "core/patience.hpp"

#include <carom/scene.hpp>
#include <string>
#include <vector>

namespace carom {

/// The place in the file of each body of a scene, for messages. Empty: "/spheres/3", "/planes/0".
struct BodyPlaces {
    std::vector<std::string> spheres, planes;  ///< JSON pointers; empty or one for each body

    std::string sphere(std::size_t i) const;
    std::string plane(std::size_t p) const;
};

/// The public `validate` with the places of a file. Without patience, here and below: of no use, whatever it is.
std::vector<std::string> validate(const Scene& scene, bool allow_overlap, const BodyPlaces& places, Patience& patience);

/// Ids that two bodies share, naming both places.
std::vector<std::string> find_duplicate_ids(const Scene& scene, const BodyPlaces& places, Patience& patience);

/// Centres inside a plate; unless `allow_overlap`, also every pair of bodies with gap < -1e-9 r, r the smaller radius.
/// Pairs of which neither can move (a fixed sphere and another one or a plane) may overlap as they like. The first 20
/// are named, the rest is counted. \pre positions and radii are finite, radii > 0.
std::vector<std::string> find_overlaps(const Scene& scene, bool allow_overlap, const BodyPlaces& places,
                                       Patience& patience);
std::vector<std::string> find_overlaps(const Scene& scene, bool allow_overlap);

}  // namespace carom
