// Random sequential insertion: Widom, J. Chem. Phys. 44, 3888 (1966).
#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "core/text.hpp"
#include "scene/fill_patterns.hpp"
#include "scene/pair_gap.hpp"
#include "scene/sphere_grid.hpp"
#include "scene/tolerances.hpp"

namespace carom {

namespace {

/// The spheres placed so far and the bodies that were there before.
class Crowd {
public:
    /// \param radii of those to come
    Crowd(const Scene& scene, const std::vector<double>& radii_to_come) : scene_(scene), placed_(radii_to_come)
    {
        std::vector<double> radii;
        for (const auto& s : scene.spheres) radii.push_back(s.radius);
        for (const std::size_t i : largest_first(radii)) earlier_.insert(i, scene.spheres[i].position, radii[i]);
    }

    bool has_room(const Vec3& centre, double radius) const
    {
        const double margin = least_random_gap * radius;
        Sphere candidate;
        candidate.radius = radius;
        for (const auto& plane : scene_.planes)
            if (plane_gap(plane, candidate, centre) < margin) return false;
        bool room = true;
        earlier_.visit_near(centre, radius + margin, [&](std::size_t i) {
            const Sphere& s = scene_.spheres[i];
            return room = sphere_gap(centre, radius, s.position, s.radius) >= margin;
        });
        if (!room) return false;
        placed_.visit_near(centre, radius + margin, [&](std::size_t k) {
            return room = sphere_gap(centre, radius, centres_[k], radii_[k]) >= margin;
        });
        return room;
    }
    void add(const Vec3& centre, double radius)
    {
        placed_.insert(centres_.size(), centre, radius);
        centres_.push_back(centre);
        radii_.push_back(radius);
    }

private:
    const Scene& scene_;
    SphereGrid earlier_, placed_;
    std::vector<Vec3> centres_;
    std::vector<double> radii_;
};

Vec3 place_in(const Region& region, double radius, Random& random)
{
    const double x = random.uniform(region.min.x() + radius, region.max.x() - radius);
    const double y = random.uniform(region.min.y() + radius, region.max.y() - radius);
    const double z = random.uniform(region.min.z() + radius, region.max.z() - radius);
    return {x, y, z};
}

std::string too_dense(const Region& region, const std::vector<double>& radii)
{
    const Vec3 size = region.max - region.min;
    double volume = 0;
    for (const double r : radii) volume += sphere_mass(1, r);
    const double fraction = volume / (size.x() * size.y() * size.z());
    const auto n = static_cast<double>(radii.size());
    // Each term of the sum rounds once more.
    if (!(fraction > largest_random_fraction * (1 + fraction_rounding + n * term_rounding))) return "";
    return "/count: packing fraction " + to_text(fraction, 4) + " is above " + to_text(largest_random_fraction) +
           " for pattern \"random\": not yet supported (take at most " +
           to_text(std::floor(n * largest_random_fraction / fraction)) + " spheres, a larger region, or \"cubic\")";
}

}  // namespace

Places place(const RandomPattern& pattern, const std::vector<double>& radii, const Scene& scene, std::uint64_t stream,
             Patience& patience)
{
    const Region& region = pattern.region;
    Places places;
    const double largest = *std::max_element(radii.begin(), radii.end());
    if (2 * largest >= (region.max - region.min).minCoeff()) {
        places.problem = "/radius: a sphere of radius " + to_text(largest) +
                         " does not fit into the region (take a smaller one, or a larger region)";
        return places;
    }
    places.problem = too_dense(region, radii);
    if (!places.problem.empty()) return places;

    Random random(scene.seed, stream);
    Crowd crowd(scene, radii);
    places.centres.assign(radii.size(), Vec3::Zero());
    std::size_t tries_left = first_random_tries + most_mean_random_tries * radii.size();
    std::size_t placed = 0;
    for (const std::size_t k : largest_first(radii)) {
        bool found = false;
        for (std::size_t t = 0; t < most_random_tries && tries_left > 0 && !found; ++t, --tries_left) {
            if (!patience.lasts_for(1)) return places;
            places.centres[k] = place_in(region, radii[k], random);
            found = crowd.has_room(places.centres[k], radii[k]);
        }
        if (!found) {
            places.problem = "/count: found no room for more than " + std::to_string(placed) + " of " +
                             std::to_string(radii.size()) +
                             " spheres (take fewer or smaller ones, a larger region, or pattern \"cubic\")";
            return places;
        }
        crowd.add(places.centres[k], radii[k]);
        patience.reach(static_cast<double>(++placed));
    }
    return places;
}

}  // namespace carom
