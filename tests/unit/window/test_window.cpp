#include "random_heap.hpp"

#include "support/window_gap.hpp"
#include "window/window.hpp"

#include <catch2/catch.hpp>

using namespace carom;

namespace {

WindowOptions options_of(double length, WindowSolver solver)
{
    WindowOptions out;
    out.length = length;
    out.margin = 1e-3;
    out.closing_speed = length;
    out.speed_tolerance = 0.1 * length;
    out.solver = solver;
    return out;
}

double energy(const WindowProblem& problem, const WindowOutcome& outcome, double time, bool end)
{
    double out = 0;
    for (std::size_t i = 0; i < problem.bodies.size(); ++i) {
        const WindowBody& body = problem.bodies[i];
        if (!(body.inverse_mass > 0)) continue;
        const WindowMotion& motion = outcome.motions[i];
        const Vec3 place = body.place + time * (motion.velocity + (time / 2) * motion.acceleration);
        const Vec3 velocity = end ? motion.end_velocity : body.velocity;
        out += (velocity.squaredNorm() / 2 - body.acceleration.dot(place)) / body.inverse_mass;
    }
    return out;
}

/// The lowest gap of any two bodies at any time, less what they overlapped at the start.
double lowest_gap(const WindowProblem& problem, const WindowOutcome& outcome)
{
    double lowest = 1;
    for (std::size_t i = 0; i < problem.bodies.size(); ++i) {
        const auto note = [&](double at_start, double in_window) {
            lowest = std::min(lowest, in_window - std::min(0.0, at_start));
        };
        const WindowBody& a = problem.bodies[i];
        const WindowMotion& of_a = outcome.motions[i];
        for (std::size_t j = 0; j < i; ++j)
            note(test::least_gap(a, of_a, problem.bodies[j], outcome.motions[j], 0),
                 test::least_gap(a, of_a, problem.bodies[j], outcome.motions[j], outcome.length));
        for (const WindowPlane& plane : problem.planes)
            if (a.inverse_mass > 0)
                note(test::least_gap(a, of_a, plane, 0), test::least_gap(a, of_a, plane, outcome.length));
    }
    return lowest;
}

/// Largest difference of a body's change of momentum from the impulses along its normals and its weight.
double momentum_error(const WindowProblem& problem, const WindowOutcome& outcome)
{
    std::vector<Vec3> left;
    for (std::size_t i = 0; i < problem.bodies.size(); ++i) {
        const WindowBody& body = problem.bodies[i];
        const Vec3 fall = body.inverse_mass > 0 ? Vec3(outcome.length * body.acceleration) : Vec3(Vec3::Zero());
        left.emplace_back(outcome.motions[i].end_velocity - body.velocity - fall);
    }
    for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
        const WindowContact& c = problem.contacts[k];
        const Vec3 impulse = outcome.impulses[k] * geometry(problem, c).normal;
        const auto a = static_cast<std::size_t>(c.a), b = static_cast<std::size_t>(c.b.index);
        left[a] -= problem.bodies[a].inverse_mass * impulse;
        if (c.b.is_sphere()) left[b] += problem.bodies[b].inverse_mass * impulse;
    }
    double out = 0;
    for (const Vec3& each : left) out = std::max(out, each.norm());
    return out;
}

WindowProblem two_balls(double gap, const Vec3& velocity_a, const Vec3& velocity_b, double restitution)
{
    WindowProblem out;
    out.bodies = {{Vec3(2 + gap, 0, 0), velocity_a, Vec3::Zero(), 1.0 / 3, 1},
                  {Vec3::Zero(), velocity_b, Vec3::Zero(), 1.0 / 2, 1}};
    out.contacts = {{0, Partner::sphere(1), restitution, 0}};
    return out;
}

}  // namespace

TEST_CASE("nothing overlaps at any time of a window, whatever its length and its solver", "[window]")
{
    test::Random random(20);
    for (int k = 0; k < 300; ++k) {
        const WindowProblem problem = test::random_heap(random, random.integer(2, 20));
        const double length = random.log_uniform(1e-3, 1);
        const auto solver = random.coin() ? WindowSolver::exact : WindowSolver::relaxation;
        const WindowOutcome outcome = take_window(problem, options_of(length, solver));
        INFO("problem " << k << ", length " << length << ", status " << static_cast<int>(outcome.status));
        CHECK(outcome.status != WindowStatus::infeasible);
        CHECK(outcome.length <= length);
        CHECK(lowest_gap(problem, outcome) > -3e-11);
    }
}

