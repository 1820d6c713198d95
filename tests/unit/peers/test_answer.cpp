#include "peers/answer.hpp"
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;
using Catch::Matchers::Contains;

namespace {

Scene two_spheres()
{
    Scene scene = empty_scene(1);
    add_sphere(scene, 0.1, {0, 0, 0});
    add_sphere(scene, 0.1, {1, 0, 0});
    scene.spheres[1].id = "a, b";
    scene.spheres[1].fixed = true;
    return scene;
}

const char* const good =
    "# Engine 2.0, tuned\n"
    "t,id,x,y,z,vx,vy,vz\n"
    "0.5,s0,1,2,3,-4,5e-3,6\n"
    "0.5,\"a, b\",1,0,0,0,0,0\n"
    "# steps 12 cpu_seconds 0.125\n";

}  // namespace

TEST_CASE("an answer is settings, states in the order of the scene, and what it cost")
{
    const PeerRun run = peers::run_of_answer(two_spheres(), {0.5}, good);
    CHECK(run.status == Status::reached_end);
    CHECK(run.settings == "Engine 2.0, tuned");
    CHECK(run.steps == 12);
    CHECK(run.cpu_seconds == 0.125);
    CHECK(run.has_velocities);
    REQUIRE(run.samples.size() == 1);
    CHECK(run.samples[0][0].position == Vec3(1, 2, 3));
    CHECK(run.samples[0][0].velocity == Vec3(-4, 0.005, 6));
    CHECK(run.samples[0][1].mode == Mode::fixed);
}

TEST_CASE("an answer may have no velocities")
{
    const PeerRun run = peers::run_of_answer(
        two_spheres(), {0.5}, "# Engine\nt,id,x,y,z\n0.5,s0,1,2,3\n0.5,\"a, b\",1,0,0\n# steps 1 cpu_seconds 1\n");
    CHECK(run.status == Status::reached_end);
    CHECK_FALSE(run.has_velocities);
    CHECK(run.samples[0][0].position == Vec3(1, 2, 3));
}

TEST_CASE("what is no answer is told with its reason")
{
    const std::string text = good;
    const auto told = [&](const std::string& answer, const std::vector<double>& times = {0.5}) {
        const PeerRun run = peers::run_of_answer(two_spheres(), times, answer);
        CHECK(run.status == Status::unresolved);
        return run.message;
    };
    CHECK(told("# error it has drag\n") == "it has drag");
    CHECK_THAT(told(""), Contains("begins with a line of settings"));
    CHECK_THAT(told("# Engine\nt,x\n"), Contains("the columns of an answer are"));
    CHECK_THAT(told(text, {0.5, 0.75}), Contains("the frame at t = 0.75 has no row of numbers for \"s0\""));
    CHECK_THAT(told("# Engine\nt,id,x,y,z,vx,vy,vz\n0.5,s0,1,2,nan?,-4,5,6\n"), Contains("no row of numbers"));
    CHECK_THAT(told(text.substr(0, text.find("# steps"))), Contains("is missing at its end"));
}
