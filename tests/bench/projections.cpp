// Measured rows of projection/tolerances.hpp: what the solvers of projections take on the contacts of piles.
#include "../unit/projection/pile_problem.hpp"

#include "projection/active_factor.hpp"
#include "projection/dual_active_set.hpp"
#include "projection/gauss_seidel.hpp"
#include "projection/primal_dual_active_set.hpp"

#include <chrono>
#include <cstdio>

using namespace carom;

namespace {

double seconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Milliseconds that a call takes.
template <class Call>
double milliseconds(Call&& call)
{
    const double start = seconds();
    call();
    return 1e3 * (seconds() - start);
}

std::vector<double> swept(const ProjectionProblem& problem, int sweeps)
{
    return gauss_seidel(problem, sweeps, std::vector<double>(problem.half_spaces.size(), 0.0)).multipliers;
}

/// Masses as they are, or a hundred times as much for every third body.
std::vector<ProjectionProblem> problems(int side)
{
    std::vector<ProjectionProblem> out;
    for (const bool falling : {true, false})
        for (const bool uneven : {false, true}) {
            out.push_back(test::pile_problem(side, side, falling));
            for (std::size_t k = 0; uneven && k < out.back().w.size(); k += 3) out.back().w[k] = 0.01;
        }
    return out;
}

void dense_and_sparse()
{
    for (const int side : {2, 3, 4, 5, 6})
        for (const ProjectionProblem& problem : problems(side)) {
            int steps = 0;
            const double dense = milliseconds([&] { steps = dual_active_set(problem).projection.steps; });
            std::printf("%4zu half-spaces: dual active set %4d steps %8.3f ms", problem.half_spaces.size(), steps,
                        dense);
            for (const int sweeps : {3, 10, 30, 100}) {
                Projection sparse;
                const double time =
                    milliseconds([&] { sparse = primal_dual_active_set(problem, swept(problem, sweeps)); });
                std::printf(" | %3d sweeps, %d rounds%s %7.3f ms", sweeps, sparse.steps,
                            sparse.complete ? "" : " (incomplete)", time);
            }
            std::printf("\n");
        }
    const ProjectionProblem large = test::pile_problem(10, 10, true);
    std::printf("%4zu half-spaces: 1000 sweeps %.0f ms\n", large.half_spaces.size(),
                milliseconds([&] { swept(large, 1000); }));
}

}  // namespace

int main()
{
    dense_and_sparse();
}
