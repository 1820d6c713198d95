#include "pile_problem.hpp"

#include "projection/dual_active_set.hpp"
#include "projection/gauss_seidel.hpp"
#include "projection/project.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

TEST_CASE("In piles sparse sets find the point that the dense one finds")
{
    for (const int side : {3, 4, 5}) {
        for (const bool falling : {true, false}) {
            ProjectionProblem problem = pile_problem(side, side, falling);
            for (std::size_t k = 0; k < problem.w.size(); k += 3) problem.w[k] = 0.01;
            const Projection dense = dual_active_set(problem).projection, sparse = project(problem);
            CAPTURE(side, falling, sparse.steps);
            CHECK(problem.half_spaces.size() > dense_limit);
            CHECK(dense.complete);
            CHECK(sparse.complete);
            CHECK(largest_difference(dense.point, sparse.point) < 1e-9);
        }
    }
}

TEST_CASE("Dependent and doubled half-spaces change nothing for sparse sets")
{
    ProjectionProblem problem = pile_problem(3, 3, true);
    const Projection once = project(problem);
    const std::size_t count = problem.half_spaces.size();
    for (std::size_t i = 0; i < count; ++i) problem.half_spaces.push_back(problem.half_spaces[i]);
    const Projection twice = project(problem);
    CHECK(twice.complete);
    CHECK(largest_difference(once.point, twice.point) < 1e-9);
}

TEST_CASE("A thousand spheres are solved, whatever their masses, and again at once from their multipliers")
{
    for (const bool falling : {true, false})
        for (const bool uneven : {false, true}) {
            ProjectionProblem problem = pile_problem(10, 10, falling);
            for (std::size_t k = 0; uneven && k < problem.w.size(); k += 3) problem.w[k] = 0.01;
            const Projection first = project(problem);
            CAPTURE(falling, uneven);
            CHECK(problem.half_spaces.size() > 2500);
            CHECK(first.complete);
            std::vector<Vec3> point = problem.start;
            for (std::size_t i = 0; i < problem.half_spaces.size(); ++i) {
                push(problem.half_spaces[i], problem.w, first.multipliers[i], point);
                const double left = slack(problem.half_spaces[i], first.point);
                REQUIRE(left > -1e-10);
                if (first.multipliers[i] > 0) REQUIRE(left < 1e-10);
            }
            CHECK(largest_difference(point, first.point) < 1e-10);
            const Projection again = project(problem, first.multipliers);
            CHECK(again.steps <= 4);  // what rounding decides
            CHECK(largest_difference(again.point, first.point) < 1e-10);
        }
}

TEST_CASE("Sweeps approach the projection and never leave it")
{
    const ProjectionProblem problem = pile_problem(3, 3, true);
    const Projection exact = dual_active_set(problem).projection;
    double before = 1e300;
    for (const int sweeps : {1, 10, 100, 1000}) {
        const Projection swept = gauss_seidel(problem, sweeps, std::vector<double>(problem.half_spaces.size(), 0.0));
        const double away = largest_difference(swept.point, exact.point);
        CHECK(away < before);
        before = away;
    }
    CHECK(before < 1e-6);
}
