#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "scene/pair_gap.hpp"
#include "scene/sphere_grid.hpp"
#include "scene/tolerances.hpp"
#include "scene/validate.hpp"

namespace carom {

namespace {

struct Overlap {
    std::size_t a, b;
    double depth;
};

std::vector<Overlap> overlapping_spheres(const std::vector<Sphere>& spheres, Patience& patience)
{
    std::vector<double> radii;
    radii.reserve(spheres.size());
    for (const auto& s : spheres) radii.push_back(s.radius);
    std::vector<Overlap> found;
    SphereGrid grid(radii);
    std::size_t done = 0;
    patience.begin("overlaps", static_cast<double>(spheres.size()), "spheres");
    for (const std::size_t i : largest_first(radii)) {
        if (patience.ended()) break;
        const Sphere& s = spheres[i];
        grid.visit_near(s.position, s.radius, [&](std::size_t j) {
            if (s.fixed && spheres[j].fixed) return true;
            const double gap = sphere_gap(s.position, s.radius, spheres[j].position, spheres[j].radius);
            if (gap < -declared_contact * s.radius) found.push_back({std::min(i, j), std::max(i, j), -gap});
            return found.size() < most_overlaps_counted && patience.lasts_for(1);
        });
        if (found.size() >= most_overlaps_counted) break;
        grid.insert(i, s.position, s.radius);
        patience.reach(static_cast<double>(++done));
        patience.lasts_for(1);
    }
    std::sort(found.begin(), found.end(),
              [](const Overlap& x, const Overlap& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    return found;
}

bool centre_inside(const Plane& plate, const Sphere& s)
{
    return plate.thickness && std::abs(plate.normal.dot(s.position) - plate.offset) <= *plate.thickness / 2;
}

/// Whether the centre lies on the wrong side of a half-space: most often its normal is turned round.
bool centre_behind(const Plane& plane, const Sphere& s)
{
    return !plane.thickness && plane.normal.dot(s.position) < plane.offset;
}

std::vector<Overlap> overlapping_planes(const Scene& scene, Patience& patience)
{
    std::vector<Overlap> found;
    for (std::size_t i = 0; i < scene.spheres.size() && patience.lasts_for(scene.planes.size()); ++i)
        for (std::size_t p = 0; p < scene.planes.size(); ++p) {
            const Sphere& s = scene.spheres[i];
            if (s.fixed || centre_inside(scene.planes[p], s)) continue;  // a centre inside is an error of its own
            const double gap = plane_gap(scene.planes[p], s, s.position);
            if (gap < -declared_contact * s.radius) found.push_back({i, p, -gap});
        }
    return found;
}

std::string enough(double depth)
{
    return to_text(depth * overlap_rounded_up, 4);
}

std::string depth(double depth)
{
    return " by " + to_text(depth, 6);
}

std::string cure(double depth)
{
    return "move one by at least " + enough(depth) + ", or pass --allow-overlap)";
}

std::vector<std::string> centres_inside_plates(const Scene& scene, const BodyPlaces& places, Patience& patience)
{
    std::vector<std::string> lines;
    if (std::none_of(scene.planes.begin(), scene.planes.end(), [](const Plane& p) { return p.thickness.has_value(); }))
        return lines;
    for (std::size_t i = 0; i < scene.spheres.size() && patience.lasts_for(scene.planes.size()); ++i)
        for (std::size_t p = 0; p < scene.planes.size(); ++p) {
            const Sphere& s = scene.spheres[i];
            const Plane& plane = scene.planes[p];
            if (s.fixed || !centre_inside(plane, s)) continue;
            lines.push_back(places.sphere(i) + ": the centre of sphere " + quoted(s.id) + " is inside plate " +
                            quoted(plane.id) + " (" + places.plane(p) + "), so that it has no side (move it out)");
        }
    return lines;
}

}  // namespace

std::vector<std::string> find_overlaps(const Scene& scene, bool allow_overlap)
{
    Patience endless;
    return find_overlaps(scene, allow_overlap, {}, endless);
}

std::vector<std::string> find_overlaps(const Scene& scene, bool allow_overlap, const BodyPlaces& places,
                                       Patience& patience)
{
    std::vector<std::string> lines = centres_inside_plates(scene, places, patience);
    if (!allow_overlap) {
        const auto plane = [&](std::size_t p) { return quoted(scene.planes[p].id) + " (" + places.plane(p) + ")"; };
        for (const auto& o : overlapping_planes(scene, patience))
            lines.push_back(places.sphere(o.a) + ": sphere " + quoted(scene.spheres[o.a].id) +
                            (centre_behind(scene.planes[o.b], scene.spheres[o.a])
                                 ? " is behind plane " + plane(o.b) + ", overlapping" + depth(o.depth) +
                                       " (does the plane's normal point to the free side? else " + cure(o.depth)
                                 : " overlaps plane " + plane(o.b) + depth(o.depth) + " (" + cure(o.depth)));
        for (const auto& o : overlapping_spheres(scene.spheres, patience))
            lines.push_back(places.sphere(o.b) + ": sphere " + quoted(scene.spheres[o.b].id) + " overlaps sphere " +
                            quoted(scene.spheres[o.a].id) + " (" + places.sphere(o.a) + ")" + depth(o.depth) + " (" +
                            cure(o.depth));
    }
    if (lines.size() > most_overlaps_named) {
        const std::size_t more = lines.size() - most_overlaps_named;
        lines.resize(most_overlaps_named);
        lines.push_back("/spheres: and " +
                        std::string(more >= most_overlaps_counted - most_overlaps_named ? "at least " : "") +
                        std::to_string(more) + " more overlaps");
    }
    return lines;
}

}  // namespace carom
