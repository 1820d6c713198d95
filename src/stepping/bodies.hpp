/// \file
/// The spheres of a run as arrays, and their free motion.
#pragma once

#include <carom/scene.hpp>

#include <cstddef>
#include <vector>

namespace carom::stepping {

struct Bodies {
    std::vector<Vec3> position;        ///< centre [length]
    std::vector<Vec3> velocity;        ///< [length/time]
    std::vector<double> radius;        ///< [length]
    std::vector<double> mass;          ///< [mass]
    std::vector<double> inverse_mass;  ///< [1/mass]
    std::vector<int> material;         ///< index into Scene::materials

    std::size_t size() const { return position.size(); }
};

Bodies make_bodies(const Scene& scene);

/// v += h g for all.
void accelerate(Bodies& bodies, const Vec3& gravity, double h);
/// p += h v for all.
void move(Bodies& bodies, double h);

/// Index of the first sphere without a finite position, size() if there is none.
std::size_t first_diverged(const Bodies& bodies);

}  // namespace carom::stepping
