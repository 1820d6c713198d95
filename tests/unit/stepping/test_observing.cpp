#include "run_all.hpp"
#include "small_scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

struct Sample {
    std::size_t k;
    double time;
    std::vector<BodyState> states;
};

std::vector<Sample> samples_of(const Scene& scene, const Method& method, double end, std::vector<double> times,
                               Outcome* outcome = nullptr)
{
    std::vector<Sample> samples;
    Observer observer;
    observer.sample_times = std::move(times);
    observer.on_sample = [&](std::size_t k, double time, std::span<const BodyState> states) {
        samples.push_back({k, time, {states.begin(), states.end()}});
    };
    const Outcome o = run_discrete(scene, method, until(end), observer);
    if (outcome) *outcome = o;
    return samples;
}

}  // namespace

TEST_CASE("Samples are the initial state at 0, on the path inside a substep, and the final state at until",
          "[stepping]")
{
    const Scene scene =
        scene_of({ball(0.1, Vec3(0, 0, 5), Vec3(1, 0, 0)), ball(0.1, Vec3(3, 0, 5))}, {}, Vec3(0, 0, -10));
    const double end = 1.03;
    for (const Method& method : all_discrete(steps(0.1, 2))) {
        CAPTURE(name(method));
        Outcome outcome;
        const std::vector<double> times{0, 0, 0.02, 0.05, 0.06, 1.0, end};
        const auto samples = samples_of(scene, method, end, times, &outcome);
        REQUIRE(samples.size() == times.size());
        for (std::size_t k = 0; k < times.size(); ++k) {
            CHECK(samples[k].k == k);
            CHECK(samples[k].time == times[k]);
            REQUIRE(samples[k].states.size() == 2);
        }
        for (const std::size_t k : {0U, 1U}) {
            CHECK(samples[k].states[0].position == scene.spheres[0].position);
            CHECK(samples[k].states[0].velocity == scene.spheres[0].velocity);
        }
        // First substep: v_z = -0.5 at its end, z falls by 0.025; second: v_z = -1, another 0.05. Paths are straight,
        // velocities follow gravity.
        CHECK(samples[2].states[0].position.z() == Approx(5 - 0.025 * 0.4));
        CHECK(samples[2].states[0].position.x() == Approx(0.02));
        CHECK(samples[2].states[0].velocity.z() == Approx(-0.2));
        CHECK(samples[3].states[0].position.z() == Approx(5 - 0.025));
        CHECK(samples[3].states[0].velocity.z() == Approx(-0.5));
        CHECK(samples[4].states[0].position.z() == Approx(5 - 0.025 - 0.05 * 0.2));
        CHECK(samples[4].states[0].velocity.z() == Approx(-0.6));
        CHECK(samples.back().states[1].position == outcome.final[1].position);
        CHECK(samples.back().states[0].velocity == outcome.final[0].velocity);
    }
}

TEST_CASE("Inside a substep a sample of a parabola is on it, and after a corner on the next one", "[stepping]")
{
    StepOptions options = steps(0.5);
    options.integrator = Integrator::parabola;
    const Scene fall = scene_of({ball(0.1, Vec3(0, 0, 5), Vec3(1, 0, 2))}, {}, Vec3(0, 0, -10));
    for (const Method& method : all_discrete(options)) {
        CAPTURE(name(method));
        for (const Sample& sample : samples_of(fall, method, 1, {0.1, 0.37, 0.5, 0.81})) {
            const double t = sample.time;
            CHECK((sample.states[0].position - Vec3(t, 0, 5 + 2 * t - 5 * t * t)).norm() < 1e-14);
            CHECK((sample.states[0].velocity - Vec3(1, 0, 2 - 10 * t)).norm() < 1e-14);
        }
    }
    // Elastic floor at 4.9 below the ball's lowest point: hit at 0.7, back at the same speed.
    const Scene bounce = scene_of({ball(0.1, Vec3(0, 0, 2.55))}, {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -10));
    options.dt = 1;
    for (const char* method : {"bisection", "toi"}) {
        CAPTURE(method);
        for (const Sample& sample : samples_of(bounce, make_method(method, options), 1, {0.6, 0.8, 0.95})) {
            const double t = sample.time, s = t < 0.7 ? t : 1.4 - t;
            CHECK(sample.states[0].position.z() == Approx(2.55 - 5 * s * s).epsilon(1e-13));
            CHECK(sample.states[0].velocity.z() == Approx(t < 0.7 ? -10 * s : 10 * s).epsilon(1e-13));
        }
    }
}

