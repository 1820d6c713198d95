/// \file
/// The deepest overlap of a state, again and again for one scene: what does not change is prepared once.
#pragma once

#include "stepping/detection.hpp"

#include <carom/simulate.hpp>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace carom::study {

class DeepestOverlap {
public:
    explicit DeepestOverlap(const Scene& scene);

    /// As max_penetration, in time proportional to spheres, overlaps, and spheres times planes [length].
    double of(std::span<const BodyState> states);

    std::int64_t pair_tests() const { return detector_.tests; }  ///< pairs of spheres whose gap was examined so far

private:
    /// The box around all centres.
    struct Bounds {
        Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;  // [length]
        void add(const Vec3& p);
        /// The corner that is the furthest against a normal.
        Vec3 lowest(const Vec3& normal) const;
    };
    double deepest_in_walls(const Bounds& bounds) const;

    std::vector<double> radius_;         ///< by body [length]
    double largest_radius_ = 0;          ///< [length]
    std::vector<Vec3> position_;         ///< by body, of the state looked at [length]
    stepping::Detector detector_;        ///< of pairs; its walls are at absolute places
    std::vector<stepping::Wall> walls_;  ///< relative to the scene's origin, as states are
    std::vector<stepping::Contact> overlaps_;
};

}  // namespace carom::study
