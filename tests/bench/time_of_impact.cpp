/// \file
/// What a time of impact costs beside the textbook formula. The answers are compared before the stopwatch starts.
#include "core/random.hpp"
#include "toi/sphere_sphere.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace {

using carom::Vec3;

struct Query {
    Vec3 r, v;
    double s;
};

double textbook(const Query& q)
{
    const double a = q.v.squaredNorm(), b = 2 * q.r.dot(q.v), c = q.r.squaredNorm() - q.s * q.s, d = b * b - 4 * a * c;
    if (!(d >= 0)) return std::numeric_limits<double>::infinity();
    const double t = (-b - std::sqrt(d)) / (2 * a);
    return t >= 0 ? t : std::numeric_limits<double>::infinity();
}

double ours(const Query& q)
{
    const carom::Root root = carom::sphere_sphere_root(q.r, q.v, q.s);
    return root.kind == carom::RootKind::impact ? root.t : std::numeric_limits<double>::infinity();
}

/// Approaching pairs some diameters apart; about a third of them meet. Here the textbook formula is still right.
std::vector<Query> generic_queries()
{
    std::vector<Query> queries;
    carom::Random random(1);
    for (int i = 0; i < 4096; ++i) {
        const double x = random.uniform(), y = random.uniform(), z = random.uniform();
        queries.push_back({{3 + 4 * x, y, z}, {-1 - y, 0.5 * (z - x), 0.5 * (x - y)}, 1});
    }
    for (const Query& q : queries) {
        const double a = textbook(q), b = ours(q);
        if (std::isinf(a) != std::isinf(b) || (!std::isinf(a) && std::abs(a - b) > 1e-9 * a)) std::abort();
    }
    return queries;
}

template <double (*Solve)(const Query&)>
void sphere_sphere(benchmark::State& state)
{
    const std::vector<Query> queries = generic_queries();
    for (auto _ : state)
        for (const Query& q : queries) benchmark::DoNotOptimize(Solve(q));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(queries.size()));
}
BENCHMARK(sphere_sphere<textbook>)->Name("sphere_sphere/textbook");
BENCHMARK(sphere_sphere<ours>)->Name("sphere_sphere/carom");

}  // namespace
