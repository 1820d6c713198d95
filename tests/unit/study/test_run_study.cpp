#include "study/search/step_scan.hpp"

#include <carom/study.hpp>

#include "make_sphere.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace carom;

namespace {

/// Falls one metre onto a floor; every bounce is known in closed form.
Scene bouncing_ball(double restitution)
{
    Scene scene;
    scene.name = "ball";
    scene.units = {"m", "s", "kg"};
    scene.gravity = Vec3(0, 0, -9.81);
    scene.end_time = 2;
    scene.materials = {{"rubber", restitution, 1, ""}};
    scene.spheres.push_back(make_sphere("ball", 0.1, Vec3(0, 0, 1.1)));
    scene.spheres.back().velocity = Vec3(0.2, 0, 0);
    Plane floor;
    floor.id = "floor";
    scene.planes.push_back(floor);
    return scene;
}

CompareOptions options_for(const Scene& scene, std::vector<std::string> methods, std::vector<double> dt)
{
    CompareOptions options;
    options.methods = std::move(methods);
    options.dt = std::move(dt);
    options.until = scene.end_time;
    return options;
}

}  // namespace

TEST_CASE("a run's figures are those of the ball on the floor", "[run_study]")
{
    const Scene scene = bouncing_ball(1);
    std::size_t impacts = 0;
    RunStudyOptions options;
    options.on_event = [&](const Event& event) { impacts += event.kind == EventKind::impact; };
    const RunStudy run = run_study(scene, EventDriven{}, options);
    CHECK(run.outcome.status == Status::reached_end);
    CHECK(run.outcome.counts.impacts == 2);  // at t1 and 3 t1, t1 = 0.4515
    CHECK(impacts == 2);
    CHECK(run.initial_energy == Approx(9.81 * 1.1 + 0.02));
    REQUIRE(run.max_relative_drift);
    CHECK(*run.max_relative_drift < 1e-14);
    CHECK(run.initial_momentum[0] == 0.2);
    CHECK(run.final_momentum[0] == Approx(0.2));
    CHECK(run.escaped == 0);
    CHECK(run.cpu_seconds > 0);
    REQUIRE(run.plane_forces.size() == 1);
    CHECK(*run.plane_forces[0] == Approx(2 * 2 * std::sqrt(2 * 9.81) / 2));  // two impulses of 2 m v in 2 s
}

TEST_CASE("there is no drift to speak of where contacts take energy, and a large one where a method errs",
          "[run_study]")
{
    CHECK_FALSE(run_study(bouncing_ball(0.5), EventDriven{}).max_relative_drift);
    StepOptions step;
    step.dt = 1.0 / 60;
    const RunStudy naive = run_study(bouncing_ball(1), make_method("naive", step));
    REQUIRE(naive.max_relative_drift);
    CHECK(*naive.max_relative_drift > 1e-3);
    CHECK(naive.max_penetration > 1e-3);
}

TEST_CASE("few spheres are looked at 200 times, many less often, but in the middle, too", "[run_study]")
{
    CHECK(look_intervals(0) == 200);
    CHECK(look_intervals(1) == 200);
    CHECK(look_intervals(125) == 200);
    CHECK(look_intervals(1000) == 25);
    CHECK(look_intervals(1'000'000) == 2);
    for (std::size_t n = 1; n < 20'000; ++n) CHECK(look_intervals(n) * n <= std::max<std::size_t>(25'000, 2 * n));
}

TEST_CASE("a run that is told to stop is interrupted", "[run_study]")
{
    RunStudyOptions options;
    options.on_progress = [](double) { return false; };
    StepOptions step;
    step.dt = 1e-5;
    CHECK(run_study(bouncing_ball(1), make_method("pbd", step), options).outcome.status == Status::interrupted);
}

