// Known answers of several contacts at one instant. Sources and closed forms stand with each.
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double exact = 1e-12;  // of answers of size 1

/// Balls of radius 1/2 along x, each touching the next: every gap is exactly 0. Speeds along x.
Scene touching_row(const std::vector<double>& speeds, const std::vector<double>& masses = {}, double restitution = 1)
{
    Scene scene = empty_scene(0.5, Vec3::Zero(), restitution);
    for (std::size_t i = 0; i < speeds.size(); ++i)
        add_sphere(scene, 0.5, {static_cast<double>(i), 0, 0}, {speeds[i], 0, 0}, masses.empty() ? 1 : masses[i]);
    return scene;
}

std::vector<double> speeds_after(const Scene& scene, bool certified = false)
{
    EventDriven method;
    method.certified = certified;
    const Recorded run = record(scene, method);
    INFO(run.outcome.message);
    CHECK(run.outcome.status == Status::reached_end);
    std::vector<double> speeds;
    for (const BodyState& s : run.outcome.final) {
        CHECK(std::abs(s.velocity.y()) + std::abs(s.velocity.z()) <= exact);
        speeds.push_back(s.velocity.x());
    }
    return speeds;
}

void check_speeds(const std::vector<double>& found, const std::vector<double>& expected)
{
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        INFO("ball " << i);
        CHECK(found[i] == Approx(expected[i]).margin(exact));
    }
}

Scene with(Scene scene, ImpactOperator impact_operator)
{
    scene.impact.impact_operator = impact_operator;
    return scene;
}

/// One wall after the other, in this order, each turning back what approaches it.
struct InTurn {
    Vec3 velocity;
    int reflections = 0;
};
InTurn reflect_in_turn(const std::vector<Plane>& planes, Vec3 v)
{
    InTurn result{v};
    for (bool changed = true; changed;) {
        changed = false;
        for (const Plane& p : planes)
            if (const double c = p.normal.dot(result.velocity); c < 0) {
                result.velocity -= 2 * c * p.normal;
                ++result.reflections;
                changed = true;
            }
    }
    return result;
}

/// Three touching balls, pair after pair, the left one first; impulses are counted as far as `most`. In the closing
/// speeds, for velocities round to the size of the first ones while the answer may be 1e-50 of them.
struct PairsInTurn {
    std::array<double, 2> closing{1, 1};
    int impulses = 0;
    /// The momenta add up to 0.
    std::vector<double> velocities() const
    {
        const double middle = (closing[1] - closing[0]) / 3;
        return {middle + closing[0], middle, middle - closing[1]};
    }
};
PairsInTurn pairs_in_turn(double e, int most)
{
    PairsInTurn result;
    auto& c = result.closing;
    for (bool changed = true; changed && result.impulses < most;) {
        changed = false;
        for (const std::size_t i : {0u, 1u})
            if (c[i] > 0) {
                c[1 - i] += (1 + e) / 2 * c[i];
                c[i] *= -e;
                ++result.impulses;
                changed = true;
            }
    }
    return result;
}

/// Ball 0 comes along x and meets two that touch, at the same moment.
Scene bernoulli(double restitution)
{
    Scene scene = empty_scene(2, Vec3::Zero(), restitution);
    add_sphere(scene, 0.5, {-std::sqrt(0.75) - 1, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0.5, 0});
    add_sphere(scene, 0.5, {0, -0.5, 0});
    return scene;
}

/// Fifteen touching balls, ball (row, column) at index row (row + 1) / 2 + column, and the cue ball last, on the axis.
Scene rack(double end_time)
{
    Scene scene = empty_scene(end_time);
    const double r = 0.028575;
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column <= row; ++column)
            add_sphere(scene, r, {row * std::sqrt(3.0) * r, (2 * column - row) * r, 0}, Vec3::Zero(), 0.17);
    add_sphere(scene, r, {-0.25, 0, 0}, {5, 0, 0}, 0.17);
    return scene;
}

Vec3 momentum(const Scene& scene, const std::vector<BodyState>& states)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < states.size(); ++i) sum += scene.spheres[i].mass * states[i].velocity;
    return sum;
}

/// Balls of radius 1/2 on each other on the floor z = 0, the first of them `heavy`.
Scene tower(int n, const Vec3& gravity, double heavy = 1)
{
    Scene scene = empty_scene(1, gravity);
    add_floor(scene);
    for (int k = 0; k < n; ++k) add_sphere(scene, 0.5, {0, 0, 0.5 + k}, Vec3::Zero(), k == 0 ? heavy : 1);
    return scene;
}

}  // namespace

