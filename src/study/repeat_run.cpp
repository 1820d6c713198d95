#include "study/repeat_run.hpp"

#include "study/tolerances.hpp"

#include <carom/metrics.hpp>

#include <algorithm>
#include <limits>

namespace carom::study {

namespace {

Scene moved(Scene scene, const Vec3& shift)
{
    for (Sphere& sphere : scene.spheres) sphere.position += shift;
    for (Plane& plane : scene.planes) plane.offset += plane.normal.dot(shift);
    return scene;
}

Scene turned_round(Scene scene, const std::vector<BodyState>& end)
{
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        scene.spheres[i].position = end[i].position;
        scene.spheres[i].velocity = -end[i].velocity;
    }
    return scene;
}

Scene repeated_scene(Scene scene, const Check& check, const Outcome& first)
{
    if (check.type == CheckType::moved) return moved(std::move(scene), check.value);
    if (check.type == CheckType::reversed) return turned_round(std::move(scene), first.final);
    if (check.type == CheckType::moved_origin) scene.origin += check.value;
    if (check.type == CheckType::later)
        scene.start_time.epoch += static_cast<std::int64_t>(check.time / first.epoch_length);
    return scene;
}

/// A difference relative to a scale, which may be 0 where there is no difference.
double relative(double difference, double scale)
{
    return difference == 0 ? 0 : difference / scale;
}

double largest_speed(std::span<const BodyState> states)
{
    double largest = 0;
    for (const BodyState& state : states) largest = std::max(largest, state.velocity.norm());
    return largest;
}

/// Largest distance [length] of two lists of positions, those of `shifted` less `shift`. Distances within the spacing
/// of doubles, where they are written, are none.
double largest_distance(std::span<const BodyState> shifted, std::span<const BodyState> states, const Vec3& shift)
{
    double largest = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Vec3 there = states[i].position + shift;
        const double size = std::max(there.lpNorm<Eigen::Infinity>(), shift.lpNorm<Eigen::Infinity>());
        const double distance = (shifted[i].position - there).lpNorm<Eigen::Infinity>();
        if (!(distance <= spacing_of_doubles * size)) largest = std::max(largest, distance);
    }
    return largest;
}

double difference(const Scene& scene, const Check& check, const Outcome& first, std::span<const BodyState> end)
{
    const std::vector<BodyState> start = initial_states(scene);
    const double radius = smallest_radius(scene);
    if (check.type == CheckType::reversed) return relative(position_deviation(end, start).max, radius);
    const double velocities = relative(velocity_deviation(end, first.final).max, largest_speed(start));
    const Vec3 shift = check.type == CheckType::moved ? check.value : Vec3::Zero();
    return std::max(velocities, relative(largest_distance(end, first.final, shift), radius));
}

/// Whether the second run is another one than asked for: another `event_hash`, and backwards another number of impacts.
/// Discrete methods promise neither, but a run without impacts has nothing that could be turned round.
bool is_other_run(CheckType type, const Outcome& first, const Outcome& second, bool event_driven)
{
    if (type != CheckType::reversed) return event_driven && second.event_hash != first.event_hash;
    return first.counts.impacts == 0 || (event_driven && second.counts.impacts != first.counts.impacts);
}

}  // namespace

bool asks_for_repeat(CheckType type)
{
    return type == CheckType::moved || type == CheckType::moved_origin || type == CheckType::later ||
           type == CheckType::reversed;
}

Repeat repeat_run(const Scene& scene, const Check& check, const Outcome& first, const CheckOptions& options)
{
    Observer observer;
    observer.on_progress = options.on_progress;
    Repeat repeat;
    repeat.outcome = simulate(repeated_scene(scene, check, first), options.method,
                              RunOptions{.max_seconds = options.max_seconds}, observer);
    const bool event_driven = std::holds_alternative<EventDriven>(options.method);
    repeat.other_events = is_other_run(check.type, first, repeat.outcome, event_driven);
    repeat.difference = repeat.outcome.status == Status::reached_end && !repeat.other_events
                            ? difference(scene, check, first, repeat.outcome.final)
                            : std::numeric_limits<double>::infinity();
    return repeat;
}

}  // namespace carom::study
