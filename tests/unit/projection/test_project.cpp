#include "half_space_oracle.hpp"

#include "projection/primal_dual_active_set.hpp"
#include "projection/project.hpp"

#include "support/random.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;
using carom::test::Random;

namespace {

/// Few vectors and many half-spaces, so that dependent and opposite ones are common.
ProjectionProblem random_problem(Random& random, int most, double ratio)
{
    ProjectionProblem out;
    const int vectors = random.integer(1, 4);
    const int dimensions = random.integer(1, 3);
    const auto flat = [&](Vec3 v) {
        for (int k = dimensions; k < 3; ++k) v[k] = 0;
        return v;
    };
    for (int k = 0; k < vectors; ++k) {
        out.start.push_back(flat(random.in_cube(1)));
        out.w.push_back(random.log_uniform(1, ratio));
    }
    const int count = random.integer(1, most);
    const double offset = random.coin() ? 0 : 1;
    while (static_cast<int>(out.half_spaces.size()) < count) {
        const int a = random.integer(0, vectors - 1);
        std::optional<int> b = random.integer(-1, vectors - 1);
        if (b < 0 || a == b) b.reset();
        Vec3 n = flat(random.direction());
        if (n.norm() < 0.1) continue;
        n.normalize();
        out.half_spaces.push_back({a, b, n, offset * random.uniform(0, 0.3)});
        if (random.integer(0, 3) == 0) out.half_spaces.push_back({a, b, -n, 0});
        if (random.integer(0, 3) == 0) out.half_spaces.push_back(out.half_spaces.back());
    }
    out.tolerance = 1e-13;
    return out;
}

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
    double out = 0;
    for (std::size_t k = 0; k < a.size(); ++k) out = std::max(out, (a[k] - b[k]).cwiseAbs().maxCoeff());
    return out;
}

}  // namespace

TEST_CASE("The projection is that of the best of all active sets, dependent half-spaces and opposite ones included")
{
    Random random(11);
    for (int trial = 0; trial < 1500; ++trial) {
        const double ratio = trial % 3 == 0 ? 1e6 : 4;
        const ProjectionProblem problem = random_problem(random, 6, ratio);
        const Projection projection = project(problem);
        CAPTURE(trial, problem.half_spaces.size());
        CHECK(projection.complete);
        CHECK(largest_difference(projection.point, project_by_trying(problem)) < (ratio > 4 ? 1e-9 : 1e-12));
    }
}

TEST_CASE("Points are starts plus pushes, multipliers push, and only half-spaces that are touched have one")
{
    Random random(12);
    for (int trial = 0; trial < 1000; ++trial) {
        const ProjectionProblem problem = random_problem(random, 40, 1e3);
        const Projection projection = project(problem);
        std::vector<Vec3> point = problem.start;
        double largest = 1;  // pushes of nearly opposite half-spaces are large, and their sum rounds with them
        for (std::size_t i = 0; i < problem.half_spaces.size(); ++i) {
            const HalfSpace& h = problem.half_spaces[i];
            push(h, problem.w, projection.multipliers[i], point);
            largest = std::max(largest, projection.multipliers[i] * normal_length2(h, problem.w));
        }
        CAPTURE(trial, largest);
        CHECK(largest_difference(point, projection.point) < 1e-13 * largest);
        for (std::size_t i = 0; i < problem.half_spaces.size(); ++i) {
            const double slack_after = slack(problem.half_spaces[i], projection.point);
            CHECK(projection.multipliers[i] >= 0);
            CHECK(slack_after > -1e-13 * largest);
            if (projection.multipliers[i] > 1e-9) CHECK(slack_after < 1e-12 * largest);
        }
    }
}