TEST_CASE("cradle of 5 touching balls: k come in, the last k leave, the others stand still")
{
    for (const bool certified : {false, true}) {
        for (std::size_t k = 1; k <= 4; ++k) {
            std::vector<double> before(5, 0), after(5, 0);
            for (std::size_t i = 0; i < k; ++i) before[i] = after[4 - i] = 1;
            INFO("k " << k << (certified ? ", certified" : ""));
            check_speeds(speeds_after(touching_row(before), certified), after);

            Scene apart = touching_row(before);  // and when the k arrive from afar
            for (std::size_t i = 0; i < k; ++i) apart.spheres[i].position.x() -= 0.25;
            check_speeds(speeds_after(apart, certified), after);
            const Recorded run = record(apart);
            CHECK(run.outcome.counts.impacts == 4);
            CHECK(run.outcome.counts.clusters == 1);
            for (const Event& e : run.events) CHECK(e.time == 0.25);
        }
    }
}

TEST_CASE("one complementarity problem scatters the cradle: (-.6, .4, .4, .4, .4)")
{
    for (const LcpSolver solver : {LcpSolver::exact, LcpSolver::gauss_seidel})
        for (const LcpLaw law : {LcpLaw::newton, LcpLaw::poisson}) {
            Scene scene = with(touching_row({1, 0, 0, 0, 0}), ImpactOperator::lcp);
            scene.impact.lcp = {law, solver, 10000};
            check_speeds(speeds_after(scene), {-0.6, 0.4, 0.4, 0.4, 0.4});
        }
}

TEST_CASE("a chain of masses 1, 2, 1: (-1/3, 2/9, 8/9) by reflections, (-1/2, 1/2, 1/2) by one problem")
{
    const Scene chain = touching_row({1, 0, 0}, {1, 2, 1});
    check_speeds(speeds_after(chain), {-1.0 / 3, 2.0 / 9, 8.0 / 9});
    check_speeds(speeds_after(with(chain, ImpactOperator::lcp)), {-0.5, 0.5, 0.5});
}

TEST_CASE("three touching in a row, the outer ones inwards: (-e, 0, e)")
{
    for (const double e : {1.0, 0.75, 0.5, 0.25})
        check_speeds(speeds_after(touching_row({1, 0, -1}, {}, e)), {-e, 0, e});
}

TEST_CASE("Bernoulli's problem, elastic and plastic")
{
    for (const auto& [e, first, along, across] :
         {std::array{1.0, -0.2, 0.6, 0.34641016151377546}, std::array{0.0, 0.4, 0.3, 0.17320508075688773}}) {
        const Scene scene = bernoulli(e);
        const Recorded run = record(scene);
        INFO("e " << e << " " << run.outcome.message);
        CHECK(run.outcome.status == Status::reached_end);
        CHECK(run.outcome.counts.impacts == 2);
        CHECK((run.outcome.final[0].velocity - Vec3(first, 0, 0)).norm() <= exact);
        CHECK((run.outcome.final[1].velocity - Vec3(along, across, 0)).norm() <= exact);
        CHECK((run.outcome.final[2].velocity - Vec3(along, -across, 0)).norm() <= exact);
        CHECK(kinetic_energy(scene, run.outcome.final) == Approx(e == 1 ? 0.5 : 0.2).epsilon(exact));
    }
}

TEST_CASE("a rack of 15 hit on its axis breaks as a mirror shows it")
{
    const double contact = (0.25 - 2 * 0.028575) / 5;
    for (const double after : {1e-3, 0.05}) {
        const Scene scene = rack(contact + after);
        const Recorded run = record(scene);
        INFO(run.outcome.message);
        REQUIRE(run.outcome.status == Status::reached_end);
        const std::vector<BodyState>& s = run.outcome.final;
        for (std::size_t row = 0; row < 5; ++row)
            for (std::size_t column = 0; column <= row; ++column) {
                const BodyState &left = s[row * (row + 1) / 2 + column], &right = s[row * (row + 1) / 2 + row - column];
                CHECK((left.velocity - Vec3(right.velocity.x(), -right.velocity.y(), 0)).norm() <= 5 * exact);
                CHECK((left.position - Vec3(right.position.x(), -right.position.y(), 0)).norm() <= exact);
            }
        CHECK(std::abs(s[15].velocity.y()) <= 5 * exact);
        CHECK((momentum(scene, s) - Vec3(0.85, 0, 0)).norm() <= exact);
        CHECK(kinetic_energy(scene, s) == Approx(2.125).epsilon(exact));
        CHECK(s[10].velocity.norm() > 0.1);  // the far corners go
        CHECK(s[14].velocity.norm() > 0.1);
    }
}