TEST_CASE("Under velocity a ball that is struck moves with one velocity for all of the substep, one at rest with none",
          "[stepping]")
{
    // Closed at the start of the substep; elastic.
    const Scene bounce = scene_of({ball(0.1, Vec3(0, 0, 0.1), Vec3(0, 0, -1))}, {wall(Vec3::UnitZ(), 0)});
    const auto samples = samples_of(bounce, VelocityBased{steps(0.1)}, 0.1, {0.03, 0.1});
    CHECK(samples[0].states[0].velocity.z() == 1);
    CHECK(samples[0].states[0].position.z() == Approx(0.13));
    CHECK(samples[1].states[0].velocity.z() == 1);
}

TEST_CASE("Looking does not change a run", "[stepping]")
{
    const Scene scene = gas(40, 0.1, 1.2, 3);
    for (const Method& method : all_discrete(steps(1.0 / 60))) {
        CAPTURE(name(method));
        const Outcome unseen = run_discrete(scene, method, until(0.5));
        Outcome seen;
        std::size_t events = 0;
        Observer observer;
        observer.sample_times = sample_grid(0.5, 77);
        observer.on_sample = [](std::size_t, double, std::span<const BodyState>) {};
        observer.on_event = [&](const Event&) { ++events; };
        observer.on_progress = [](double) { return true; };
        seen = run_discrete(scene, method, until(0.5), observer);
        CHECK(seen.counts.impacts == unseen.counts.impacts);
        CHECK(events == static_cast<std::size_t>(unseen.counts.impacts));
        CHECK(events > 20);
        for (std::size_t i = 0; i < 40; ++i) REQUIRE(seen.final[i].position == unseen.final[i].position);
    }
}

TEST_CASE("Event times do not decrease and lie in the run", "[stepping]")
{
    const Scene scene = gas(60, 0.1, 1.3, 3);
    for (const Method& method : all_discrete(steps(1.0 / 60, 2))) {
        double last = 0;
        Observer observer;
        observer.on_event = [&](const Event& e) {
            REQUIRE(e.time >= last);
            REQUIRE(e.a < e.b);
            REQUIRE(e.normal.norm() == Approx(1));
            last = e.time;
        };
        run_discrete(scene, method, until(0.5), observer);
        CHECK(last > 0.4);
        CHECK(last <= 0.5);
    }
}

TEST_CASE("max_events bounds the substeps", "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3::Zero(), Vec3(1, 0, 0))});
    for (const Method& method : all_discrete(steps(0.1, 2))) {
        RunOptions options = until(1);
        options.max_events = 7;
        const Outcome outcome = run_discrete(scene, method, options);
        CHECK(outcome.status == Status::event_limit);
        CHECK(outcome.counts.steps == 7);
        CHECK(outcome.time == Approx(0.35));
        CHECK(outcome.final[0].position.x() == Approx(0.35));
        CHECK(!outcome.message.empty());
        options.max_events = 20;
        CHECK(run_discrete(scene, method, options).status == Status::reached_end);
    }
}

TEST_CASE("The observer can stop a run, and the wall clock does", "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3::Zero(), Vec3(1, 0, 0))});
    for (const Method& method : all_discrete(steps(1e-3))) {
        int calls = 0;
        Observer observer;
        observer.on_progress = [&](double) { return ++calls < 3; };
        const Outcome interrupted = run_discrete(scene, method, until(1), observer);
        CHECK(interrupted.status == Status::interrupted);
        CHECK(interrupted.time > 0);
        CHECK(interrupted.time < 0.5);
        CHECK(interrupted.final[0].position.x() == Approx(interrupted.time));
        RunOptions options = until(1);
        options.max_seconds = 0;
        const Outcome late = run_discrete(scene, method, options);
        CHECK(late.status == Status::time_limit);
        CHECK(late.time < 0.5);
    }
}

