/// Runs in which the impact operator meets its bound.
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using namespace carom;
using namespace carom::test;

namespace {

/// A ball pinched between two fixed ones is hit a little from the side: elastic, pair by pair, it goes to and fro
/// between them without end.
Scene pinched(OnCap on_cap)
{
    Scene scene = empty_scene(5);
    scene.impact.on_cap = on_cap;
    scene.impact.impact_operator = ImpactOperator::sequential;
    add_sphere(scene, 1, {-2, 0, 0});
    add_sphere(scene, 1, {0, 0, 0});
    add_sphere(scene, 1, {2, 0, 0});
    scene.spheres[0].fixed = scene.spheres[2].fixed = true;
    add_sphere(scene, 1, {-0.5, 4, 0}, {0, -1, 0});
    return scene;
}

}  // namespace

TEST_CASE("a run ends, if the scene says so, before impacts that the operator cannot carry out", "[on_cap]")
{
    const Outcome out = simulate(pinched(OnCap::stop), EventDriven{});
    CHECK(out.status == Status::unresolved);
    CHECK(out.message.find("on_cap") != std::string::npos);
    CHECK(out.counts.impacts == 0);
    CHECK(out.counts.capped == 0);
    CHECK(out.final[3].velocity == Vec3(0, -1, 0));
}

TEST_CASE("where the scene accepts them they are inelastic, counted, with their energy named", "[on_cap]")
{
    const Outcome out = simulate(pinched(OnCap::accept), EventDriven{});
    CHECK(out.status == Status::reached_end);
    CHECK(out.counts.capped == 1);
    CHECK(out.energy_taken.capped > 0);
    // What was there, 1/2, is what is left and what was named.
    double left = 0;
    for (const std::size_t i : {std::size_t{1}, std::size_t{3}}) left += out.final[i].velocity.squaredNorm() / 2;
    CHECK(left + out.energy_taken.capped == Approx(0.5).epsilon(1e-12));
}

TEST_CASE("a run whose declared contacts exceed the operator's bound ends at its start, with nothing carried out",
          "[on_cap]")
{
    Scene scene = pinched(OnCap::stop);
    // It touches the pinched ball now, from the same side.
    scene.spheres[3].position = {-0.5, std::sqrt(4 - 0.25), 0};
    const Outcome out = simulate(scene, EventDriven{});
    CHECK(out.status == Status::unresolved);
    CHECK(out.counts.impacts == 0);
    CHECK(out.final[3].velocity == Vec3(0, -1, 0));
}
