#include "laws/methods.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

/// Smallest gap of spheres and planes at these states, in units of eps times what rounding may cost: the sizes of the
/// pair, or how far a sphere flies between two of its events (at most the whole box).
double worst(const Scene& scene, std::span<const BodyState> states, double travel)
{
    double least = 0;
    const double eps = 0x1p-52;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const double r = scene.spheres[i].radius;
        for (std::size_t j = 0; j < i; ++j) {
            const double s = r + scene.spheres[j].radius;
            const double gap = (states[i].position - states[j].position).norm() - s;
            least = std::min(least, gap / (eps * std::max(s, travel)));
        }
        for (const auto& plane : scene.planes)
            least =
                std::min(least, plane_gap(plane, scene.spheres[i], states[i].position) / (eps * std::max(r, travel)));
    }
    return least;
}

}  // namespace

TEST_CASE("law: nothing sinks into anything by more than rounding, at impacts and between them")
{
    for (const Claims& claims : methods()) {
        if (!claims.exact) continue;
        for (const Vec3& gravity : {Vec3(0, 0, 0), earth})
            for (const double e : {1.0, 0.9}) {
                const double side = 10;
                const Scene scene = gas(6, 100, 2, gravity, e, 0.1, 0.7, side);
                double least = 0;
                Observer observer;
                observer.sample_times = sample_grid(2, 400);
                observer.on_sample = [&](std::size_t, double, std::span<const BodyState> s) {
                    least = std::min(least, worst(scene, s, side));
                };
                // An event's time, sampled: the moment at which a gap is smallest.
                const Recorded first = record(scene, claims.method);
                for (const Event& event : first.events) observer.sample_times.push_back(event.time);
                std::sort(observer.sample_times.begin(), observer.sample_times.end());
                const Outcome outcome = simulate(scene, claims.method, {}, observer);
                INFO(claims.label << ", gravity " << gravity.norm() << ", e " << e);
                CHECK(outcome.counts.impacts > 50);
                CHECK(least >= -16);
                CHECK(outcome.max_penetration <= 16 * 0x1p-52 * side);
            }
    }
}

TEST_CASE("law: bisection leaves no overlap at the end of a step; methods that respond to overlaps do")
{
    for (const Claims& claims : methods()) {
        const double side = 10;
        const Scene scene = gas(6, 100, 2, Vec3::Zero(), 1, 0.1, 0.7, side);
        const Outcome outcome = simulate(scene, claims.method);
        INFO(claims.label);
        CHECK(outcome.counts.impacts > 50);
        if (claims.no_overlap)
            CHECK(outcome.max_penetration <= 16 * 0x1p-52 * side);
        else if (!claims.looks_ahead)
            CHECK(outcome.max_penetration > 1e-4);
    }
}

TEST_CASE("law: a very fast sphere between very thin plates passes none; steps do not see them")
{
    for (const Claims& claims : methods()) {
        Scene scene = empty_scene(1);
        for (int i = 0; i < 2; ++i) {
            add_plane(scene, "plate " + std::to_string(i), Vec3::UnitX(), i);
            scene.planes.back().thickness = 1e-9;
        }
        add_sphere(scene, 1e-3, {0.5, 0, 0}, {1e5, 3, 1});
        const Outcome outcome = simulate(scene, claims.method);
        const double x = outcome.final[0].position.x();
        INFO(claims.label);
        CHECK((outcome.counts.impacts > 90000) == claims.exact);
        CHECK((x > 0 && x < 1) == (claims.exact || claims.looks_ahead));
    }
}
