#include "study/stress/scenes.hpp"
#include "study/stress/trial.hpp"

#include "scene/fill.hpp"

#include <carom/metrics.hpp>

#include <algorithm>
#include <cmath>

namespace carom::stress {

namespace {

/// The catalogue's gas_1000: a thousand elastic balls at 1 m/s in a box of 3 m.
Scene gas_1000(double end)
{
    constexpr double side = 3, radius = 0.05;
    constexpr std::size_t count = 1000;
    Scene scene = empty_scene("Gas of 1000", end);
    add_box(scene, side);
    FillSpec fill;
    fill.id = "atom";
    fill.pattern = RandomPattern{{Vec3::Zero(), Vec3::Constant(side)}};
    fill.count = count;
    fill.radius = radius;
    fill.speed = 1;
    scene.spheres = expand_fill(fill, scene).spheres;
    return scene;
}

Evidence measure_reversal(std::string_view method, Patience& patience)
{
    constexpr double end = 1, step = 1.0 / 1200;
    Evidence evidence;
    const Scene scene = gas_1000(end);
    const Method stepper = make_method(method, StepOptions{.dt = step});
    const Outcome there = simulate(scene, stepper, {}, observed(patience));
    take_note(scene, there, evidence);
    Scene reversed = scene;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        reversed.spheres[i].position = there.final[i].position;
        reversed.spheres[i].velocity = -there.final[i].velocity;
    }
    const Outcome back = simulate(reversed, stepper, {}, observed(patience));
    take_note(reversed, back, evidence);
    evidence.expected = there.counts.impacts;
    note_figure(evidence, position_deviation(back.final, initial_states(scene)).max / smallest_radius(scene),
                "position");
    return evidence;
}

Case time_reversal()
{
    Case c;
    c.name = "time_reversal";
    c.title = "Time reversal of gas_1000";
    c.about = "A gas of 1000 elastic spheres runs for 1 s, all velocities are turned round, and it runs back.";
    c.figure = "largest distance of a sphere from where it started, in radii";
    c.limit = 0.01;
    c.exact_limit = 1e-6;
    c.step = "1/1200 s, in which a sphere moves by 1/60 of its radius";
    c.why[Symptom::late] =
        "a step found an impact late on the way there and another late one on the way back, and every "
        "further impact multiplies the difference by about 20";
    c.why[Symptom::energy] = c.why[Symptom::late];
    c.measure = measure_reversal;
    return c;
}

Evidence measure_drift(std::string_view method, Patience& patience)
{
    constexpr double radius = 0.1, gravity = 9.81, step = 1.0 / 240;  // dropped from 1 m; numbers that round
    constexpr std::int64_t impacts = 100'000;
    const double fall = std::sqrt(2 / gravity);
    Scene scene = empty_scene("Drift", static_cast<double>(impacts) * 2 * fall, {0, 0, -gravity});
    add_plane(scene, Vec3::UnitZ());
    add_sphere(scene, {.radius = radius, .position = {0, 0, 1 + radius}});
    const Outcome outcome = simulate(scene, make_method(method, StepOptions{.dt = step}), {}, observed(patience));
    Evidence evidence;
    take_note(scene, outcome, evidence);
    evidence.expected = impacts;
    evidence.missed = std::max<std::int64_t>(0, impacts - outcome.counts.impacts);
    evidence.invented = std::max<std::int64_t>(0, outcome.counts.impacts - impacts);
    note_figure(evidence, std::abs(energy_difference(scene, outcome.final, initial_states(scene))) / gravity, "");
    return evidence;
}

Case drift()
{
    Case c;
    c.name = "drift";
    c.title = "Drift over 1e5 impacts";
    c.about = "A ball dropped from 1 m at e = 1 bounces 1e5 times; it should reach 1 m every time.";
    c.figure = "change of its energy relative to m g h";
    c.limit = 0.01;
    c.exact_limit = 1e-11;
    c.step = "1/240 s, 1/108 of the time of the fall";
    c.why[Symptom::energy] =
        "every bounce, found up to a step late, changes the energy a little, and the changes add up";
    c.why[Symptom::sank] = "a ball still inside the floor a step after its bounce is turned back into it and falls on";
    c.why[Symptom::missed] = c.why[Symptom::invented] = c.why[Symptom::energy];
    c.measure = measure_drift;
    return c;
}

}  // namespace

std::vector<Case> long_cases()
{
    return {time_reversal(), drift()};
}

}  // namespace carom::stress