TEST_CASE("the comparison finds the event method right and the steppers off by their order", "[compare]")
{
    const Scene scene = bouncing_ball(0.8);
    const Comparison result = compare_methods(scene, options_for(scene, {"event", "velocity"}, {1e-2, 1e-3, 1e-4}));
    REQUIRE(result.rows.size() == 4);
    CHECK(result.sample_times.size() == 201);
    CHECK(result.reference.until == 2);
    CHECK(result.tolerance == 1e-3);
    const CompareRow& event = result.rows[0];
    CHECK(event.method == "event");
    CHECK_FALSE(event.dt);
    CHECK_FALSE(event.substeps);
    REQUIRE(event.position_max);
    CHECK(*event.position_max < 1e-13);
    CHECK(*event.energy_error < 1e-13);
    CHECK(event.missed_impacts == 0);
    CHECK(event.invented_impacts == 0);
    CHECK(event.reference_impacts > 0);
    CHECK(event.impacts == event.reference_impacts);
    CHECK_FALSE(event.divergence_time);
    CHECK(event.repeats >= 3);
    CHECK(event.cpu_low <= event.cpu_seconds);
    CHECK(event.cpu_seconds <= event.cpu_high);
    REQUIRE(event.audit);
    CHECK(event.audit->found == event.reference_impacts);
    CHECK(event.audit->missed + event.audit->late + event.audit->invented == 0);
    CHECK(event.absorbed_impacts == 0);
    CHECK(event.cpu_min <= event.cpu_seconds);
    CHECK(event.cpu_seconds <= event.cpu_max);
    // First order: ten times the steps, a tenth of the error, within the luck of where impacts fall in a step.
    for (std::size_t i = 1; i < 4; ++i) {
        CAPTURE(i);
        const CompareRow& row = result.rows[i];
        CHECK(*row.substeps == 1);
        CHECK(row.steps == std::llround(2 / *row.dt));
        CHECK(row.series.tracks.size() == 201);
        CHECK(row.series.penetration.size() == 201);
        CHECK(row.series.position_max.size() == 201);
        CHECK(*row.position_max >= *row.position_rms);
        CHECK(*row.position_max >= *row.position_final_max);
        if (i > 1) CHECK(*row.position_max < *result.rows[i - 1].position_max / 2);
    }
    CHECK(result.rows[1].divergence_time);
    CHECK_FALSE(result.verdict.empty());
}

TEST_CASE("a sample that falls on an impact makes no error of an exact run", "[compare]")
{
    // Falls from 5/16 under g = 10: impact at 1/4 and every 1/2 after it, of 200 samples each 0.01.
    Scene scene = bouncing_ball(1);
    scene.gravity = Vec3(0, 0, -10);
    scene.spheres[0].position = Vec3(0, 0, 0.1 + 5.0 / 16);
    const Comparison result = compare_methods(scene, options_for(scene, {"event"}, {}));
    REQUIRE(result.rows[0].energy_error);
    CHECK(*result.rows[0].energy_error < 1e-13);
    CHECK(*result.rows[0].velocity_rms < 1e-13);
    CHECK(result.sample_times.size() == 201);
    CHECK(result.rows[0].series.position_max.size() == 201);
}

TEST_CASE("where the reference ends early, samples, counts and times are of the part that it covers", "[compare]")
{
    // Two balls over a third, fixed: the reference ends where a contact carries force while its normal turns.
    Scene scene = bouncing_ball(0);
    scene.spheres = {make_sphere("ball", 0.1, Vec3(0.01, 0, 0.5)), make_sphere("bump", 0.1, Vec3(0, 0, 0.1))};
    scene.spheres[1].fixed = true;
    scene.planes.clear();
    const Comparison result = compare_methods(scene, options_for(scene, {"event", "pbd"}, {1e-3}));
    if (result.reference.until >= scene.end_time) return;  // a reference that goes on
    CHECK(result.compared_until <= result.reference.until);
    CHECK(result.compared_until > 0.99 * result.reference.until);
    CHECK(result.sample_times.size() == 201);
    CHECK(result.sample_times.back() == result.compared_until);
    for (std::size_t k = 0; k < 201; ++k)  // nearly equal intervals
        CHECK(result.sample_times[k] ==
              Approx(static_cast<double>(k) / 200 * result.compared_until).margin(result.compared_until / 400));
    for (const CompareRow& row : result.rows) {
        CHECK(row.time == result.compared_until);
        CHECK(row.position_final_max);
    }
}

TEST_CASE("a bullet through a plate is a missed impact, and no method may hide it", "[compare]")
{
    Scene scene = bouncing_ball(1);
    scene.gravity = Vec3::Zero();
    scene.end_time = 0.1;
    scene.spheres[0] = make_sphere("bullet", 0.01, Vec3(0, 0, -1));
    scene.spheres[0].velocity = Vec3(0, 0, 100);
    scene.planes[0].thickness = 0.001;
    const Comparison result =
        compare_methods(scene, options_for(scene, {"event", "pbd", "velocity"}, {1.0 / 60, 1e-5}));
    REQUIRE(result.rows.size() == 5);
    for (const CompareRow& row : result.rows) {
        CAPTURE(row.method, row.dt.value_or(0));
        const bool blind = row.dt && *row.dt > 1e-3;
        CHECK(row.missed_impacts == (blind ? 1 : 0));
        CHECK(row.reference_impacts == 1);
        CHECK(row.mistimed_impacts == 0);
        CHECK(row.missed.size() == (blind ? 1 : 0));
        CHECK(*row.position_max > (blind ? 1 : 0));
    }
}

