#include "study/stress/scenes.hpp"
#include "study/stress/shuttle.hpp"
#include "study/stress/trial.hpp"
#include "study/stress/two_spheres.hpp"

namespace carom::stress {

namespace {

// Units: 1 m, 1 s, 1 kg; radii and places with few bits, so that closed forms start from the numbers the runs see.
constexpr double heavy = 1e12, light = 1;
constexpr double radius = 0.125, step = radius / 1000;

Trial head_on(const std::string& label, double mass_a, double mass_b)
{
    Trial trial{.label = label, .scene = empty_scene("Mass ratio", 2), .dt = step};
    add_sphere(trial.scene, {.radius = radius, .mass = mass_a, .position = {-1, 0, 0}, .velocity = {1, 0, 0}});
    add_sphere(trial.scene, {.radius = radius, .mass = mass_b});
    expect_meeting(trial, 0, 1);
    return trial;
}

/// A light sphere rests before a wall, a heavy one closes in: the light one runs to and fro ever faster.
Trial squeeze()
{
    constexpr double end = 0.9375;  // the heavy sphere starts with 1 m of room, and keeps this much less
    Trial trial{.label = "squeezed", .scene = empty_scene("Mass ratio", end), .dt = step};
    add_plane(trial.scene, Vec3::UnitX());
    add_sphere(trial.scene, {.radius = radius, .mass = light, .position = {0.625, 0, 0}});
    add_sphere(trial.scene,
               {.radius = radius, .mass = heavy, .position = {1 + 3 * radius, 0, 0}, .velocity = {-1, 0, 0}});
    expect_shuttle(trial);
    return trial;
}

Case mass_ratio()
{
    Case c;
    c.name = "mass_ratio";
    c.title = "Mass ratio 1e12";
    c.about =
        "Heavy onto light, light onto heavy, and a light sphere squeezed between a heavy one and a wall; masses 1e12 "
        "and 1, elastic.";
    c.figure =
        "largest error of final positions in radii and of final velocities relative to each sphere's own, "
        "against the closed form";
    c.limit = 0.01;
    c.exact_limit = 1e-12;
    c.step = "1/1000 of the time in which the incoming sphere moves by its radius";
    c.why[Symptom::missed] = "in the closing gap the light sphere comes back faster than the steps";
    c.why[Symptom::energy] = "the light sphere in the closing gap passes on what each late impact got wrong";
    c.why[Symptom::late] = "each impact is found up to a step late, and the light sphere's next one amplifies it";
    c.measure = [](std::string_view method, Patience& patience) {
        return measure(
            {head_on("heavy onto light", heavy, light), head_on("light onto heavy", light, heavy), squeeze()}, method,
            patience);
    };
    return c;
}

constexpr double large = 1, small = 1e-6;

/// A small sphere comes in at 1 m/s along x, off the large one's axis by `offset`.
Trial off_centre(const std::string& label, double offset, double end)
{
    Trial trial{.label = label, .scene = empty_scene("Radius ratio", end), .dt = large / 1000};
    add_sphere(trial.scene, {.radius = small, .mass = 1, .position = {-2, offset, 0}, .velocity = {1, 0, 0}});
    add_sphere(trial.scene, {.radius = large, .mass = 1});
    expect_meeting(trial, 0, 1);
    return trial;
}

Case radius_ratio()
{
    Case c;
    c.name = "radius_ratio";
    c.title = "Radius ratio 1e6";
    c.about = "A sphere of radius 1e-6 hits one of radius 1 and equal mass at rest: off its centre, and near its rim.";
    c.figure = "largest error of final positions in radii of each sphere and of velocities, against the closed form";
    c.limit = 0.01;
    c.exact_limit = 1e-8;
    c.step = "1/1000 of the time in which the small sphere crosses the large one's radius";
    c.why[Symptom::missed] = "the small sphere's path inside the large one is shorter than a step";
    c.why[Symptom::late] =
        "in a step the small sphere moves by 1000 of its radii: it turns round that deep inside the "
        "large one, where the normal is another";
    c.why[Symptom::sank] = c.why[Symptom::late];
    c.measure = [](std::string_view method, Patience& patience) {
        return measure({off_centre("off centre", 0.5, 2), off_centre("near the rim", 1 - 0x1p-10, 3)}, method,
                       patience);
    };
    return c;
}

}  // namespace

std::vector<Case> ratio_cases()
{
    return {mass_ratio(), radius_ratio()};
}

}  // namespace carom::stress
