#include "run_all.hpp"
#include "small_scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

const Vec3 earth(0, 0, -9.81);
constexpr double dt = 1.0 / 240;

StepOptions in_order(ContactOrder order, Integrator integrator = Integrator::euler)
{
    StepOptions options = steps(dt);
    options.order = order;
    options.integrator = integrator;
    return options;
}

/// A ball of mass 1e4 on one of mass 1 on the floor, listed from the top.
Scene heavy_on_light()
{
    Scene scene = scene_of({ball(0.1, Vec3(0, 0, 0.3), Vec3::Zero(), 1e4), ball(0.1, Vec3(0, 0, 0.1))},
                           {wall(Vec3::UnitZ(), 0)}, earth);
    scene.materials[0].restitution = 0;
    return scene;
}

Moreau moreau(const StepOptions& options, int sweeps)
{
    Moreau method{options};
    method.sweeps = sweeps;
    return method;
}

}  // namespace

TEST_CASE("order shock: a heavy ball lies on a light one, which other orders press into the floor", "[stepping]")
{
    for (const Integrator integrator : {Integrator::euler, Integrator::parabola}) {
        CAPTURE(static_cast<int>(integrator));
        const StepOptions index = in_order(ContactOrder::index, integrator),
                          shock = in_order(ContactOrder::shock, integrator);
        for (const auto& [with, without] : {std::pair<Method, Method>(VelocityBased{shock}, VelocityBased{index}),
                                            std::pair<Method, Method>(moreau(shock, 5), moreau(index, 5))}) {
            CAPTURE(name(with));
            const Outcome held = run_discrete(heavy_on_light(), with, until(2));
            CHECK(held.max_penetration < 1e-9);
            for (const BodyState& s : held.final) CHECK(s.velocity.norm() < 1e-9);
            CHECK(run_discrete(heavy_on_light(), without, until(2)).max_penetration > 0.01);
        }
    }
}

TEST_CASE("order shock: what the ground does not carry keeps its momentum", "[stepping]")
{
    Scene scene = gas(40, 0.1, 1.2, 5);
    scene.planes.clear();
    for (const Method& method :
         {Method(VelocityBased{in_order(ContactOrder::shock)}), Method(Moreau{in_order(ContactOrder::shock)})}) {
        Vec3 before = Vec3::Zero(), after = Vec3::Zero();
        const Outcome outcome = run_discrete(scene, method, until(0.5));
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
            before += scene.spheres[i].velocity;
            after += outcome.final[i].velocity;
        }
        CHECK(outcome.counts.impacts > 10);
        CHECK((after - before).norm() < 1e-12);
    }
}

TEST_CASE("order shock: methods that cannot propagate refuse it and say which can", "[stepping]")
{
    int taken = 0;
    for (const Method& method : all_discrete(in_order(ContactOrder::shock))) {
        CAPTURE(name(method));
        const Outcome outcome = run_discrete(heavy_on_light(), method, until(0.1));
        if (outcome.status == Status::reached_end) {
            ++taken;
            CHECK((name(method) == "velocity" || name(method) == "moreau"));
        } else {
            CHECK(outcome.message.find("velocity and moreau") != std::string::npos);
        }
    }
    CHECK(taken == 2);
    CHECK(contact_order("shock") == ContactOrder::shock);
}