TEST_CASE("A substep of many passes is left when the run is to stop", "[stepping]")
{
    // Overlapping spheres between walls that leave no room: no pass is the last one by itself.
    std::vector<Sphere> row;
    for (int i = 0; i < 100; ++i) row.push_back(ball(0.1, Vec3(0.15 * i, 0, 0), Vec3(i % 2 == 0 ? 1 : -1, 0, 0)));
    const Scene scene = scene_of(row, {wall(Vec3(1, 0, 0), 0), wall(Vec3(-1, 0, 0), -14.85)});
    constexpr int most = 2'000'000'000;
    for (const char* method : {"pbd", "velocity"}) {
        StepOptions options = steps(1e-3);
        options.passes = most;
        RunOptions limited = until(1);
        limited.max_seconds = 0.05;
        const Outcome outcome = simulate(scene, make_method(method, options), limited);
        CAPTURE(method);
        CHECK(outcome.status == Status::time_limit);
        CHECK(outcome.counts.steps == 1);
        CHECK(outcome.final.size() == row.size());
    }
    // Passes that find nothing take time as well.
    StepOptions options = steps(1e-3);
    options.passes = most;
    RunOptions limited = until(1);
    limited.max_seconds = 0.05;
    const Scene apart = scene_of({ball(0.1, Vec3(0, 0, 0)), ball(0.1, Vec3(1, 0, 0))});
    CHECK(simulate(apart, make_method("pbd", options), limited).status == Status::time_limit);
}

TEST_CASE("A position that is no longer finite ends the run and is named", "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3(0, 0, 0)), ball(0.1, Vec3(1e308, 0, 0), Vec3(1e307, 0, 0))});
    for (const Method& method : all_discrete(steps(1))) {
        const Outcome outcome = run_discrete(scene, method, until(20));
        CHECK(outcome.status == Status::unresolved);
        CHECK(outcome.message.find("diverged") != std::string::npos);
        CHECK(outcome.message.find("sphere-1") != std::string::npos);
        CHECK(outcome.time == Approx(8));
    }
}

TEST_CASE("Options out of range are a status, not a crash", "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3::Zero())});
    for (const StepOptions& options : {steps(0), steps(-1), steps(0.1, 0), steps(0.1, 1, 0)}) {
        for (const Method& method : all_discrete(options)) {
            const Outcome outcome = run_discrete(scene, method, until(1));
            CHECK(outcome.status == Status::unresolved);
            CHECK(!outcome.message.empty());
        }
    }
}

TEST_CASE("Outcomes of discrete methods have no rest times, no hash, and count what was examined", "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3::Zero()), ball(0.1, Vec3(1, 0, 0)), ball(0.1, Vec3(2, 0, 0))},
                                 {wall(Vec3::UnitZ(), -5), wall(Vec3::UnitX(), -5)});
    for (const Method& method : all_discrete(steps(0.1))) {
        CAPTURE(name(method));
        const Outcome outcome = run_discrete(scene, method, until(1));
        CHECK(outcome.rest_times == std::vector<std::optional<double>>(3));
        CHECK(outcome.event_hash == 0);
        CHECK(outcome.epoch_length == 1);
        CHECK(outcome.kernel.empty());
        // Those that look at the start of a step look once more at the end, for the record.
        const bool once_more = !std::holds_alternative<PositionBased>(method) &&
                               !std::holds_alternative<Bisection>(method) && !std::holds_alternative<Naive>(method) &&
                               !std::holds_alternative<Soft>(method) && !std::holds_alternative<ImpactSubsteps>(method);
        const int looks = once_more ? 11 : 10;
        CHECK(outcome.counts.pair_tests == looks * (3 + 6));
    }
}
