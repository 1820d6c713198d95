#include "study/stress/scenes.hpp"
#include "study/stress/shuttle.hpp"
#include "study/stress/trial.hpp"

#include <cmath>

namespace carom::stress {

namespace {

Case counting_pi()
{
    Case c;
    c.name = "counting_pi";
    c.title = "Counting pi, k = 3";
    c.about = "A ball of mass 100^3 drives one of mass 1 at a wall: floor(1000 pi) = 3141 impacts (Galperin 2003).";
    c.figure =
        "largest error of final positions in radii and of velocities, against the billiard of two points in "
        "extended precision; a wrong number of impacts counts as an error, too";
    c.limit = 0.01;
    c.exact_limit = 1e-9;
    c.step = "1/1000 of the time in which the large ball moves by the small one's radius";
    c.why[Symptom::sank] =
        "at the turning point 1 mm of room is left and the small ball, then at 1000 m/s, moves by its "
        "radius in a step";
    c.why[Symptom::energy] = c.why[Symptom::missed] = c.why[Symptom::invented] = c.why[Symptom::late] =
        c.why[Symptom::sank];
    c.measure = [](std::string_view method, Patience& patience) {
        constexpr double small = 0.125;
        Trial trial{
            .label = "k = 3", .scene = empty_scene("Counting pi, 3", 6), .dt = small / 1000, .count_is_figure = true};
        add_plane(trial.scene, Vec3::UnitX());
        add_sphere(trial.scene, {.radius = small, .position = {1 + small, 0, 0}});
        add_sphere(trial.scene, {.radius = 2 * small, .mass = 1e6, .position = {2.5, 0, 0}, .velocity = {-1, 0, 0}});
        expect_shuttle(trial);
        return measure({trial}, method, patience);
    };
    return c;
}

constexpr double radius = 0.125, gravity = 8, fall = 0.5;  // dropped from 1 m: h = g t^2 / 2
constexpr std::size_t looks = 1000;

/// Height above the floor at ascending times, bounce by bounce in extended precision.
class Bouncing {
public:
    explicit Bouncing(double restitution) : e_(restitution) {}

    double height(double time)
    {
        using Real = long double;
        if (time < fall) return static_cast<double>(1 - Real(gravity) / 2 * time * time);
        constexpr Real nothing = 1e-30L;  // flights shorter than this leave no height
        while (began_ + flight() <= time && flight() > nothing) {
            began_ += flight();
            factor_ *= e_;
        }
        const Real s = time - began_;
        return flight() > nothing && s < flight() ? static_cast<double>(Real(gravity) / 2 * s * (flight() - s)) : 0;
    }

private:
    long double flight() const { return 2 * fall * factor_; }

    long double e_, began_ = fall, factor_ = e_;
};

void measure_bouncing(const std::string& label, double e, std::string_view method, Patience& patience,
                      Evidence& evidence)
{
    const double rest =
        static_cast<double>(fall * (1 + static_cast<long double>(e)) / (1 - static_cast<long double>(e)));
    Scene scene = empty_scene("Zeno", 1.25 * rest, {0, 0, -gravity}, e);
    add_plane(scene, Vec3::UnitZ());
    add_sphere(scene, {.radius = radius, .position = {0, 0, 1 + radius}});
    Bouncing exact(e);
    Observer observer = observed(patience);
    observer.sample_times = sample_grid(scene.end_time, looks);
    observer.on_sample = [&](std::size_t, double time, std::span<const BodyState> states) {
        note_figure(evidence, std::abs(states[0].position.z() - radius - exact.height(time)) / radius,
                    label + ", height");
    };
    const Outcome outcome = simulate(scene, make_method(method, StepOptions{.dt = fall / 1000}), {}, observer);
    take_note(scene, outcome, evidence);
    if (method != method_names().front()) return;  // discrete methods do not know rest
    const double found = outcome.rest_times[0].value_or(0);
    note_figure(evidence, std::abs(found - rest) / rest, label + ", time of rest");
}

Case zeno()
{
    Case c;
    c.name = "zeno";
    c.title = "Zeno, e = 0.01 and 0.999";
    c.about =
        "A ball dropped from 1 m bounces infinitely often until it rests at t (1 + e)/(1 - e), t the time of the "
        "fall: 1.02 t and 1999 t.";
    c.figure = "largest error of the height at 1000 times, in radii (event: and of the time of rest, relative)";
    c.limit = 0.01;
    c.exact_limit = 1e-9;
    c.step = "1/1000 of the time of the fall";
    c.why[Symptom::sank] = "a ball whose bounce is shorter than a step is turned back into the floor and sinks";
    c.why[Symptom::late] =
        "each bounce is found up to a step late and leaves with the wrong speed: after hundreds of "
        "bounces at e = 0.999 nothing of the phase is left";
    c.measure = [](std::string_view method, Patience& patience) {
        Evidence evidence;
        measure_bouncing("e = 0.01", 0.01, method, patience, evidence);
        measure_bouncing("e = 0.999", 0.999, method, patience, evidence);
        return evidence;
    };
    return c;
}

}  // namespace

std::vector<Case> series_cases()
{
    return {counting_pi(), zeno()};
}

}  // namespace carom::stress
