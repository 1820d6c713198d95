#include "study/drag_work.hpp"
#include "support/damped_law.hpp"
#include "support/random.hpp"

#include "make_sphere.hpp"

#include <carom/study.hpp>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace carom;
using namespace carom::test;
using study::damped_energy;
using study::DragWork;

namespace {

using Real = Float<100>;

/// v0^2 / 2 - v^2 / 2 + a.(x - x0): what a flight loses beside the work of its acceleration [energy/mass].
Real lost_energy(double drag, const FlightRecord& flight, double t)
{
    const DampedTime<Real> effect{Real(drag), Real(t)};
    Real lost(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const Real v(flight.velocity[k]), a(flight.own[k]), after = effect.speed(v, a);
        lost += (v * v - after * after) / 2 + a * effect.place(Real(0), v, a);
    }
    return lost;
}

FlightRecord flight_with(const Vec3& velocity, const Vec3& acceleration)
{
    FlightRecord flight;
    flight.acceleration = own_acceleration;
    for (std::size_t k = 0; k < 3; ++k) {
        flight.velocity[k] = velocity[static_cast<Eigen::Index>(k)];
        flight.own[k] = acceleration[static_cast<Eigen::Index>(k)];
    }
    return flight;
}

}  // namespace

TEST_CASE("the energy that drag takes from 100,000 flights is what they lose, by 100 digits", "[drag_work]")
{
    Random random(1);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        RunFrame frame;
        frame.drag = random.log_uniform(1e-12, 1e3);
        const double t = random.log_uniform(1e-6, 1e3);
        const Vec3 v = random.in_cube(random.log_uniform(1e-6, 10)), a = random.in_cube(10);
        const FlightRecord flight = flight_with(v, a);
        // Beside the energies that the flight has on its way.
        const double scale = v.squaredNorm() + (v.norm() + a.norm() * t) * a.norm() * t;
        const Real error = abs(Real(damped_energy(frame, flight, t)) - lost_energy(frame.drag, flight, t)) / scale;
        worst = std::max(worst, error.convert_to<double>());
    }
    CHECK(worst < 4 * 0x1p-53);
}

TEST_CASE("the work of drag is added up over flights, bodies and the flights under way", "[drag_work]")
{
    Scene scene;
    scene.spheres = {make_sphere("a", 1, Vec3::Zero()), make_sphere("b", 1, Vec3(5, 0, 0))};
    scene.spheres[1].mass = 3;
    DragWork work(scene);
    const RunFrame frame{0.5, 1, 0.25, {Vec3::Zero()}};
    work.on_frame(frame);
    CHECK(work.taken(0) == 0);
    FlightRecord a = flight_with({2, 0, 0}, {0, 0, -1}), b = flight_with({0, 1, 0}, {0, 0, -1});
    a.body = 0;
    b.body = 1;
    work.on_flight(a);
    work.on_flight(b);
    const double first = damped_energy(frame, a, 1.25);
    FlightRecord bounced = flight_with({-1, 0, 0}, {0, 0, -1});
    bounced.body = 0;
    bounced.start = {2, 0.25};  // 1.25 in epochs of 0.5
    work.on_flight(bounced);
    CHECK(work.taken(2) == Approx(first + damped_energy(frame, bounced, 0.75) + 3 * damped_energy(frame, b, 2)));
    // A ball that drag alone slows keeps exp(-2 k t) of its energy.
    CHECK(damped_energy(frame, flight_with({2, 0, 0}, Vec3::Zero()), 4) == Approx(2 - 2 * std::exp(-2.0)));
}

TEST_CASE("an event-driven run with drag keeps its books to rounding, and a discrete one has none", "[drag_work]")
{
    Scene scene;
    scene.gravity = Vec3(0, 0, -9.81);
    scene.drag = 0.4;
    scene.end_time = 3;
    scene.materials = {{"ivory", 1, 1, ""}};
    scene.planes.emplace_back();
    scene.planes.back().id = "floor";
    const char* const names[] = {"a", "b", "c", "d"};
    for (int i = 0; i < 4; ++i) {
        scene.spheres.push_back(make_sphere(names[i], 0.1, Vec3(0.3 * i, 0.01 * i, 0.5 + 0.3 * i)));
        scene.spheres.back().velocity = Vec3(1 - 0.7 * i, 0, 1);
    }
    const RunStudy run = run_study(scene, EventDriven{});
    CHECK(run.outcome.counts.impacts > 10);
    REQUIRE(run.drag_energy);
    CHECK(*run.drag_energy > 1);
    CHECK(run.initial_energy - run.final_energy == Approx(*run.drag_energy).epsilon(1e-12));
    REQUIRE(run.max_relative_drift);
    CHECK(*run.max_relative_drift < 1e-13);
    CHECK(run.max_energy_change > 1);
    StepOptions step;
    step.dt = 1e-3;
    const RunStudy stepped = run_study(scene, make_method("velocity", step));
    CHECK_FALSE(stepped.drag_energy);
    CHECK_FALSE(stepped.max_relative_drift);
    scene.drag = 0;
    CHECK(run_study(scene, make_method("velocity", step)).drag_energy == 0);
}
