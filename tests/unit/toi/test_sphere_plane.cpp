#include "toi/sphere_plane.hpp"

#include "support/multiprecision.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace carom;
using carom::test::Float700;
using carom::test::Random;

namespace {

struct Truth {
    RootKind kind = RootKind::none;
    Float700 t = 0;
};

/// First t >= 0 at which h + w t + g t^2/2 is <= 0 and falls: every root of height and rate, tried one by one.
Truth exact_plane(double h_in, double w_in, double g_in)
{
    const Float700 h = h_in, w = w_in, g = g_in;
    const auto rate = [&](const Float700& t) -> Float700 { return w + g * t; };
    if (h <= 0 && w < 0) return {RootKind::impact, 0};
    if (h <= 0 && w == 0 && g < 0) return {RootKind::pressed, 0};
    if (g == 0) return h > 0 && w < 0 ? Truth{RootKind::impact, h / -w} : Truth{};
    // A turning point inside.
    const Float700 apex = -w / g;
    if (g < 0 && apex > 0 && h + w * apex / 2 <= 0) return {RootKind::impact, apex};
    const Float700 d = w * w - 2 * g * h;
    if (d <= 0) return {};
    Float700 first = -1;
    for (const Float700& t : {Float700((-w - sqrt(d)) / g), Float700((-w + sqrt(d)) / g)})
        if (t > 0 && rate(t) < 0 && (first < 0 || t < first)) first = t;
    return first > 0 ? Truth{RootKind::impact, first} : Truth{};
}

struct Tally {
    int hits = 0, wrong = 0;
    double worst = 0;  ///< [ulp]
};

template <class Generate>
Tally run(std::uint64_t seed, int count, Generate&& generate)
{
    Random random(seed);
    Tally tally;
    for (int i = 0; i < count; ++i) {
        const auto [h, w, g] = generate(random);
        const Truth truth = exact_plane(h, w, g);
        const Root root = plane_root(h, w, g);
        tally.wrong += root.kind != truth.kind;
        if (root.kind != truth.kind) {
            UNSCOPED_INFO("h " << h << " w " << w << " g " << g);
            continue;
        }
        if (truth.kind != RootKind::impact) continue;
        ++tally.hits;
        tally.worst = std::max(tally.worst, test::ulps(root.t, truth.t));
    }
    return tally;
}

void require_exact(const Tally& tally)
{
    INFO("hits " << tally.hits << ", worst " << tally.worst << " ulp");
    CHECK(tally.wrong == 0);
    CHECK(tally.worst <= 2.5);
    CHECK(tally.hits > 0);
}

struct Query {
    double h, w, g;
};

}  // namespace

TEST_CASE("a sphere falling, thrown or drifting onto a plane arrives to 2.5 ulp")
{
    require_exact(run(1, 5000, [](Random& x) -> Query { return {x.uniform(0, 5), x.uniform(-5, 5), -9.81}; }));
    require_exact(run(2, 2000, [](Random& x) -> Query { return {x.uniform(0, 5), x.uniform(-5, 5), 0}; }));
    require_exact(run(3, 5000, [](Random& x) -> Query {
        return {x.log_uniform(1e-12, 1e12), x.sign() * x.log_uniform(1e-12, 1e12), -x.log_uniform(1e-12, 1e12)};
    }));
}

TEST_CASE("gravity away from the plane: arrives only if fast enough, and a graze is told from a miss")
{
    require_exact(run(4, 3000, [](Random& x) -> Query { return {x.uniform(0, 5), -x.uniform(0, 10), 9.81}; }));
    for (const double delta : {1e-6, 1e-12, 1e-15}) {
        const Tally tally = run(5, 3000, [delta](Random& x) -> Query {
            const double h = x.uniform(0.1, 5), g = x.uniform(0.1, 20);
            return {h, -std::sqrt(2 * g * h) * (1 + x.uniform(-delta, delta)), g};
        });
        require_exact(tally);
        CHECK(tally.hits > 500);
        CHECK(tally.hits < 2500);
    }
    CHECK(plane_root(2, -4, 4).kind == RootKind::none);  // turns exactly at contact
}

