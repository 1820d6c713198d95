#include "exactly.hpp"

using namespace carom;
using namespace carom::test;

namespace {

/// Two to five balls, some of them fixed, that fall into a box or a groove.
class Draw {
public:
    explicit Draw(std::uint64_t seed) : state_(seed * 2654435769U + 1) {}

    Scene scene()
    {
        Scene scene;
        scene.gravity = {0, 0, -9.81};
        const double restitutions[] = {0, 0, 0.3, 0.6, 1};
        const ImpactOperator operators[] = {ImpactOperator::reflections, ImpactOperator::sequential,
                                            ImpactOperator::lcp};
        scene.materials[0].restitution = restitutions[choose(5)];
        scene.impact.impact_operator = operators[choose(3)];
        scene.planes = {plane("front", {0, 1, 0}, -0.3), plane("back", {0, -1, 0}, -0.3)};
        if (choose(2) == 0) {
            scene.planes.push_back(plane("floor", {0, 0, 1}, 0));
            scene.planes.push_back(plane("left", {1, 0, 0}, -0.3));
            scene.planes.push_back(plane("right", {-1, 0, 0}, -0.3));
        } else {
            scene.planes.push_back(plane("slope-1", {0.6, 0, 0.8}, 0));
            scene.planes.push_back(plane("slope-2", {-0.8, 0, 0.6}, 0));
        }
        for (std::size_t n = 2 + choose(4), tries = 0; scene.spheres.size() < n && tries < 1000; ++tries) {
            const double radius = between(0.05, 0.12), mass = between(0.5, 3), x = between(-0.18, 0.18),
                         y = between(-0.13, 0.13), z = between(0.3, 0.9);
            Sphere s = ball("ball-" + std::to_string(scene.spheres.size()), {x, y, z}, {0, 0, 0}, mass, radius);
            s.fixed = choose(5) == 0;
            if (s.fixed) s.position.z() -= 0.15;
            bool clear = true;
            for (const Sphere& o : scene.spheres)
                clear = clear && (o.position - s.position).norm() > o.radius + s.radius + 1e-3;
            for (const Plane& p : scene.planes) clear = clear && plane_gap(p, s, s.position) > 1e-3;
            if (clear) scene.spheres.push_back(s);
        }
        return scene;
    }

private:
    std::uint64_t next()
    {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return state_ >> 11;
    }
    std::size_t choose(std::size_t n) { return (next() >> 20) % n; }
    double between(double low, double high) { return low + (high - low) * static_cast<double>(next()) * 0x1p-53; }

    std::uint64_t state_;
};

Real smallest_gap(const Scene& scene, const Exact& run, double t)
{
    Real least = 1;
    const auto count = static_cast<BodyId>(scene.spheres.size());
    for (BodyId i = 0; i < count; ++i) {
        const ExactVector x = run.flight(i).position(t);
        for (const Plane& p : scene.planes)
            if (!scene.spheres[i].fixed)
                least = std::min<Real>(least,
                                       dot(ExactVector(p.normal), x) - Real(p.offset) - Real(scene.spheres[i].radius));
        for (BodyId j = 0; j < i; ++j) {
            const ExactVector r = x - run.flight(j).position(t);
            if (scene.spheres[i].fixed && scene.spheres[j].fixed) continue;
            least =
                std::min<Real>(least, sqrt(dot(r, r)) - Real(scene.spheres[i].radius) - Real(scene.spheres[j].radius));
        }
    }
    return least;
}

Real energy(const Scene& scene, const Exact& run, double t)
{
    Real sum = 0;
    for (BodyId i = 0; i < static_cast<BodyId>(scene.spheres.size()); ++i) {
        const ExactVector v = run.flight(i).velocity(t), x = run.flight(i).position(t);
        if (!scene.spheres[i].fixed)
            sum += scene.spheres[i].mass * (dot(v, v) / 2 - dot(ExactVector(scene.gravity), x));
    }
    return sum;
}

}  // namespace

TEST_CASE("Balls that fall on each other never overlap, never gain energy, and keep it where e = 1", "[reference]")
{
    int ended = 0, turned = 0;
    Patience endless;
    for (std::uint64_t seed = 1; seed <= 80; ++seed) {
        const Scene scene = Draw(seed).scene();
        CAPTURE(seed, scene.materials[0].restitution, static_cast<int>(scene.impact.impact_operator));
        constexpr double end = 1.25;
        Exact run(scene, end, endless, 1500);
        const Real first = energy(scene, run, 0);
        Real last = first;
        bool turns = false;
        for (int k = 1; k <= 50; ++k) {
            const double t = end * k / 50;
            run.advance(t);
            if (run.stopped()) break;
            CHECK(smallest_gap(scene, run, t) > -1e-25);
            const Real now = energy(scene, run, t);
            CHECK(now < last + 1e-22);
            if (scene.materials[0].restitution == 1) CHECK(now > first - 1e-22);
            last = now;
            for (BodyId i = 0; i < static_cast<BodyId>(scene.spheres.size()); ++i)
                turns = turns || !run.flight(i).higher.empty();
        }
        if (run.stopped()) CHECK(run.reason().find("more work than") == 0);
        ended += !run.stopped();
        turned += turns;
    }
    CHECK(ended > 40);
    CHECK(turned > 5);
}
