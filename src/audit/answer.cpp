#include "audit/answer.hpp"

#include "audit/tolerances.hpp"

namespace carom::audit {

namespace {

/// A body of a touch. Planes stand still.
struct Party {
    Course course = Course::kept;
    Parabola before = standing(Vec3::Zero());
    std::optional<Parabola> after = before;  ///< given at the end of the interval
};

Party party_of(const Interval& interval, BodyId body)
{
    if (body >= static_cast<BodyId>(interval.motions.size())) return {};
    const BodyMotion& motion = interval.motions[static_cast<std::size_t>(body)];
    if (motion.course == Course::changed) return {motion.course, *motion.before, motion.after};
    return {motion.course, *motion.before, given_at(*motion.before, interval.end)};
}

bool has_no_flight(const Interval& interval, BodyId body)
{
    return body < static_cast<BodyId>(interval.motions.size()) &&
           interval.motions[static_cast<std::size_t>(body)].course == Course::unknown;
}

/// Whether the turns of both can be those of one impact.
bool turn_together(const Party& a, const Party& b)
{
    if (a.course != Course::changed || b.course != Course::changed) return true;
    const auto turn_a = turn_between(a.before, *a.after), turn_b = turn_between(b.before, *b.after);
    return !turn_a || !turn_b || std::abs(turn_a->time - turn_b->time) <= turn_a->error + turn_b->error;
}

bool changes_side(const Scene& scene, const Touch& touch, const SeenFrame& from, const SeenFrame& to)
{
    const auto n = static_cast<BodyId>(scene.spheres.size());
    if (touch.b < n) return false;
    const Plane& plane = scene.planes[static_cast<std::size_t>(touch.b - n)];
    const auto a = static_cast<std::size_t>(touch.a);
    return plane.thickness && is_behind(plane, from.places[a]) != is_behind(plane, to.places[a]);
}

/// Whether the frame at the end of the interval shows the bodies apart, whatever the errors are.
bool are_apart(const Scene& scene, const Touch& touch, const SeenFrame& to)
{
    const auto a = static_cast<std::size_t>(touch.a), b = static_cast<std::size_t>(touch.b);
    const bool is_sphere = b < to.places.size();
    const double error = to.errors[a] + (is_sphere ? to.errors[b] : 0);
    return gap(scene, touch.a, to.places[a], touch.b, is_sphere ? to.places[b] : Vec3::Zero()) > error;
}

/// Whether bodies that turned at `time` part as one impact makes them: along the normal of their touch, or along that
/// of the overlap in which they turned. If they still approach, other contacts are hidden between the frames.
bool part(const Scene& scene, const Touch& touch, const Party& a, const Party& b, double time)
{
    const Parabola before = relative(a.before, b.before), after = relative(*a.after, *b.after);
    const auto parts_along = [&](const Vec3& normal) {
        return after.velocity_at(time).dot(normal) >= -after.velocity_error;
    };
    const bool are_spheres = touch.b < static_cast<BodyId>(scene.spheres.size());
    return parts_along(touch.normal) || (are_spheres && parts_along(before.place_at(time).normalized()));
}

/// The answer where at least one body has left its flight.
Answer turned(const Scene& scene, const Touch& touch, const Interval& interval, const Around& around)
{
    const Party a = party_of(interval, touch.a), b = party_of(interval, touch.b);
    const auto if_alone = [&](const Answer& answer) {
        const double from = std::max(interval.begin, answer.time);
        return is_alone(scene, {touch.a, touch.b}, interval, around, from) ? answer : Answer{Verdict::several};
    };
    if (!a.after || !b.after) {
        if (interval.begin <= touch.latest) return {Verdict::found};
        return if_alone({Verdict::late, interval.begin - touch.time, true, interval.begin});
    }
    const std::optional<Turn> turn = turn_between(relative(a.before, b.before), relative(*a.after, *b.after));
    if (!turn || turn->change.dot(touch.normal) < answer_part * touch.approach_speed) return {Verdict::several};
    if (turn->time - turn->error > touch.latest || turn->time + turn->error < touch.earliest) {
        if (!turn->is_single || !turn_together(a, b) || !part(scene, touch, a, b, turn->time))
            return {Verdict::several};
        const double delay = turn->time - touch.time;
        return if_alone({delay > 0 ? Verdict::late : Verdict::early, std::abs(delay), false, turn->time});
    }
    return {Verdict::found};
}

}  // namespace

std::optional<Turn> turn_of(const BodyMotion& motion)
{
    if (motion.course != Course::changed || !motion.after) return std::nullopt;
    return turn_between(*motion.before, *motion.after);
}

Answer answer_to(const Scene& scene, const Touch& touch, std::size_t waited, const Interval& interval,
                 const SeenFrame& from, const SeenFrame& to, const Around& around)
{
    if (changes_side(scene, touch, from, to)) return {Verdict::missed};
    if (has_no_flight(interval, touch.a) || has_no_flight(interval, touch.b)) return {Verdict::unsettled};
    const auto has_turned = [&](BodyId body) {
        return body < static_cast<BodyId>(interval.motions.size()) &&
               interval.motions[static_cast<std::size_t>(body)].course == Course::changed;
    };
    if (has_turned(touch.a) || has_turned(touch.b)) return turned(scene, touch, interval, around);
    if (are_apart(scene, touch, to) || waited + 1 >= latest_answer) return {Verdict::missed};
    return {Verdict::waits};
}

}  // namespace carom::audit
