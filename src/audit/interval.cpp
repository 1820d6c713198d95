#include "audit/interval.hpp"

#include "audit/tolerances.hpp"
#include "scene/sphere_grid.hpp"

#include <algorithm>
#include <array>

namespace carom::audit {

namespace {

using Sightings = std::array<Sighting, fitted_frames>;

/// \pre the window has so many frames
Sightings sightings_of(const Window& window, std::size_t first, std::size_t count, std::size_t sphere)
{
    Sightings sightings;
    for (std::size_t k = 0; k < count; ++k) {
        const SeenFrame& frame = window.frames[first + k];
        sightings[k] = {frame.time, frame.places[sphere], frame.errors[sphere]};
    }
    return sightings;
}

std::optional<Parabola> through(const Window& window, std::size_t first, std::size_t count, std::size_t sphere,
                                const Pull& pull)
{
    if (first + count > window.frames.size()) return std::nullopt;
    const Sightings sightings = sightings_of(window, first, count, sphere);
    return fitted({sightings.data(), count}, pull, window.time_error);
}

/// Bend of the frames that hold the interval: the three that end with it, and the three that begin with it. One that
/// is straight says more than one that has a kink.
Bend bend_around(const Window& window, std::size_t sphere, const Pull& pull)
{
    Bend bend = Bend::hidden;
    for (std::size_t first = window.begin > 0 ? window.begin - 1 : 0; first <= window.begin; ++first) {
        if (first + fitted_frames > window.frames.size()) break;
        const Sightings sightings = sightings_of(window, first, fitted_frames, sphere);
        const Bend here = bend_of(sightings, pull, window.time_error);
        if (here == Bend::straight || bend == Bend::hidden) bend = here;
        if (bend == Bend::straight) break;
    }
    return bend;
}

/// The flight with which the scene begins. Its velocity as frames see it depends on the engine's step, of which only
/// the length of an interval is known to bound it: half of what gravity and drag add in one.
Parabola at_start(const Scene& scene, const Window& window, std::size_t sphere)
{
    const SeenFrame& first = window.frames[0];
    Parabola p;
    p.time = p.middle = first.time;
    p.place = first.places[sphere];
    p.velocity = scene.spheres[sphere].velocity;
    p.pull = pull_of(scene);
    p.velocity_error = p.bend(first.time, first.time) * (window.frames[1].time - first.time) / 2;
    p.place_error = first.errors[sphere] + window.time_error * p.velocity.norm();
    return p;
}

std::optional<Parabola> flight_before(const Scene& scene, const Window& window, std::size_t sphere)
{
    if (window.begin + 1 >= fitted_frames)
        return through(window, window.begin + 1 - fitted_frames, fitted_frames, sphere, pull_of(scene));
    if (!window.from_start) return std::nullopt;
    const Parabola start = at_start(scene, window, sphere);
    if (window.begin == 0) return start;
    const std::optional<Parabola> two = through(window, 0, 2, sphere, pull_of(scene));
    return is_same(start, *two) ? two : std::nullopt;
}

BodyMotion motion_of(const Scene& scene, const Window& window, std::size_t sphere)
{
    const SeenFrame& from = window.frames[window.begin];
    const SeenFrame& to = window.frames[window.begin + 1];
    BodyMotion motion;
    if (scene.spheres[sphere].fixed) {
        motion.course = Course::kept;
        motion.before = motion.after = standing(from.places[sphere]);
        return motion;
    }
    const double duration = to.time - from.time;
    motion.before = flight_before(scene, window, sphere);
    motion.after = through(window, window.begin + 1, fitted_frames, sphere, pull_of(scene));
    motion.from_scene = window.begin + 1 < fitted_frames;
    motion.bend = bend_around(window, sphere, pull_of(scene));
    if (motion.after) motion.after = given_at(*motion.after, to.time);
    double way = (to.places[sphere] - from.places[sphere]).norm();
    if (motion.after) way = std::max(way, motion.after->velocity.norm() * duration);
    if (motion.before) {
        const Parabola& before = *motion.before;
        way = std::max(way, before.velocity.norm() * duration + before.error_at(to.time));
        motion.off = to.places[sphere] - before.place_at(to.time);
        motion.off_error = before.error_at(to.time) + to.errors[sphere];
        if (motion.after)
            motion.course = is_same(before, *motion.after) ? Course::kept : Course::changed;
        else
            motion.course = motion.off.norm() <= motion.off_error ? Course::arrived : Course::changed;
    }
    // Without a flight a body may have gone to and fro between frames, as quickly as it ever went.
    if (motion.course == Course::unknown || !motion.after) way = std::max(way, window.fastest[sphere] * duration);
    motion.way = detour * way + scene.gravity.norm() * duration * duration;
    return motion;
}

void find_near(const Scene& scene, const Window& window, Interval& interval)
{
    const std::size_t n = scene.spheres.size();
    const std::vector<Vec3>& from = window.frames[window.begin].places;
    const std::vector<Vec3>& to = window.frames[window.begin + 1].places;
    std::vector<double> radii(n);
    for (std::size_t i = 0; i < n; ++i) radii[i] = scene.spheres[i].radius + interval.motions[i].way;
    SphereGrid grid(radii);
    for (const std::size_t i : largest_first(radii)) {
        const Vec3 middle = (from[i] + to[i]) / 2;
        grid.visit_near(middle, radii[i], [&](std::size_t j) {
            const double reach = radii[i] + radii[j];
            if ((middle - (from[j] + to[j]) / 2).squaredNorm() > reach * reach) return true;
            const bool fixed_i = scene.spheres[i].fixed, fixed_j = scene.spheres[j].fixed;
            if (fixed_i && fixed_j) return true;
            const bool first = fixed_i == fixed_j ? i < j : fixed_j;
            interval.near.emplace_back(static_cast<BodyId>(first ? i : j), static_cast<BodyId>(first ? j : i));
            return true;
        });
        grid.insert(i, middle, radii[i]);
    }
    std::sort(interval.near.begin(), interval.near.end());
}

void find_touches(const Scene& scene, Interval& interval)
{
    const auto keep = [&](const std::optional<Touch>& touch) {
        if (touch) interval.touches.push_back(*touch);
    };
    for (const auto& [a, b] : interval.near) {
        const auto& before_a = interval.motions[static_cast<std::size_t>(a)].before;
        const auto& before_b = interval.motions[static_cast<std::size_t>(b)].before;
        if (before_a && before_b) keep(sphere_touch(scene, a, *before_a, b, *before_b, interval.end));
    }
    for (std::size_t i = 0; i < interval.motions.size(); ++i) {
        if (scene.spheres[i].fixed || !interval.motions[i].before) continue;
        for (std::size_t p = 0; p < scene.planes.size(); ++p)
            keep(plane_touch(scene, static_cast<BodyId>(i), *interval.motions[i].before, p, interval.end));
    }
}

}  // namespace

Interval interval_of(const Scene& scene, const Window& window)
{
    Interval interval;
    interval.begin = window.frames[window.begin].time;
    interval.end = window.frames[window.begin + 1].time;
    interval.motions.reserve(scene.spheres.size());
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) interval.motions.push_back(motion_of(scene, window, i));
    find_near(scene, window, interval);
    find_touches(scene, interval);
    return interval;
}

}  // namespace carom::audit