TEST_CASE("a sphere that just bounced comes back, not now")
{
    int textbook_now = 0;
    const auto bounced = [&](Random& x) -> Query {
        const double w = x.uniform(0.1, 10), g = -x.uniform(0.1, 20),
                     h = x.integer(-1, 1) * x.log_uniform(1e-18, 1e-15);
        const double t = (-w + std::sqrt(w * w - 2 * g * h)) / g;  // the textbook's smaller root
        textbook_now += h <= 0 && std::abs(t) < 1e-12;
        return {h, w, g};
    };
    const Tally tally = run(6, 5000, bounced);
    require_exact(tally);
    CHECK(tally.hits == 5000);
    CHECK(textbook_now > 3000);
    CHECK(plane_root(0, 3, -2).t == 3);
}

TEST_CASE("gravity of 1e-300 is neither lost nor infinite")
{
    require_exact(run(7, 2000, [](Random& x) -> Query { return {x.uniform(0.1, 5), x.uniform(-5, 5), -1e-300}; }));
    require_exact(run(8, 2000, [](Random& x) -> Query { return {x.uniform(0.1, 5), -x.uniform(0, 5), 1e-300}; }));
}

TEST_CASE("lengths of 1e-160 and 1e150 and speeds of 1e-12 are as good as others")
{
    for (const double length : {1e-160, 1e150}) {
        INFO("length " << length);
        require_exact(run(9, 2000, [length](Random& x) -> Query {
            return {length * x.uniform(0, 5), length * x.uniform(-5, 5), -length * x.uniform(0, 5)};
        }));
        require_exact(run(10, 2000, [length](Random& x) -> Query {
            return {length * x.uniform(0, 5), -length * x.uniform(0, 10), length * x.uniform(0, 5)};
        }));
    }
    require_exact(run(11, 2000, [](Random& x) -> Query { return {x.uniform(0, 1), x.uniform(-1e-12, 1e-12), -9.81}; }));
}

TEST_CASE("touching or inside: closing is now, leaving is later or never, still and pressed is a contact")
{
    CHECK(plane_root(0, -1, 0).t == 0);
    CHECK(plane_root(0, -1, 0).kind == RootKind::impact);
    CHECK(plane_root(-0.1, -1e-30, 9).kind == RootKind::impact);
    CHECK(plane_root(0, 0, -1).kind == RootKind::pressed);
    CHECK(plane_root(-0.1, 0, -1).kind == RootKind::pressed);
    CHECK(plane_root(0, 0, 0).kind == RootKind::none);
    CHECK(plane_root(0, 0, 1).kind == RootKind::none);
    CHECK(plane_root(0, 1, 0).kind == RootKind::none);
    CHECK(plane_root(1, 0, 0).kind == RootKind::none);
    const Root apex = plane_root(-1, 1, -2);  // turns at t = 1/2, still inside
    CHECK(apex.kind == RootKind::impact);
    CHECK(apex.t == 0.5);
    require_exact(run(12, 3000, [](Random& x) -> Query {
        return {-x.log_uniform(1e-16, 1), x.sign() * x.log_uniform(1e-9, 10), x.sign() * x.uniform(0, 10)};
    }));
}

TEST_CASE("scaling by powers of two changes no bit of a plane's answer")
{
    Random random(13);
    for (int i = 0; i < 2000; ++i) {
        const double h = random.uniform(-0.1, 2), w = random.uniform(-3, 3), g = random.uniform(-3, 3);
        const Root root = plane_root(h, w, g);
        const int length = random.integer(-100, 100), time = random.integer(-100, 100);
        const Root scaled =
            plane_root(std::ldexp(h, length), std::ldexp(w, length - time), std::ldexp(g, length - 2 * time));
        CHECK(scaled.kind == root.kind);
        CHECK(scaled.t == std::ldexp(root.t, time));
    }
}