TEST_CASE("every combination of step, substeps and passes is a row, and progress grows", "[compare]")
{
    const Scene scene = bouncing_ball(0.8);
    CompareOptions options = options_for(scene, {"pbd", "event"}, {0.1, 0.01});
    options.substeps = {1, 2};
    options.passes = {1, 3};
    options.repeats = 1;
    double last = 0;
    bool monotonic = true;
    std::string stage;
    options.on_progress = [&](const Progress& now) {
        if (now.stage != stage) last = 0;
        stage = now.stage;
        monotonic = monotonic && now.fraction >= last && now.fraction <= 1;
        last = now.fraction;
        return true;
    };
    const Comparison result = compare_methods(scene, options);
    CHECK(result.rows.size() == 9);
    CHECK(result.rows[3].substeps == 2);
    CHECK(result.rows[3].passes == 3);
    CHECK(result.rows[3].steps == 40);
    CHECK(result.rows[8].method == "event");
    CHECK(monotonic);
    CHECK(last > 0.5);
}

TEST_CASE("an interrupted comparison keeps the rows that were finished", "[compare]")
{
    const Scene scene = bouncing_ball(0.8);
    CompareOptions options = options_for(scene, {"event", "pbd", "velocity"}, {0.01});
    options.on_progress = [&](const Progress& now) { return now.what.substr(0, 8) != "velocity"; };
    const Comparison result = compare_methods(scene, options);
    CHECK(result.interrupted);
    CHECK(result.rows.size() == 2);
    CHECK(result.verdict.back().find("interrupted") != std::string::npos);
}

TEST_CASE("the step found for a tolerance is the one that the error's formula gives", "[compare]")
{
    // Without contacts semi-implicit Euler is off by g t dt / 2, at most g T dt / 2: 1e-3 at dt = 2e-3 / (g T).
    Scene scene = bouncing_ball(1);
    scene.gravity = Vec3(0, 0, -10);
    scene.planes.clear();
    scene.end_time = 1;
    CompareOptions options = options_for(scene, {"event", "pbd"}, {0.1, 0.05});
    options.integrators = {Integrator::euler, Integrator::parabola};
    options.tolerance = 1e-3;
    options.search_steps = true;
    const Comparison result = compare_methods(scene, options);
    REQUIRE(result.searches.size() == 2);
    const StepSearch &euler = result.searches[0], &parabola = result.searches[1];
    REQUIRE(euler.end == StepSearch::End::found);
    REQUIRE(euler.row);
    CHECK(*euler.row->dt <= 2e-4 * (1 + 1e-9));
    CHECK(*euler.row->dt >= 2e-4 / 1.05);
    CHECK(euler.row->cpu_seconds > 0);
    const study::SearchFigures told = study::figures_of(euler);
    REQUIRE(told.too_far);
    CHECK(told.too_far->dt > 2e-4);
    CHECK(euler.is_complete);
    CHECK(told.held > 60);
    CHECK(told.worst_error == *euler.row->position_max);
    REQUIRE(parabola.row);  // exact in flight: the largest step that may be tried, an eighth of the run
    CHECK(*parabola.row->dt == 0.125);
    CHECK_FALSE(study::figures_of(parabola).too_far);
    CHECK(parabola.largest == 0.125);
    CHECK(result.rows.size() == 7);
}

TEST_CASE("errors that fall with the first power of the step are fitted so", "[compare]")
{
    Scene scene = bouncing_ball(1);
    scene.planes.clear();
    scene.end_time = 1;
    const Comparison result = compare_methods(scene, options_for(scene, {"pbd"}, {0.1, 0.01, 0.001}));
    REQUIRE(result.convergence.size() == 1);
    CHECK(result.convergence[0].order == Approx(1));
    CHECK(result.convergence[0].uncertainty < 1e-6);
    CHECK_FALSE(result.convergence[0].stalled);
}