TEST_CASE("Half-spaces that are not chosen are ignored")
{
    ProjectionProblem problem{{Vec3(-1, -1, 0)}, {2}, {{0, {}, Vec3(1, 0, 0), 0}, {0, {}, Vec3(0, 1, 0), 0}}, 1e-13};
    const int second = 1;
    const Projection projection = project(problem, {&second, 1});
    CHECK(projection.point.front() == Vec3(-1, 0, 0));
    CHECK(projection.multipliers == std::vector<double>{0, 0.5});
}

TEST_CASE("What is inside stays where it is, to the bit")
{
    const ProjectionProblem problem{{Vec3(0.1, 0.3, 0.7)}, {3}, {{0, {}, Vec3(1, 0, 0), 0}}, 0};
    CHECK(project(problem).point.front() == problem.start.front());
}

TEST_CASE("A guess, right, nearly right or wrong, changes nothing but the work")
{
    Random random(13);
    int alone = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const ProjectionProblem problem = random_problem(random, 20, 1e3);
        const Projection plain = project(problem);
        std::vector<double> guess = plain.multipliers;
        for (double& multiplier : guess)
            if (trial % 3 > 0 && random.integer(0, trial % 3 == 1 ? 5 : 1) == 0) multiplier = multiplier > 0 ? 0 : 1;
        const Projection guessed = project(problem, guess);
        CAPTURE(trial, problem.half_spaces.size());
        CHECK(guessed.complete);
        double largest = 1;
        for (std::size_t i = 0; i < guess.size(); ++i)
            largest = std::max(largest, plain.multipliers[i] * normal_length2(problem.half_spaces[i], problem.w));
        CHECK(largest_difference(guessed.point, plain.point) < 1e-10 * largest);
        for (const double multiplier : guessed.multipliers) CHECK(multiplier >= 0);
        alone += primal_dual_active_set(problem, guess).complete;
    }
    CHECK(alone > 500);  // it is not always the other solver that answers
}

TEST_CASE("An equality is its half-space and the opposite one, with a guess and without")
{
    Random random(31);
    for (int trial = 0; trial < 1000; ++trial) {
        ProjectionProblem problem = random_problem(random, 8, trial % 3 == 0 ? 1e4 : 4);
        for (HalfSpace& h : problem.half_spaces) h.offset = 0;
        ProjectionProblem pairs = problem;
        std::vector<double> guess;
        for (HalfSpace& h : problem.half_spaces) {
            guess.push_back(random.coin() ? 1 : 0);
            h.is_equality = random.integer(0, 2) == 0;
            if (h.is_equality) pairs.half_spaces.push_back({h.a, h.b, -h.normal, 0});
        }
        const Projection expected = project(pairs);
        for (const Guess& begin : {Guess{}, Guess{guess}}) {
            const Projection found = project(problem, begin);
            CAPTURE(trial, begin.has_value());
            CHECK(largest_difference(found.point, expected.point) <= 1e-10);
            std::vector<Vec3> made = problem.start;
            for (std::size_t i = 0; i < problem.half_spaces.size(); ++i) {
                const HalfSpace& h = problem.half_spaces[i];
                if (!h.is_equality) CHECK(found.multipliers[i] >= 0);
                push(h, problem.w, found.multipliers[i], made);
            }
            CHECK(largest_difference(made, found.point) <= 1e-10);
        }
    }
}

TEST_CASE("Half-spaces that no point is inside of are named, and those beside them are not")
{
    constexpr double margin = 1e-12;
    ProjectionProblem problem{{Vec3::Zero(), Vec3::Zero()}, {1, 1}, {}, 1e-15};
    problem.half_spaces = {{0, {}, Vec3::UnitX(), -margin},
                           {0, 1, -Vec3::UnitX(), -margin},
                           {1, {}, Vec3::UnitX(), 0, true},  // closes the gap between the first two
                           {1, {}, Vec3::UnitY(), -margin}};
    std::vector<int> bound = project(problem).bound;
    std::sort(bound.begin(), bound.end());
    CHECK(bound == std::vector<int>{0, 1});
}
