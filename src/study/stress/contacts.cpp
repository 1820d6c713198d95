#include "study/stress/scenes.hpp"
#include "study/stress/trial.hpp"
#include "study/stress/two_spheres.hpp"

#include <cmath>

namespace carom::stress {

namespace {

constexpr double radius = 0.125, step = radius / 1000;

/// Two spheres one ulp apart at these velocities along x.
Trial one_ulp(const std::string& label, double speed_a, double speed_b, double across = 0)
{
    Trial trial{.label = label, .scene = empty_scene("One ulp", 1), .dt = step, .impacts = 0};
    add_sphere(trial.scene, {.radius = radius, .velocity = {speed_a, across, 0}});
    add_sphere(
        trial.scene,
        {.radius = radius, .position = {std::nextafter(2 * radius, 1.0), 0, 0}, .velocity = {speed_b, across, 0}});
    if (speed_a > speed_b)
        expect_meeting(trial, 0, 1);
    else
        trial.states = {free_flight(trial.scene, 0), free_flight(trial.scene, 1)};
    for (ExpectedState& state : trial.states) state.speed = 1;
    return trial;
}

/// A sphere one ulp above a floor, moving onto it.
Trial one_ulp_above_floor(double restitution)
{
    Trial trial{.label = restitution < 1 ? "onto a floor, e = 1/2" : "onto a floor",
                .scene = empty_scene("One ulp", 1, Vec3::Zero(), restitution),
                .dt = step,
                .impacts = 1};
    add_plane(trial.scene, Vec3::UnitZ());
    const double height = std::nextafter(radius, 1.0);
    add_sphere(trial.scene, {.radius = radius, .position = {0, 0, height}, .velocity = {0, 0, -1}});
    trial.states = {{0, {0, 0, restitution + radius}, {0, 0, restitution}, radius, 1}};
    return trial;
}

Case ulp_gap()
{
    Case c;
    c.name = "ulp_gap";
    c.title = "A gap of 1 ulp";
    c.about =
        "Two spheres one ulp apart that approach, that part, and that move side by side; and a sphere one ulp "
        "above a floor that moves onto it, at e = 1 and 1/2.";
    c.figure =
        "largest error of final positions in radii and of velocities, against the closed form; a wrong number "
        "of impacts counts as an error, too";
    c.limit = 0.01;
    c.exact_limit = 1e-12;
    c.step = "1/1000 of the time in which a sphere moves by its radius";
    c.why[Symptom::sank] = c.why[Symptom::invented] =
        "the bounce is too slow to undo the overlap within a step, the response is given again and turns the sphere "
        "back "
        "into the floor";
    c.measure = [](std::string_view method, Patience& patience) {
        std::vector<Trial> trials{one_ulp("approaching", 1, -1), one_ulp("overtaking", 1, 0),
                                  one_ulp("parting", -1, 1),     one_ulp("side by side", 0, 0, 1),
                                  one_ulp_above_floor(1),        one_ulp_above_floor(0.5)};
        for (Trial& trial : trials) trial.count_is_figure = true;
        return measure(trials, method, patience);
    };
    return c;
}

constexpr double nearly_one = 1 - 0x1p-40, barely_above = 1 + 0x1p-40;  // 9.1e-13 off

/// A sphere passes one at rest at `miss` contact distances from head on. Closest approach is half a step from the ends
/// of steps.
Trial passing(const std::string& label, double miss)
{
    Trial trial{.label = label, .scene = empty_scene("Grazing", 2), .dt = step, .impacts = 0};
    add_sphere(trial.scene,
               {.radius = radius, .position = {-1 - step / 2, miss * 2 * radius, 0}, .velocity = {1, 0, 0}});
    add_sphere(trial.scene, {.radius = radius});
    // What the impact changes: sin of the angle of contact, sqrt(1 - miss^2).
    const double change = std::sqrt((1 - nearly_one) * (1 + nearly_one));
    if (miss < 1)
        expect_meeting(trial, 0, 1);
    else
        trial.states = {free_flight(trial.scene, 0), free_flight(trial.scene, 1)};
    for (ExpectedState& state : trial.states) {
        state.speed = change;
        state.length = 0;
    }
    return trial;
}

/// A ball thrown up, its apex at 1 m exactly, under a ceiling `height` above it: does it touch?
Trial apex(const std::string& label, double height)
{
    constexpr double gravity = 8, speed = 4;  // apex at 1 m after 0.5 s
    Trial trial{
        .label = label, .scene = empty_scene("Grazing", 0.75, {0, 0, -gravity}), .dt = 0.5 / 1000, .impacts = 0};
    add_plane(trial.scene, -Vec3::UnitZ(), -(height + radius));
    add_sphere(trial.scene, {.radius = radius, .velocity = {0, 0, speed}});
    // At the ceiling w^2 = v^2 - 2 g h, exactly; there it turns round and is ahead of the free flight by 2 w / g.
    const double reach = std::sqrt(2 * gravity * (1 - nearly_one));
    const double w = height < 1 ? reach : 0, late = 0.75 - 0.5;
    trial.impacts = height < 1 ? 1 : 0;
    trial.states = {{0, Vec3::Zero(), {0, 0, -gravity * late - 2 * w}, 0, 2 * reach}};
    return trial;
}

Case grazing()
{
    Case c;
    c.name = "grazing";
    c.title = "Grazing within 1e-12";
    c.about =
        "Spheres that pass each other 9.1e-13 of their contact distance inside and outside of contact; balls "
        "thrown up whose apex is as much above and below the ceiling.";
    c.figure =
        "largest error of a velocity relative to what the grazing impact changes in it; an impact missed or "
        "invented is 1 each";
    c.limit = 0.01;
    c.exact_limit = 1e-8;
    c.step = "1/1000 of the time in which the sphere moves by its radius, of the rise to the apex";
    c.why[Symptom::missed] =
        "the overlap lasts 1/200 of a step at most, and none of the looks at the end of a step falls into it";
    c.measure = [](std::string_view method, Patience& patience) {
        std::vector<Trial> trials{passing("spheres that touch", nearly_one), passing("spheres that pass", barely_above),
                                  apex("ceiling that is touched", nearly_one),
                                  apex("ceiling that is not", barely_above)};
        for (Trial& trial : trials) trial.count_is_figure = true;
        return measure(trials, method, patience);
    };
    return c;
}

}  // namespace

std::vector<Case> contact_cases()
{
    return {ulp_gap(), grazing()};
}

}  // namespace carom::stress
