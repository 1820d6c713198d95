/// FCL's conservative advancement is an independent opinion on times of impact, to its 1e-4 of the interval.
#include "support/random.hpp"
#include "toi/sphere_sphere.hpp"

#include <fcl/fcl.h>
#include <catch2/catch.hpp>

using namespace carom;
using carom::test::Random;

namespace {

struct Answer {
    bool hit;
    double time;
};

/// Both spheres translate from their start over one unit of time.
Answer ask_fcl(const Vec3& a, const Vec3& va, double ra, const Vec3& b, const Vec3& vb, double rb)
{
    const auto at = [](const Vec3& p) {
        fcl::Transform3d t = fcl::Transform3d::Identity();
        t.translation() = p;
        return t;
    };
    const auto sphere_a = std::make_shared<fcl::Sphered>(ra), sphere_b = std::make_shared<fcl::Sphered>(rb);
    fcl::CollisionObjectd object_a(sphere_a, at(a)), object_b(sphere_b, at(b));
    fcl::ContinuousCollisionRequestd request;
    request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    request.ccd_motion_type = fcl::CCDM_TRANS;
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide(&object_a, at(a + va), &object_b, at(b + vb), request, result);
    return {result.is_collide, result.time_of_contact};
}

}  // namespace

TEST_CASE("times of impact agree with FCL's conservative advancement on 300 pairs, hits and misses")
{
    Random random(1);
    int hits = 0, misses = 0;
    for (int i = 0; i < 300; ++i) {
        const double ra = random.uniform(0.1, 1), rb = random.uniform(0.1, 1), s = ra + rb;
        // At closest approach `miss` * S apart, not near grazing; closest at some time within the interval or after it.
        const double miss = random.coin() ? random.uniform(0, 0.95) : random.uniform(1.05, 2);
        const Vec3 n = random.direction(), side = random.across(n);
        const double distance = random.uniform(2, 5) * s;
        const Vec3 r = s * miss * side - distance * n, v = distance * random.uniform(0.6, 1.6) * n;
        const Vec3 b = random.in_cube(2), vb = random.in_cube(2);
        const Root root = sphere_sphere_root(r, v, s);
        if (root.kind == RootKind::impact && std::abs(root.t - 1) < 1e-2) continue;
        const bool hit = root.kind == RootKind::impact && root.t < 1;
        const Answer fcl = ask_fcl(b + r, vb + v, ra, b, vb, rb);
        INFO("miss " << miss << ", t " << root.t << ", FCL " << fcl.hit << " " << fcl.time);
        CHECK(fcl.hit == hit);
        if (hit) CHECK(std::abs(fcl.time - root.t) <= 2e-4);
        hits += hit;
        misses += !hit;
    }
    CHECK(hits > 80);
    CHECK(misses > 80);
}