TEST_CASE("energy never grows in a window, and what is taken is named", "[window]")
{
    test::Random random(21);
    for (int k = 0; k < 300; ++k) {
        const WindowProblem problem = test::random_heap(random, random.integer(2, 20));
        const auto solver = random.coin() ? WindowSolver::exact : WindowSolver::relaxation;
        const WindowOutcome outcome = take_window(problem, options_of(random.log_uniform(1e-3, 1), solver));
        const double before = energy(problem, outcome, 0, false),
                     after = energy(problem, outcome, outcome.length, true);
        INFO("problem " << k << ", solver " << static_cast<int>(solver));
        CHECK(after <= before + 1e-7 * 1e-2 * std::abs(before));
        CHECK(before - after ==
              Approx(outcome.taken_by_window + outcome.taken_by_restitution).margin(1e-12 * std::abs(before)));
    }
}

TEST_CASE("impulses push, and momentum changes by them and by weight alone", "[window]")
{
    test::Random random(22);
    for (int k = 0; k < 200; ++k) {
        const WindowProblem problem = test::random_heap(random, random.integer(2, 20));
        const auto solver = random.coin() ? WindowSolver::exact : WindowSolver::relaxation;
        const WindowOutcome outcome = take_window(problem, options_of(random.log_uniform(1e-3, 1), solver));
        INFO("problem " << k);
        for (const double impulse : outcome.impulses) CHECK(impulse >= 0);
        CHECK(momentum_error(problem, outcome) < 1e-12);
    }
}

TEST_CASE("exact windows of random heaps are the projection: complementary to rounding", "[window]")
{
    test::Random random(23);
    for (int k = 0; k < 200; ++k) {
        WindowProblem problem = test::random_heap(random, random.integer(2, 15));
        for (WindowContact& c : problem.contacts) c.restitution = 0;
        WindowOptions options = options_of(random.log_uniform(1e-3, 0.3), WindowSolver::exact);
        options.closing_speed = 1e9;  // no rebound: velocities at the end are the projection
        const WindowOutcome outcome = take_window(problem, options);
        if (outcome.status != WindowStatus::complete) continue;
        INFO("problem " << k);
        for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
            const WindowContact& c = problem.contacts[i];
            const auto a = static_cast<std::size_t>(c.a), b = static_cast<std::size_t>(c.b.index);
            const Vec3 apart = c.b.is_sphere() ? Vec3(outcome.motions[a].end_velocity - outcome.motions[b].end_velocity)
                                               : outcome.motions[a].end_velocity;
            const ContactGeometry g = geometry(problem, c);
            const double gap = g.gap + outcome.length * g.normal.dot(apart);
            const bool fixed =
                problem.bodies[a].inverse_mass == 0 && (c.b.is_plane() || problem.bodies[b].inverse_mass == 0);
            if (fixed) continue;
            CHECK(gap > -1e-10);
            // The product of force and gap, in units of weight and radius.
            CHECK(outcome.impulses[i] * gap < 1e-7 * std::max(1.0, outcome.impulses[i]));
        }
    }
}

TEST_CASE("a body that nothing holds keeps its parabola exactly", "[window]")
{
    WindowProblem problem;
    problem.bodies = {{Vec3(0, 0, 2), Vec3(0.5, 0, 1), -Vec3::UnitZ(), 1, 1},
                      {Vec3(10, 0, 1), Vec3::Zero(), -Vec3::UnitZ(), 1, 1}};
    problem.planes = {{Vec3::UnitZ(), 0, {}}};
    test::list_all_contacts(problem, 0);
    const double h = 0.1;
    const WindowOutcome outcome = take_window(problem, options_of(h, WindowSolver::exact));
    CHECK(outcome.motions[0].velocity == problem.bodies[0].velocity);
    CHECK(outcome.motions[0].acceleration == problem.bodies[0].acceleration);
    CHECK(outcome.motions[0].end_velocity.isApprox(Vec3(0.5, 0, 0.9), 1e-15));
    CHECK(outcome.motions[1].acceleration == Vec3::Zero());
    CHECK(outcome.impulses[2] == Approx(h).epsilon(2e-8));  // the weight of the one that lies, and a lift of 1e-10
}

