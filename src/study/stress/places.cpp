#include "study/stress/scenes.hpp"
#include "study/stress/trial.hpp"

#include "core/random.hpp"

#include <carom/metrics.hpp>

#include <array>
#include <cmath>

namespace carom::stress {

namespace {

constexpr double radius = 0.25, speed = 1, step = 1.0 / 240;
constexpr double far = 1e9;
constexpr std::int64_t start = std::int64_t{1} << 40;

/// 27 elastic spheres in a box of 4 m. Their coordinates are multiples of 2^-20 m: 1e9 m further they are still exact,
/// so that whatever differs there, the run did.
Scene small_gas()
{
    constexpr double end = 10, side = 4, spacing = 1.25, jitter = 0.25, grain = 0x1p-20;
    constexpr int rows = 3;
    Scene scene = empty_scene("Small gas", end);
    add_box(scene, side);
    Random random(1);
    for (int k = 0; k < rows * rows * rows; ++k) {
        Ball sphere{.radius = radius};
        const std::array<int, 3> site{k % rows, k / rows % rows, k / (rows * rows)};
        for (int axis = 0; axis < 3; ++axis) {
            const double place =
                0.75 + spacing * site[static_cast<std::size_t>(axis)] + random.uniform(-jitter, jitter);
            sphere.position[axis] = std::floor(place / grain) * grain;
        }
        sphere.velocity = speed * random.direction();
        add_sphere(scene, sphere);
    }
    return scene;
}

Scene moved_by(Scene scene, const Vec3& shift)
{
    for (Sphere& sphere : scene.spheres) sphere.position += shift;
    for (Plane& plane : scene.planes) plane.offset += plane.normal.dot(shift);
    return scene;
}

Outcome run(const Scene& scene, std::string_view method, Patience& patience, Evidence& evidence)
{
    Outcome outcome = simulate(scene, make_method(method, StepOptions{.dt = step}), {}, observed(patience));
    take_note(scene, outcome, evidence);
    return outcome;
}

/// How far a run is from the one that it should repeat.
void compare(const Outcome& here, const Outcome& there, const Vec3& shift, bool by_event_hash, Evidence& evidence)
{
    evidence.expected += here.counts.impacts;
    for (std::size_t i = 0; i < here.final.size(); ++i) {
        // Where the engine's own places are written as doubles they round: its velocities tell.
        if (!by_event_hash)
            note_figure(evidence, (there.final[i].position - shift - here.final[i].position).norm() / radius,
                        "position");
        note_figure(evidence, (there.final[i].velocity - here.final[i].velocity).norm() / speed, "velocity");
    }
    if (by_event_hash && here.event_hash != there.event_hash) evidence.same_run = false;
}

Evidence measure_origin(std::string_view method, Patience& patience)
{
    Evidence evidence;
    const bool event = method == method_names().front();
    const Scene scene = small_gas();
    const Vec3 shift = Vec3::Constant(far);
    const Outcome here = run(scene, method, patience, evidence);
    compare(here, run(moved_by(scene, shift), method, patience, evidence), shift, event, evidence);
    if (event) {
        Scene labelled = scene;
        labelled.origin = shift;
        compare(here, run(labelled, method, patience, evidence), Vec3::Zero(), true, evidence);
    }
    return evidence;
}

Evidence measure_start(std::string_view method, Patience& patience)
{
    Evidence evidence;
    Scene scene = small_gas();
    const Outcome here = run(scene, method, patience, evidence);
    scene.start_time.epoch = static_cast<std::int64_t>(static_cast<double>(start) / here.epoch_length);
    const Outcome there = run(scene, method, patience, evidence);
    compare(here, there, Vec3::Zero(), method == method_names().front(), evidence);
    return evidence;
}

Case far_origin()
{
    Case c;
    c.name = "far_origin";
    c.title = "Origin 1e9 away";
    c.about =
        "27 elastic spheres in a box, the same run here and 1e9 m away along x, y and z; its coordinates are "
        "exact at both places.";
    c.figure = "largest difference of the two runs at the end, of positions in radii and of velocities";
    c.limit = 0.01;
    c.exact_limit = 0;
    c.step = "1/240 of the time in which a sphere moves by 1 m";
    c.why[Symptom::late] =
        "a double at 1e9 m comes in steps of 1.2e-7 m, and every impact multiplies an error by 10 to 20";
    c.measure = measure_origin;
    return c;
}

Case start_time()
{
    Case c;
    c.name = "start_time";
    c.title = "Start time 2^40 s";
    c.about =
        "27 elastic spheres in a box, the same run at time 0 and at 2^40 s, where a clock kept in one double "
        "resolves 2.4e-4 s. All methods count from the start of the run.";
    c.figure = "largest difference of the two runs at the end, of positions in radii and of velocities";
    c.limit = 0.01;
    c.exact_limit = 0;
    c.step = "1/240 of the time in which a sphere moves by 1 m";
    c.why[Symptom::late] = "the clock's resolution lengthens the steps";
    c.measure = measure_start;
    return c;
}

}  // namespace

std::vector<Case> place_cases()
{
    return {far_origin(), start_time()};
}

}  // namespace carom::stress
