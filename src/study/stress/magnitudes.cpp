#include "study/stress/scenes.hpp"
#include "study/stress/trial.hpp"
#include "study/stress/two_spheres.hpp"

#include <cmath>

namespace carom::stress {

namespace {

constexpr double radius = 0.125;

Trial fast_and_slow()
{
    constexpr double fast = 1e12, slow = 1e-12, gap = 0x1p-30, end = 2000, step = 1.0 / 240;
    Trial trial{.label = "fast", .scene = empty_scene("Speeds", end), .dt = step};
    add_sphere(trial.scene, {.radius = radius, .position = {-10, 0, 0}, .velocity = {fast, 0, 0}});
    add_sphere(trial.scene, {.radius = radius});
    add_sphere(trial.scene, {.radius = radius, .position = {0, 100, 0}, .velocity = {slow, 0, 0}});
    add_sphere(trial.scene, {.radius = radius, .position = {2 * radius + gap, 100, 0}});
    expect_meeting(trial, 0, 1);
    expect_meeting(trial, 2, 3);
    trial.states[0].speed = trial.states[1].speed = fast;  // equal spheres swap: one stands still afterwards
    trial.states[2].speed = trial.states[3].speed = slow;
    trial.states[1].length = fast * end;  // after such a flight a double no longer resolves the radius
    trial.first = {{2, 3, meeting(trial.scene, 2, 3).time, gap / slow}};
    return trial;
}

Case speeds()
{
    Case c;
    c.name = "speed";
    c.title = "Speeds 1e-12 and 1e12";
    c.about =
        "In one scene a sphere at 1e12 m/s hits one at rest, and far from them one at 1e-12 m/s another, 931 s "
        "later.";
    c.figure =
        "largest error of final positions (in radii; of the fast one relative to its way), of velocities and of "
        "the slow impact's time, relative";
    c.limit = 0.01;
    c.exact_limit = 1e-12;
    c.step = "1/240 s; no step suits both speeds";
    c.why[Symptom::missed] =
        "the fast sphere moves by 4e9 m in a step and never meets the other: a step that sees it "
        "would be 1e-13 s, and the slow pair needs 1e16 of those";
    c.measure = [](std::string_view method, Patience& patience) {
        return measure({fast_and_slow()}, method, patience);
    };
    return c;
}

constexpr double steps_a_fall = 1000;

/// Dropped from 1 m at e = 1/2: impacts at 1, 2 and 2.5 times the fall. At 2.2 it is on its third flight.
Trial drop(const std::string& label, double gravity)
{
    const double fall = std::sqrt(2 / gravity), end = 2.2 * fall;
    Trial trial{.label = "drop, " + label,
                .scene = empty_scene("Gravity " + label, end, {0, 0, -gravity}, 0.5),
                .dt = fall / steps_a_fall};
    add_plane(trial.scene, Vec3::UnitZ());
    add_sphere(trial.scene, {.radius = radius, .position = {0, 0, 1 + radius}});
    const double speed = gravity * fall;
    // v = g t e^2 - g s and h = e^2 g t s - g s^2/2 with s = 0.2 t, all relative to g t and g t^2 = 2 m.
    trial.states = {{0, {0, 0, radius + 2 * (0.25 * 0.2 - 0.02)}, {0, 0, 0.05 * speed}, radius, speed}};
    trial.impacts = 2;
    return trial;
}

/// The same until all bounces are over, at 3 times the fall.
Trial drop_to_rest(const std::string& label, double gravity)
{
    Trial trial = drop(label, gravity);
    const double fall = std::sqrt(2 / gravity);
    trial.label = "to rest, " + label;
    trial.scene.end_time = 3.2 * fall;
    trial.states = {{0, {0, 0, radius}, Vec3::Zero(), radius, gravity * fall}};
    trial.impacts.reset();
    return trial;
}

/// Let go at rest on a slope of 3 in 5: g sin t^2/2 along it.
Trial slide(const std::string& label, double gravity)
{
    const double fall = std::sqrt(2 / gravity);
    const Vec3 normal(0.6, 0, 0.8), down(0.8, 0, -0.6);
    Trial trial{.label = "slope, " + label,
                .scene = empty_scene("Gravity " + label, fall, {0, 0, -gravity}, 0),
                .dt = fall / steps_a_fall};
    add_plane(trial.scene, normal);
    add_sphere(trial.scene, {.radius = radius, .position = radius * normal});
    trial.states = {{0, radius * normal + 0.6 * down, 0.6 * gravity * fall * down, radius, gravity * fall}};
    return trial;
}

Case gravities()
{
    Case c;
    c.name = "gravity";
    c.title = "Gravity 1e-300 and 1e12";
    c.about =
        "Under each: a ball dropped from 1 m at e = 1/2, in flight and when it has come to rest, and one let go at "
        "rest on a slope of 3 in 5.";
    c.figure =
        "largest error of final positions in radii and of velocities relative to that of the fall, against the "
        "closed form";
    c.limit = 0.01;
    c.exact_limit = 1e-12;
    c.step = "1/1000 of the time of the fall";
    c.why[Symptom::invented] = "a bounce too slow to undo its overlap within a step is answered again and again";
    c.why[Symptom::sank] = "a bounce too slow to undo its overlap within a step is turned back into the floor";
    c.why[Symptom::late] = "every bounce is found up to a step late, and a step costs the ball speed or gives it some";
    c.measure = [](std::string_view method, Patience& patience) {
        return measure({drop("1e-300", 1e-300), drop_to_rest("1e-300", 1e-300), slide("1e-300", 1e-300),
                        drop("1e12", 1e12), drop_to_rest("1e12", 1e12), slide("1e12", 1e12)},
                       method, patience);
    };
    return c;
}

}  // namespace

std::vector<Case> magnitude_cases()
{
    return {speeds(), gravities()};
}

}  // namespace carom::stress