TEST_CASE("a contact alone rebounds by the pair law", "[window]")
{
    const double e = GENERATE(0.0, 0.3, 0.7, 1.0);
    const Vec3 velocity_a(-1.5, 0.25, 0), velocity_b(1, 0, -0.5);
    const WindowProblem problem = two_balls(1e-3, velocity_a, velocity_b, e);
    const auto solver = GENERATE(WindowSolver::relaxation, WindowSolver::exact);
    const WindowOutcome outcome = take_window(problem, options_of(0.01, solver));
    // Masses 3 and 2, closing 2.5 along x: j = (1 + e) m_red 2.5.
    const double j = (1 + e) * (3.0 * 2 / 5) * 2.5;
    CHECK(outcome.impulses[0] == Approx(j).epsilon(1e-9));
    CHECK((outcome.motions[0].end_velocity - (velocity_a + Vec3(j / 3, 0, 0))).norm() < 1e-9);
    CHECK((outcome.motions[1].end_velocity - (velocity_b - Vec3(j / 2, 0, 0))).norm() < 1e-9);
}

TEST_CASE("a contact slower than the closing speed has no rebound", "[window]")
{
    const WindowProblem problem = two_balls(1e-3, Vec3(-0.004, 0, 0), Vec3::Zero(), 1);
    const WindowOutcome outcome = take_window(problem, options_of(10, WindowSolver::exact));
    const Vec3 apart = outcome.motions[0].end_velocity - outcome.motions[1].end_velocity;
    CHECK(std::abs(apart.x()) < 1.1e-4);  // it goes the gap of 1e-3 in 10
}

TEST_CASE("bodies on either side of a plate stay there", "[window]")
{
    WindowProblem problem;
    problem.bodies = {{Vec3(0, 0, 1.2), Vec3(0, 0, -100), Vec3::Zero(), 1, 1},
                      {Vec3(5, 0, -1.2), Vec3(0, 0, 100), Vec3::Zero(), 1, 1}};
    problem.planes = {{Vec3::UnitZ(), 0, 0.1}};
    test::list_all_contacts(problem, 0.5);
    const WindowOutcome outcome = take_window(problem, options_of(0.1, WindowSolver::relaxation));
    CHECK(outcome.status != WindowStatus::infeasible);
    CHECK(lowest_gap(problem, outcome) >= 0);
    CHECK(outcome.motions[0].end_velocity.z() == Approx(50));
    CHECK(outcome.motions[1].end_velocity.z() == Approx(-50));
}

TEST_CASE("a start that overlaps, and cannot be mended without energy, is infeasible and moves nothing", "[window]")
{
    const WindowProblem problem = two_balls(-0.1, Vec3::Zero(), Vec3::Zero(), 0);
    const auto solver = GENERATE(WindowSolver::relaxation, WindowSolver::exact);
    const WindowOutcome outcome = take_window(problem, options_of(0.01, solver));
    CHECK(outcome.status == WindowStatus::infeasible);
    CHECK(outcome.length == 0);
    CHECK(outcome.motions[0].end_velocity == Vec3::Zero());
}

TEST_CASE("a ball between two walls that close in is infeasible", "[window]")
{
    WindowProblem problem;
    problem.bodies = {{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), 1, 1},
                      {Vec3(2, 0, 0), Vec3(-1, 0, 0), Vec3::Zero(), 0, 1},
                      {Vec3(-2, 0, 0), Vec3(1, 0, 0), Vec3::Zero(), 0, 1}};
    problem.contacts = {{0, Partner::sphere(1), 0, 0}, {0, Partner::sphere(2), 0, 0}};
    CHECK(take_window(problem, options_of(0.01, WindowSolver::relaxation)).status == WindowStatus::infeasible);
}