TEST_CASE("a sphere into a right-angled corner, or three walls at once, is sent back")
{
    for (const int walls : {2, 3}) {
        Scene scene = empty_scene(2);
        for (int k = 0; k < walls; ++k) add_plane(scene, "wall " + std::to_string(k), Vec3::Unit(k));
        const Vec3 v = walls == 2 ? Vec3(-0.5, -0.25, 0) : Vec3(-0.5, -0.25, -1);
        add_sphere(scene, 0.5, Vec3(0.5, 0.5, 0.5) - v, v);  // touches all of them after 1
        const Recorded run = record(scene);
        INFO("walls " << walls << " " << run.outcome.message);
        CHECK(run.outcome.counts.impacts == walls);
        for (const Event& e : run.events) CHECK(e.time == 1);
        CHECK((run.outcome.final[0].velocity + v).norm() <= exact);
        CHECK((run.outcome.final[0].position - scene.spheres[0].position).norm() <= exact);
    }
}

TEST_CASE("one wall after the other in a wedge: as many reflections as the angle asks for")
{
    const std::array<std::pair<double, int>, 8> rows{
        {{90, 2}, {60, 3}, {50, 4}, {45, 4}, {30, 5}, {10, 16}, {1, 163}, {0.1, 1633}}};
    for (const auto& [degrees, count] : rows) {
        const double half = degrees / 360 * 3.14159265358979323846;
        Scene scene = with(empty_scene(0.25), ImpactOperator::sequential);
        add_plane(scene, "plus", {std::cos(half), 0, std::sin(half)});
        add_plane(scene, "minus", {-std::cos(half), 0, std::sin(half)});
        const Vec3 v(0.3, 0, -1);
        add_sphere(scene, 1, {0, 0, 1 / std::sin(half)}, v);
        const InTurn expected = reflect_in_turn(scene.planes, v);
        CHECK(expected.reflections == count);
        const Recorded run = record(scene);
        INFO(degrees << " degrees " << run.outcome.message);
        CHECK(run.outcome.status == Status::reached_end);
        CHECK((run.outcome.final[0].velocity - expected.velocity).norm() <= 1e-9);

        // Where both walls are approached, the generalized reflection turns the velocity round.
        if (scene.planes[0].normal.dot(v) >= 0) continue;
        const Recorded reflected = record(with(scene, ImpactOperator::reflections));
        CHECK((reflected.outcome.final[0].velocity + v).norm() <= 1e-9);
    }
}

TEST_CASE("two-ball drop: 3 below and 1 above, touching, both at 1 down: (0, 2)")
{
    Scene scene = empty_scene(2);
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 1.5}, {0, 0, -1}, 3);
    add_sphere(scene, 0.25, {0, 0, 2.25}, {0, 0, -1}, 1);
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    CHECK((run.outcome.final[0].velocity).norm() <= exact);
    CHECK((run.outcome.final[1].velocity - Vec3(0, 0, 2)).norm() <= exact);
}

TEST_CASE("a ball of 1 onto a resting ball of 2 on the floor: 4/9 and 7/9 of its speed, upwards")
{
    for (const Vec3& gravity : {Vec3(0, 0, 0), earth}) {
        Scene scene = tower(1, gravity, 2);
        const double fall = 0.5, g = -gravity.z();
        const double start = g > 0 ? 0 : -2;  // it falls, or is thrown
        add_sphere(scene, 0.5, {0, 0, 1.5 + fall}, {0, 0, start});
        const double contact = g > 0 ? std::sqrt(2 * fall / g) : 0.25, speed = g > 0 ? g * contact : 2;
        const double later = 1e-3;  // free flight since the impact
        scene.end_time = contact + later;
        const Recorded run = record(scene);
        INFO("gravity " << g << " " << run.outcome.message);
        CHECK(run.outcome.status == Status::reached_end);
        CHECK(run.outcome.final[0].velocity.z() + g * later == Approx(speed * 4 / 9).epsilon(exact));
        CHECK(run.outcome.final[1].velocity.z() + g * later == Approx(speed * 7 / 9).epsilon(exact));
    }
}

