/// \file
/// The spheres of a run as arrays.
#pragma once

#include <carom/simulate.hpp>

#include <cstddef>
#include <vector>

namespace carom::stepping {

struct Bodies {
    std::vector<Vec3> position;  ///< centre, absolute: a far origin costs digits here, as it does in reality [length]
    std::vector<Vec3> velocity;  ///< [length/time]
    std::vector<double> radius;  ///< [length]
    std::vector<double> mass;    ///< [mass]
    std::vector<double> inverse_mass;  ///< 0: fixed [1/mass]
    std::vector<int> material;         ///< index into Scene::materials
    std::vector<std::size_t> fixed;    ///< those that never move
    Vec3 origin = Vec3::Zero();        ///< of the scene: what the rest of the world counts from [length]

    std::size_t size() const { return position.size(); }
};

Bodies make_bodies(const Scene& scene);

/// The states as everybody else sees them: relative to the scene's origin.
void show_states(const Bodies& bodies, std::vector<BodyState>& states);

/// Index of the first sphere without a finite position, size() if there is none.
std::size_t first_diverged(const Bodies& bodies);

}  // namespace carom::stepping
