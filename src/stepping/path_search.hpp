/// \file
/// Contacts ahead: what the spheres may touch in the time to come, if they went on straight.
#pragma once

#include "stepping/bodies.hpp"
#include "stepping/contact.hpp"
#include "stepping/detection.hpp"

#include <cstdint>
#include <vector>

namespace carom::stepping {

/// A look ahead.
struct Reach {
    double time = 0;  ///< h, how far ahead [time]
    /// Distance that a path may stray from straight, against what does not move [length].
    double bend = 0;
};

/// Finds contacts by the paths of spheres: all pairs for few of them; for many a grid for the balls that hold their
/// paths. Results do not depend on which.
class PathSearch {
public:
    explicit PathSearch(std::size_t spheres);

    /// Append, in index order (pairs by a, b; then walls by sphere, plane), every contact whose gap comes below
    /// `speculative_margin` of the smaller radius within the reach, at these velocities, with the gap and the normal of
    /// now. A plate is met on the side where the centre is now. Whoever passes by at that distance is among them.
    void find(const Bodies& bodies, Detector& detector, const Reach& reach, std::vector<Contact>& contacts);

private:
    void find_pairs(const Bodies& bodies, Detector& detector, const Reach& reach, std::vector<Contact>& contacts);
    void find_walls(const Bodies& bodies, Detector& detector, const Reach& reach, std::vector<Contact>& contacts);
    void test_near(const Bodies& bodies, Detector& detector, const Reach& reach);
    void test(const Bodies& bodies, Detector& detector, const Reach& reach, std::size_t i, std::size_t j);

    bool tests_all_pairs_;
    std::vector<double> reach_;  ///< of each sphere, from its centre: whatever it may meet is in it [length]
    std::vector<std::uint64_t> found_;
};

}  // namespace carom::stepping
