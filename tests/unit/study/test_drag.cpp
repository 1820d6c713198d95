#include "study/audit/truth.hpp"
#include "study/row_plan.hpp"

#include "make_sphere.hpp"

#include <carom/metrics.hpp>
#include <carom/study.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace carom;
using namespace carom::study;

namespace {

Plane floor_plane()
{
    Plane plane;
    plane.id = "floor";
    plane.normal = Vec3::UnitZ();
    return plane;
}

/// An elastic ball that bounces ever lower in a viscous field, moving aside.
Scene viscous_bounces()
{
    Scene scene;
    scene.gravity = Vec3(0, 0, -9.81);
    scene.drag = 0.6;
    scene.end_time = 3;
    scene.spheres.push_back(make_sphere("ball", 0.1, Vec3(0, 0, 1.1)));
    scene.spheres.back().velocity = Vec3(0.5, 0, 0);
    scene.planes = {floor_plane()};
    return scene;
}

const CompareRow& row_of(const Comparison& comparison, const std::string& method, std::optional<Integrator> integrator)
{
    const auto found = std::find_if(comparison.rows.begin(), comparison.rows.end(), [&](const CompareRow& row) {
        return row.method == method && row.integrator == integrator;
    });
    REQUIRE(found != comparison.rows.end());
    return *found;
}

}  // namespace

TEST_CASE("drag takes energy, though every contact keeps it", "[drag]")
{
    Scene scene = viscous_bounces();
    CHECK_FALSE(conserves_energy(scene));
    scene.drag = 0;
    CHECK(conserves_energy(scene));
}

TEST_CASE("both integrators are rows where drag slows, with gravity or without", "[drag]")
{
    CompareOptions options;
    options.methods = {"pbd"};
    options.dt = {0.01};
    options.integrators = {Integrator::euler, Integrator::parabola};
    Scene scene = viscous_bounces();
    CHECK(rows_to_run(scene, options).size() == 2);
    scene.gravity = Vec3::Zero();
    CHECK(rows_to_run(scene, options).size() == 2);
    scene.drag = 0;
    CHECK(rows_to_run(scene, options).size() == 1);
}

TEST_CASE("the truth of the audit goes on along damped flights, and back before the first", "[drag]")
{
    Truth truth;
    truth.drag = 0.5;
    truth.flights = {{TruthFlight{1, Vec3(0, 0, 2), Vec3(3, 0, 1), Vec3(0, 0, -4), true}}};
    for (const double time : {-0.5, 1.0, 1.25, 9.0}) {
        // v = g/k + (v0 - g/k) e^(-k t), and its integral.
        const double t = time - 1, decay = std::exp(-0.5 * t);
        const TruthState state = truth.state(0, time);
        CHECK(state.velocity.x() == Approx(3 * decay).epsilon(1e-14));
        CHECK(state.velocity.z() == Approx(-8 + 9 * decay).epsilon(1e-14));
        CHECK(state.position.x() == Approx(6 * (1 - decay)).margin(1e-14));
        CHECK(state.position.z() == Approx(2 - 8 * t + 18 * (1 - decay)).margin(1e-13));
    }
}

TEST_CASE("the truth of a run with drag has the states that the run shows", "[drag]")
{
    const Scene scene = viscous_bounces();
    const Truth truth = record_truth(scene, scene.end_time, {});
    CHECK(truth.drag == scene.drag);
    CHECK(truth.contacts.size() >= 3);
    std::size_t shown = 0;
    Observer observer;
    observer.sample_times = sample_grid(scene.end_time, 300);
    observer.on_sample = [&](std::size_t, double time, std::span<const BodyState> states) {
        const TruthState state = truth.state(0, time);
        CHECK((state.position - states[0].position).norm() < 1e-12);
        ++shown;
    };
    simulate(scene, EventDriven{}, {}, observer);
    CHECK(shown == observer.sample_times.size());
}

TEST_CASE("a comparison with drag has exact rows for what is exact, and the error of euler for euler", "[drag]")
{
    const Scene scene = viscous_bounces();
    CompareOptions options;
    options.methods = {"event", "toi", "pbd"};
    options.dt = {1.0 / 60, 1.0 / 120, 1.0 / 240};
    options.integrators = {Integrator::euler, Integrator::parabola};
    options.until = scene.end_time;
    options.repeats = 1;
    const Comparison comparison = compare_methods(scene, options);
    REQUIRE(comparison.reference.reason.empty());
    CHECK(comparison.reference.series == 0);
    CHECK(comparison.reference.impacts >= 3);

    const CompareRow& event = row_of(comparison, "event", {});
    CHECK(event.status == Status::reached_end);
    CHECK(*event.position_max < 1e-12);
    CHECK(*event.energy_error < 1e-12);
    CHECK(event.missed_impacts == 0);
    CHECK(event.invented_impacts == 0);

    const CompareRow& exact = row_of(comparison, "toi", Integrator::parabola);
    CHECK(*exact.position_max < 1e-12);
    CHECK(*exact.energy_error < 1e-12);
    REQUIRE(exact.audit);
    CHECK(exact.audit->audited > 0);
    CHECK(exact.audit->found == exact.audit->audited);
    CHECK(exact.audit->invented == 0);
    CHECK(std::abs(exact.audit->delay.value()) < 1e-9);

    const CompareRow& euler = row_of(comparison, "toi", Integrator::euler);
    CHECK(*euler.position_max > 1e-3);
    // The energy of the reference falls by the work of drag: what a method is blamed for is the distance to it.
    const CompareRow& pbd = row_of(comparison, "pbd", Integrator::euler);
    CHECK(*pbd.energy_error > 1e-3);
    CHECK(event.series.energy.front() - event.series.energy.back() > 1);
}

TEST_CASE("a comparison says that euler is of first order in flight under drag", "[drag]")
{
    const Scene scene = viscous_bounces();
    CompareOptions options;
    options.methods = {"toi"};
    options.dt = {1.0 / 60, 1.0 / 120, 1.0 / 240};
    options.until = 0.4;  // before the first impact: at one the error depends on the phase of the step
    options.repeats = 1;
    const Comparison comparison = compare_methods(scene, options);
    CHECK(comparison.reference.impacts == 0);
    REQUIRE(comparison.convergence.size() == 1);
    CHECK(comparison.convergence[0].order == Approx(1).margin(0.03));
}
