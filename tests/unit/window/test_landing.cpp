#include "random_heap.hpp"

#include "window/landing.hpp"

#include <catch2/catch.hpp>

#include <numbers>

using namespace carom;

namespace {

constexpr LandingOptions calm{1e-3, 0.05, 1e-3};

WindowBody ball(const Vec3& place, double mass)
{
    return {place, Vec3::Zero(), Vec3(0, 0, -9.81), 1 / mass, 1};
}

double force_between(const WindowProblem& problem, const LandingOutcome& outcome, int a, const Partner& b)
{
    for (std::size_t k = 0; k < problem.contacts.size(); ++k)
        if (problem.contacts[k].a == a && problem.contacts[k].b == b) return outcome.forces[k];
    return -1;
}

std::vector<Vec3> places_after(const WindowProblem& problem, const LandingOutcome& outcome)
{
    std::vector<Vec3> out;
    for (const WindowBody& body : problem.bodies) out.push_back(body.place);
    for (const std::vector<Vec3>& move : outcome.moves)
        for (std::size_t i = 0; i < out.size(); ++i) out[i] += move[i];
    return out;
}

/// Four balls: three in grooves of two planes each on a floor, around an axis, one on top of them. As many contacts as
/// directions.
WindowProblem pyramid(double distance, double loose)
{
    WindowProblem out;
    out.planes = {{Vec3::UnitZ(), 0, {}}};
    for (int k = 0; k < 3; ++k) {
        const double angle = 2 * std::numbers::pi * k / 3;
        const Vec3 outwards(std::cos(angle), std::sin(angle), 0), across(-std::sin(angle), std::cos(angle), 0);
        out.bodies.push_back(ball((distance - loose) * outwards + (1 + loose) * Vec3::UnitZ() + loose / 4 * across, 2));
        for (const double side : {-1.0, 1.0}) {
            const Vec3 normal = (-outwards + side * across) / std::sqrt(2.0);
            out.planes.push_back({normal, normal.dot(distance * outwards) - 1, {}});
        }
    }
    out.bodies.push_back(ball(Vec3(0, 0, 1 + std::sqrt(4 - distance * distance) + 4 * loose), 5));
    test::list_all_contacts(out, 0);
    return out;
}

}  // namespace

TEST_CASE("a tower lands with the forces of statics", "[window]")
{
    WindowProblem problem;
    problem.planes = {{Vec3::UnitZ(), 0, {}}};
    for (int k = 0; k < 5; ++k) problem.bodies.push_back(ball(Vec3(0, 0, 1 + 2.001 * k), k + 1));
    test::list_all_contacts(problem, 0);
    const LandingOutcome outcome = land(problem, calm);
    REQUIRE(outcome.status == LandingStatus::rests);
    double weight = 0;
    for (int k = 4; k >= 0; --k) {
        weight += 9.81 * (k + 1);
        const double force = k > 0 ? force_between(problem, outcome, k - 1, Partner::sphere(k))
                                   : force_between(problem, outcome, 0, Partner::plane(0));
        CHECK(force == Approx(weight).epsilon(1e-12));
    }
    const std::vector<Vec3> places = places_after(problem, outcome);
    for (int k = 0; k < 5; ++k) CHECK((places[static_cast<std::size_t>(k)] - Vec3(0, 0, 1 + 2 * k)).norm() < 1e-11);
    CHECK(outcome.residual < 4e-9 * 9.81);
    double lifted = 0;
    for (std::size_t k = 0; k < 5; ++k)
        lifted += 9.81 * static_cast<double>(k + 1) * (places[k] - problem.bodies[k].place).z();
    CHECK(outcome.lifted == Approx(lifted));
}

TEST_CASE("a pyramid lands with the forces of statics", "[window]")
{
    const double distance = 1.3, loose = GENERATE(0.0, 1e-6, 1e-3);
    const WindowProblem problem = pyramid(distance, loose);
    const LandingOutcome outcome = land(problem, calm);
    REQUIRE(outcome.status == LandingStatus::rests);
    const double steepness = std::sqrt(4 - distance * distance) / 2;  // cosine of the angle to the vertical
    const double push = 5 * 9.81 / (3 * steepness), sideways = push * distance / 2;
    for (int k = 0; k < 3; ++k) {
        CHECK(force_between(problem, outcome, k, Partner::sphere(3)) == Approx(push).epsilon(1e-9));
        CHECK(force_between(problem, outcome, k, Partner::plane(0)) == Approx(2 * 9.81 + 5 * 9.81 / 3).epsilon(1e-9));
        for (const int side : {1, 2})
            CHECK(force_between(problem, outcome, k, Partner::plane(2 * k + side)) ==
                  Approx(sideways / std::sqrt(2.0)).epsilon(1e-9));
    }
    const std::vector<Vec3> places = places_after(problem, outcome);
    CHECK((places[3] - Vec3(0, 0, 1 + 2 * steepness)).norm() < 1e-10);
    CHECK(outcome.largest_gap < 1e-12);
}

