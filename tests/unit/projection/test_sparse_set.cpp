#include "pile_problem.hpp"

#include "projection/dual_active_set.hpp"
#include "projection/gauss_seidel.hpp"
#include "projection/primal_dual_active_set.hpp"
#include "projection/shortest_change.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

double largest_difference(const UnitVectors& a, const UnitVectors& b)
{
    double out = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c) out = std::max(out, std::abs(a[k][c] - b[k][c]));
    return out;
}

std::vector<double> swept(const ProjectionProblem& problem)
{
    return gauss_seidel(problem, 30, std::vector<double>(problem.half_spaces.size(), 0.0)).multipliers;
}

}  // namespace

TEST_CASE("In piles the active set found from a few sweeps is the dense solver's, whatever the masses")
{
    int found = 0;
    for (const int side : {2, 3, 4}) {
        for (const bool falling : {true, false}) {
            ProjectionProblem problem = pile_problem(side, side, falling);
            for (std::size_t k = 0; k < problem.w.size(); k += 3) problem.w[k] = 0.01;
            const Projection dense = dual_active_set(problem).projection;
            const Projection sparse = primal_dual_active_set(problem, swept(problem));
            CAPTURE(side, falling, sparse.steps);
            if (!sparse.complete) continue;  // then it says so
            ++found;
            CHECK(largest_difference(dense.point, sparse.point) < 1e-9);
            for (const double multiplier : sparse.multipliers) CHECK(multiplier >= 0);
        }
    }
    CHECK(found >= 4);
}

TEST_CASE("The sparse active set minds neither doubled half-spaces nor those that contradict")
{
    ProjectionProblem problem = pile_problem(3, 3, true);
    const Projection once = primal_dual_active_set(problem, swept(problem));
    REQUIRE(once.complete);
    const std::size_t count = problem.half_spaces.size();
    for (std::size_t i = 0; i < count; ++i) problem.half_spaces.push_back(problem.half_spaces[i]);
    std::vector<double> guess = once.multipliers;
    guess.insert(guess.end(), once.multipliers.begin(), once.multipliers.end());
    const Projection twice = primal_dual_active_set(problem, guess);
    CHECK(twice.complete);
    CHECK(largest_difference(once.point, twice.point) < 1e-9);

    // No point is on both sides of a gap, and none is claimed to be.
    const ProjectionProblem apart{
        {Vec3(0.5, 0, 0)}, {1}, {{0, {}, Vec3(1, 0, 0), -1}, {0, {}, Vec3(-1, 0, 0), 0}}, 1e-13};
    CHECK_FALSE(primal_dual_active_set(apart, std::vector<double>{1, 1}).complete);
}

TEST_CASE("A factor finds the shortest change that is found without one, and multipliers that make it")
{
    carom::Random random(4);
    ProjectionProblem problem = pile_problem(5, 5, false);
    const std::size_t vectors = problem.start.size();
    for (const bool contradict : {false, true}) {
        // Twice the same half-spaces, which want different things.
        if (contradict)
            problem.half_spaces.insert(problem.half_spaces.end(), problem.half_spaces.begin(),
                                       problem.half_spaces.end());
        const std::vector<UnitNormal> normals = unit_normals(problem);
        std::vector<char> active(normals.size(), 1);
        std::vector<double> wanted(normals.size(), 0);
        UnitVectors done(vectors);  // what all could want
        for (BlockCholesky::Vector& v : done)
            for (double& x : v) x = random.uniform(-1, 1);
        for (std::size_t i = 0; i < normals.size(); ++i) {
            active[i] = i % 5 != 0;
            wanted[i] = normals[i].dot(done) + (contradict ? random.uniform(-1, 1) : 0);
        }
        ActiveFactor factor(vectors, normals);
        factor.follow(active);
        const ShortestChange with = shortest_change(normals, active, wanted, vectors, {&factor, {}});
        const ShortestChange without = shortest_change(normals, active, wanted, vectors);
        CAPTURE(contradict);
        CHECK(largest_difference(with.change, without.change) < (contradict ? 1e-6 : 1e-10));
        UnitVectors made(vectors, BlockCholesky::Vector{});
        for (std::size_t i = 0; i < normals.size(); ++i) {
            normals[i].add_to(made, with.multipliers[i]);
            if (!active[i]) CHECK(with.multipliers[i] == 0);
            if (active[i] && !contradict) CHECK(std::abs(normals[i].dot(with.change) - wanted[i]) < 1e-12);
        }
        CHECK(largest_difference(made, with.change) < 1e-8);
        for (const ShortestChange* each : {&with, &without})
            for (const double multiplier : each->multipliers) CHECK(std::abs(multiplier) < 100);
    }
}

TEST_CASE("A change ends before a vector would go further than it may")
{
    const ProjectionProblem problem = pile_problem(3, 3, false);
    const std::vector<UnitNormal> normals = unit_normals(problem);
    const std::vector<char> all(normals.size(), 1);
    const std::vector<double> wanted(normals.size(), 1);
    const std::size_t vectors = problem.start.size();
    for (const double furthest : {1e-3, 0.5, 1e3}) {
        const std::vector<double> limits(vectors, furthest);
        const ShortestChange change = shortest_change(normals, all, wanted, vectors, {nullptr, limits});
        for (const BlockCholesky::Vector& v : change.change)
            CHECK(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] <= furthest * furthest);
    }
}
