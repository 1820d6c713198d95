#include "pile_problem.hpp"

#include "projection/augmented_lagrangian.hpp"
#include "projection/dual_active_set.hpp"
#include "projection/gauss_seidel.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

/// From some sweeps, as project() does it.
AugmentedLagrangianResult solved(const ProjectionProblem& problem)
{
    const std::vector<double> none(problem.half_spaces.size(), 0.0);
    return augmented_lagrangian(problem, gauss_seidel(problem, 30, none).multipliers);
}

}  // namespace

TEST_CASE("In piles the sparse solver finds the point that the dense one finds")
{
    for (const int side : {2, 3, 4}) {
        for (const bool falling : {true, false}) {
            ProjectionProblem problem = pile_problem(side, side, falling);
            for (std::size_t k = 0; k < problem.w.size(); k += 3) problem.w[k] = 0.01;
            const Projection dense = dual_active_set(problem).projection;
            const AugmentedLagrangianResult sparse = solved(problem);
            CAPTURE(side, falling, sparse.newton_steps);
            CHECK(dense.complete);
            CHECK(sparse.projection.complete);
            CHECK(largest_difference(dense.point, sparse.projection.point) < 1e-9);
        }
    }
}

TEST_CASE("Dependent and doubled half-spaces change nothing for the sparse solver")
{
    ProjectionProblem problem = pile_problem(3, 3, true);
    const Projection once = solved(problem).projection;
    const std::size_t count = problem.half_spaces.size();
    for (std::size_t i = 0; i < count; ++i) problem.half_spaces.push_back(problem.half_spaces[i]);
    const Projection twice = solved(problem).projection;
    CHECK(twice.complete);
    CHECK(largest_difference(once.point, twice.point) < 1e-9);
}

TEST_CASE("A thousand spheres are solved, and again at once from their multipliers")
{
    const ProjectionProblem problem = pile_problem(10, 10, true);
    const AugmentedLagrangianResult first = solved(problem);
    CHECK(problem.half_spaces.size() > 2500);
    CHECK(first.projection.complete);
    std::vector<Vec3> point = problem.start;
    for (std::size_t i = 0; i < problem.half_spaces.size(); ++i) {
        push(problem.half_spaces[i], problem.w, first.projection.multipliers[i], point);
        const double left = slack(problem.half_spaces[i], first.projection.point);
        REQUIRE(left > -1e-10);
        if (first.projection.multipliers[i] > 0) REQUIRE(left < 1e-10);
    }
    CHECK(largest_difference(point, first.projection.point) < 1e-12);
    const AugmentedLagrangianResult again = augmented_lagrangian(problem, first.projection.multipliers);
    CHECK(again.factorisations <= 1);
    CHECK(largest_difference(again.projection.point, first.projection.point) < 1e-10);
    CHECK(first.updates > first.factorisations);
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