TEST_CASE("a pyramid with more contacts than directions lands on forces that push and balance", "[window]")
{
    const double loose = GENERATE(0.0, 1e-6, 1e-3);
    WindowProblem problem;
    problem.planes = {{Vec3::UnitZ(), 0, {}},
                      {Vec3::UnitX(), -2, {}},
                      {-Vec3::UnitX(), -2, {}},
                      {Vec3::UnitY(), -2, {}},
                      {-Vec3::UnitY(), -2, {}}};
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0}) problem.bodies.push_back(ball(Vec3(x, y, 1 + loose), 2));
    problem.bodies.push_back(ball(Vec3(0, 0, 1 + std::sqrt(2.0) + 2 * loose), 5));
    test::list_all_contacts(problem, 0);
    const LandingOutcome outcome = land(problem, calm);
    REQUIRE(outcome.status == LandingStatus::rests);
    WindowProblem after = problem;
    const std::vector<Vec3> places = places_after(problem, outcome);
    std::vector<Vec3> left;
    for (std::size_t i = 0; i < places.size(); ++i) {
        after.bodies[i].place = places[i];
        left.emplace_back(problem.bodies[i].acceleration / problem.bodies[i].inverse_mass);
    }
    for (std::size_t k = 0; k < after.contacts.size(); ++k) {
        const WindowContact& c = after.contacts[k];
        CHECK(outcome.forces[k] >= 0);
        const Vec3 push = outcome.forces[k] * geometry(after, c).normal;
        left[static_cast<std::size_t>(c.a)] += push;
        if (c.b.is_sphere()) left[static_cast<std::size_t>(c.b.index)] -= push;
        CHECK(geometry(after, c).gap > -1e-11);
        if (outcome.forces[k] > 0) CHECK(geometry(after, c).gap < 1e-11);
    }
    for (const Vec3& each : left) CHECK(each.norm() < 1e-7);
    CHECK((places[4] - Vec3(0, 0, 1 + std::sqrt(2.0))).norm() < 1e-10);
}

TEST_CASE("what is fast, and what nothing holds, is left out of a landing", "[window]")
{
    WindowProblem problem = pyramid(1.3, 1e-3);
    problem.bodies.push_back(ball(Vec3(20, 0, 1), 1));  // it glides on the floor
    problem.bodies.back().velocity = Vec3(0.5, 0, 0);
    problem.bodies.push_back(ball(Vec3(0, 0, 9), 1));  // it flies
    test::list_all_contacts(problem, 0);
    const LandingOutcome outcome = land(problem, calm);
    REQUIRE(outcome.status == LandingStatus::rests);
    CHECK(outcome.rests == std::vector<char>{1, 1, 1, 1, 0, 0});
    for (const std::vector<Vec3>& move : outcome.moves) {
        CHECK(move[4] == Vec3::Zero());
        CHECK(move[5] == Vec3::Zero());
    }
}

TEST_CASE("nothing rests on what is left out", "[window]")
{
    WindowProblem problem;
    problem.planes = {{Vec3::UnitZ(), 0, {}}};
    problem.bodies = {ball(Vec3(0, 0, 1), 1), ball(Vec3(0, 0, 3), 1), ball(Vec3(9, 0, 1), 1), ball(Vec3(14, 0, 1), 1)};
    problem.bodies[0].velocity = Vec3(1, 0, 0);
    test::list_all_contacts(problem, 0);
    const LandingOutcome outcome = land(problem, calm);
    REQUIRE(outcome.status == LandingStatus::rests);
    CHECK(outcome.rests == std::vector<char>{0, 0, 1, 1});
}

TEST_CASE("a ball on a slope does not land", "[window]")
{
    WindowProblem problem;
    const Vec3 slope = Vec3(0.6, 0, 0.8);
    problem.planes = {{slope, 0, {}}};
    problem.bodies = {ball(slope, 1)};
    test::list_all_contacts(problem, 0);
    const LandingOutcome outcome = land(problem, calm);
    CHECK(outcome.status != LandingStatus::rests);
    CHECK(outcome.moves.empty());
}
