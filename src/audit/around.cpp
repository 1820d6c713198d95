#include "audit/around.hpp"

namespace carom::audit {

namespace {

bool is_disturbed(const BodyMotion& motion)
{
    return motion.course == Course::unknown || motion.course == Course::changed;
}

bool is_sphere(const Scene& scene, BodyId body)
{
    return body < static_cast<BodyId>(scene.spheres.size());
}

/// Whether a body, as it flies after its contact, may meet a plane or a fixed sphere before the interval ends.
bool meets_obstacle(const Scene& scene, BodyId body, BodyId partner, const Interval& interval, double from)
{
    const std::optional<Parabola>& after = interval.motions[static_cast<std::size_t>(body)].after;
    if (!after) return false;
    for (std::size_t p = 0; p < scene.planes.size(); ++p)
        if (scene.plane_body(p) != partner && may_touch_plane(scene, body, *after, p, from, interval.end)) return true;
    for (const auto& [a, b] : interval.near) {
        const std::size_t other = static_cast<std::size_t>(b);
        if (a == body && b != partner && scene.spheres[other].fixed &&
            may_touch(scene, body, *after, b, *interval.motions[other].before, from, interval.end))
            return true;
    }
    return false;
}

}  // namespace

Around around(const Scene& scene, const Interval& interval, Pairs pairs)
{
    Around result{std::vector<int>(scene.spheres.size()), std::vector<int>(scene.spheres.size()), {}};
    for (const Touch& touch : interval.touches) pairs.insert({touch.a, touch.b});
    for (const auto& [a, b] : pairs) {
        ++result.contacts[static_cast<std::size_t>(a)];
        if (is_sphere(scene, b)) ++result.contacts[static_cast<std::size_t>(b)];
    }
    result.pairs = std::move(pairs);
    for (const auto& [a, b] : interval.near) {
        const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
        if (is_disturbed(interval.motions[j])) ++result.disturbed[i];
        if (is_disturbed(interval.motions[i])) ++result.disturbed[j];
    }
    return result;
}

std::set<BodyId> possible_partners(const Scene& scene, BodyId body, const Interval& interval, const Around& around)
{
    std::set<BodyId> partners;
    for (const auto& [a, b] : around.pairs)
        if (a == body || b == body) partners.insert(a == body ? b : a);
    const BodyMotion& motion = interval.motions[static_cast<std::size_t>(body)];
    for (const std::optional<Parabola>* flight : {&motion.before, &motion.after}) {
        if (!*flight) continue;
        for (std::size_t p = 0; p < scene.planes.size(); ++p)
            if (may_touch_plane(scene, body, **flight, p, interval.begin, interval.end))
                partners.insert(scene.plane_body(p));
        for (const auto& [a, b] : interval.near) {
            const BodyMotion& other = interval.motions[static_cast<std::size_t>(a == body ? b : a)];
            if ((a == body || b == body) && other.before &&
                may_touch(scene, body, **flight, a == body ? b : a, *other.before, interval.begin, interval.end))
                partners.insert(a == body ? b : a);
        }
    }
    return partners;
}

bool is_alone(const Scene& scene, const Pair& pair, const Interval& interval, const Around& around, double from)
{
    const auto one_is_alone = [&](BodyId body, BodyId partner) {
        const auto i = static_cast<std::size_t>(body);
        if (scene.spheres[i].fixed) return true;
        const bool partner_disturbed =
            is_sphere(scene, partner) && is_disturbed(interval.motions[static_cast<std::size_t>(partner)]);
        return around.contacts[i] <= 1 && around.disturbed[i] <= (partner_disturbed ? 1 : 0) &&
               !meets_obstacle(scene, body, partner, interval, from);
    };
    return one_is_alone(pair.first, pair.second) &&
           (!is_sphere(scene, pair.second) || one_is_alone(pair.second, pair.first));
}

}  // namespace carom::audit