TEST_CASE("a ball onto a resting tower of 5 leaves with its speed reversed, and the tower stands")
{
    for (const Vec3& gravity : {Vec3(0, 0, 0), earth}) {
        Scene scene = tower(5, gravity);
        add_sphere(scene, 0.5, {0, 0, 5.75}, {0, 0, -2});
        const double g = -gravity.z();
        const double contact = g > 0 ? (std::sqrt(4 + 2 * g * 0.25) - 2) / g : 0.125;
        const double speed = 2 + g * contact, later = 1e-2;
        scene.end_time = contact + later;
        const Recorded run = record(scene);
        INFO("gravity " << g << " " << run.outcome.message);
        CHECK(run.outcome.status == Status::reached_end);
        CHECK(run.outcome.final[5].velocity.z() + g * later == Approx(speed).epsilon(exact));
        for (std::size_t k = 0; k < 5; ++k) {
            CHECK(run.outcome.final[k].velocity.norm() <= exact);
            CHECK((run.outcome.final[k].position - scene.spheres[k].position).norm() <= 1e-12);
        }
    }
}

TEST_CASE("a pile-up of n plastic balls goes on at v/n with 1/n of the energy")
{
    for (std::size_t n = 2; n <= 12; ++n) {
        std::vector<double> before(n, 0);
        before[0] = 1;
        Scene scene = touching_row(before, {}, 0);
        scene.spheres[0].position.x() -= 0.25;
        INFO("n " << n);
        check_speeds(speeds_after(scene), std::vector<double>(n, 1 / static_cast<double>(n)));
        const Recorded run = record(scene);
        CHECK(kinetic_energy(scene, run.outcome.final) == Approx(0.5 / static_cast<double>(n)).epsilon(exact));
    }
}

TEST_CASE("pair after pair on a line ends if and only if e > 7 - 4 sqrt(3)")
{
    const std::array<std::pair<double, int>, 6> rows{
        {{0.0719, 89}, {0.072, 64}, {0.078, 12}, {0.08, 11}, {0.09, 8}, {0.1, 6}}};
    for (const auto& [e, count] : rows) {
        const PairsInTurn expected = pairs_in_turn(e, 1000);
        CHECK(expected.impulses == count);
        const Scene scene = touching_row({1, 0, -1}, {}, e);
        INFO("e " << e);
        check_speeds(speeds_after(with(scene, ImpactOperator::sequential)), expected.velocities());
        check_speeds(speeds_after(scene), {-e, 0, e});
    }
    // Below, the operator has to give up, and says what holds without restitution: nothing moves any more.
    CHECK(pairs_in_turn(0.0717, 100000).impulses == 100000);
    check_speeds(speeds_after(with(touching_row({1, 0, -1}, {}, 0.05), ImpactOperator::sequential)), {0, 0, 0});
}

TEST_CASE("an elastic run with impacts of several contacts goes back to its start")
{
    Scene scene = touching_row({1, 0, 0, 0, 0}, {1, 2, 3, 2, 1});
    scene.spheres[0].position.x() -= 0.25;
    scene.end_time = 1;
    const Recorded there = record(scene);
    CHECK(there.outcome.counts.clusters >= 1);
    Scene back = scene;
    // Only balls that left each other can come back one by one: a cradle that scatters is no cluster on its way back.
    for (std::size_t i = 0; i < 5; ++i) {
        back.spheres[i].position = there.outcome.final[i].position;
        back.spheres[i].velocity = -there.outcome.final[i].velocity;
    }
    const Recorded again = record(back);
    INFO(again.outcome.message);
    CHECK(kinetic_energy(back, again.outcome.final) == Approx(0.5).epsilon(exact));
    CHECK((momentum(back, again.outcome.final) + Vec3(1, 0, 0)).norm() <= exact);

    // One that swaps is: five equal balls.
    Scene equal = touching_row({1, 0, 0, 0, 0});
    equal.spheres[0].position.x() -= 0.25;
    Scene reversed = equal;
    const Recorded out = record(equal);
    for (std::size_t i = 0; i < 5; ++i) {
        reversed.spheres[i].position = out.outcome.final[i].position;
        reversed.spheres[i].velocity = -out.outcome.final[i].velocity;
    }
    const Recorded home = record(reversed);
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK((home.outcome.final[i].position - equal.spheres[i].position).norm() <= exact);
        CHECK((home.outcome.final[i].velocity + equal.spheres[i].velocity).norm() <= exact);
    }
}
