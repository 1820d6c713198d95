/// FCL and libccd on the gap of two spheres: at an impact it is 0, before it is what the motion says.
#include "support/random.hpp"
#include "toi/sphere_sphere.hpp"

#include <ccd/ccd.h>
#include <fcl/fcl.h>
#include <catch2/catch.hpp>

using namespace carom;
using carom::test::Random;

namespace {

double fcl_distance(const Vec3& a, double ra, const Vec3& b, double rb, fcl::GJKSolverType solver)
{
    const fcl::Sphered sphere_a(ra), sphere_b(rb);
    fcl::Transform3d ta = fcl::Transform3d::Identity(), tb = ta;
    ta.translation() = a;
    tb.translation() = b;
    fcl::DistanceRequestd request;
    request.gjk_solver_type = solver;
    request.distance_tolerance = 1e-14;  // its default is 1e-6
    fcl::DistanceResultd result;
    return fcl::distance(&sphere_a, ta, &sphere_b, tb, request, result);
}

struct Ball {
    Vec3 centre;
    double radius;
};

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out)
{
    const auto& ball = *static_cast<const Ball*>(object);
    const Vec3 d(direction->v[0], direction->v[1], direction->v[2]);
    const Vec3 p = ball.centre + (ball.radius / d.norm()) * d;
    ccdVec3Set(out, p.x(), p.y(), p.z());
}

void centre(const void* object, ccd_vec3_t* out)
{
    const auto& ball = *static_cast<const Ball*>(object);
    ccdVec3Set(out, ball.centre.x(), ball.centre.y(), ball.centre.z());
}

ccd_t set_up()
{
    ccd_t ccd;
    CCD_INIT(&ccd);
    ccd.support1 = ccd.support2 = support;
    ccd.center1 = ccd.center2 = centre;
    ccd.max_iterations = 1000;
    ccd.mpr_tolerance = 1e-9;
    return ccd;
}

struct Pair {
    Vec3 r, v;
    double ra, rb;
    Root root;
};

/// A pair that collides at root.t.
Pair colliding(Random& random)
{
    for (;;) {
        const double ra = random.uniform(0.1, 1), rb = random.uniform(0.1, 1), s = ra + rb;
        const Vec3 n = random.direction(), side = random.across(n);
        const Vec3 r = s * random.uniform(0, 0.9) * side - random.uniform(1.5, 5) * s * n;
        const Vec3 v = random.uniform(0.5, 5) * n;
        const Root root = sphere_sphere_root(r, v, s);
        if (root.kind == RootKind::impact) return {r, v, ra, rb, root};
    }
}

}  // namespace

TEST_CASE("at the time of impact FCL sees the gap closed, before it as open as the centres are apart")
{
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const Pair p = colliding(random);
        const Vec3 b = random.in_cube(1);
        for (const double part : {0.0, 0.5, 0.9, 1.0}) {
            const Vec3 r = p.r + part * p.root.t * p.v;
            const double gap = r.norm() - (p.ra + p.rb);
            if (part < 1 || gap > 1e-12) {
                CHECK(std::abs(fcl_distance(b + r, p.ra, b, p.rb, fcl::GST_INDEP) - gap) <= 1e-12);
                CHECK(std::abs(fcl_distance(b + r, p.ra, b, p.rb, fcl::GST_LIBCCD) - gap) <= 1e-9);
            }
            if (part == 1) CHECK(std::abs(gap) <= 1e-13);
        }
    }
}

TEST_CASE("libccd sees two spheres apart right before the time of impact and overlapping right after")
{
    Random random(2);
    const ccd_t ccd = set_up();
    for (int i = 0; i < 200; ++i) {
        const Pair p = colliding(random);
        const auto intersect = [&](double t) {
            const Ball a{p.r + t * p.v, p.ra}, b{Vec3::Zero(), p.rb};
            return ccdMPRIntersect(&a, &b, &ccd) != 0;
        };
        CHECK_FALSE(intersect(p.root.t * (1 - 1e-4)));
        CHECK(intersect(p.root.t * (1 + 1e-4)));
    }
}

TEST_CASE("libccd's penetration depth a little after the impact is how far the centres came too close")
{
    Random random(3);
    const ccd_t ccd = set_up();
    for (int i = 0; i < 200; ++i) {
        const Pair p = colliding(random);
        const Ball a{p.r + (p.root.t + 0.02 * (p.ra + p.rb) / p.v.norm()) * p.v, p.ra}, b{Vec3::Zero(), p.rb};
        ccd_real_t depth = 0;
        ccd_vec3_t direction, position;
        REQUIRE(ccdMPRPenetration(&a, &b, &ccd, &depth, &direction, &position) == 0);
        const double exact = p.ra + p.rb - a.centre.norm();
        CHECK(exact > 0);
        CHECK(depth == Approx(exact).epsilon(0.05));
    }
}
