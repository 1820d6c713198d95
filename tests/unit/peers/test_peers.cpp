#include "peers/peers.hpp"
#include "script.hpp"
#include "support/scenes.hpp"

#include <carom/error.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

/// A ball on its way to a wall at x = 1, hit at t = 0.9.
Scene to_the_wall()
{
    Scene scene = empty_scene(2);
    add_sphere(scene, 0.1, {0, 0, 0}, {1, 0, 0});
    add_plane(scene, "wall", {-1, 0, 0}, -1);
    return scene;
}

tunnel::Throw thrown()
{
    tunnel::Throw t;
    t.scene = to_the_wall();
    t.partner = 1;
    t.speed_change = 2;
    return t;
}

}  // namespace

TEST_CASE("a peer is a row of a comparison: errors against the reference, the time that it says")
{
    const Script script(along_x);
    CompareOptions options;
    options.methods = {"event"};
    options.peers = {peers::make_peer("bullet", script.file())};
    options.dt = {0.01};
    options.until = 2;
    const Comparison result = compare_methods(to_the_wall(), options);
    REQUIRE(result.rows.size() == 2);
    const CompareRow& row = result.rows[1];
    CHECK(row.method == "bullet");
    CHECK(row.dt == 0.01);
    CHECK(row.peer_settings == "Walker 1.0, as it comes");
    CHECK(row.cpu_seconds == 0.25);
    CHECK(row.steps == 7);
    // It walks on through the wall: at t = 2 it is at 2, and the ball at -0.2.
    CHECK(row.position_max.value() == Approx(2.2));
    CHECK(row.divergence_time.value() == Approx(0.91).margin(0.011));
    CHECK(row.energy_error.value() == Approx(0).margin(1e-15));
    CHECK_FALSE(row.audit);
    bool told = false;
    for (const std::string& sentence : result.verdict) told = told || sentence.starts_with("bullet is Walker 1.0");
    CHECK(told);
}

TEST_CASE("a peer whose program ends is a row that says so")
{
    const Script script("exit 1\n");
    CompareOptions options;
    options.peers = {peers::make_peer("ode", script.file())};
    options.dt = {0.01};
    options.until = 2;
    const Comparison result = compare_methods(to_the_wall(), options);
    REQUIRE(result.rows.size() == 1);
    CHECK(result.rows[0].status == Status::unresolved);
    CHECK(result.rows[0].message == "its program ended without an answer");
    CHECK_FALSE(result.rows[0].position_max);
}

TEST_CASE("a comparison that is interrupted while it waits for a peer ends soon")
{
    const Script script("exec sleep 1000\n");
    CompareOptions options;
    options.peers = {peers::make_peer("ode", script.file())};
    options.dt = {0.01};
    options.until = 2;
    options.on_progress = [](const Progress& now) { return now.stage != "other engines"; };
    const Comparison result = compare_methods(to_the_wall(), options);
    CHECK(result.interrupted);
    CHECK(result.rows.empty());
}

TEST_CASE("a throw is answered where the velocity first changes by more than gravity does")
{
    const Script script(
        "while read -r run dt times && read -r scene; do\n"
        "  echo '# Bouncer'; echo t,id,x,y,z,vx,vy,vz; set -- $times\n"
        "  if [ $# -gt 0 ]; then echo \"$1,s0,0.9,0,0,1,0,0\"; echo \"$2,s0,0.8,0,0,-1,0,0\"; echo "
        "\"$3,s0,0.7,0,0,-1,0,0\"; fi\n"
        "  echo '# steps 3 cpu_seconds 0'; echo '# end'\n"
        "done\n");
    const tunnel::Contestant who = peers::peer_contestant("ode", script.file(), {});
    CHECK(who.settings == "Bouncer");
    const tunnel::Flown flown = who.fly(thrown(), 0.1, 3);
    CHECK(flown.answered.value() == 0.1);  // the second step moves with the velocity that its begin gave it
    CHECK(flown.position == Vec3(0.8, 0, 0));
    CHECK(flown.velocity == Vec3(-1, 0, 0));
    CHECK(flown.end_position == Vec3(0.7, 0, 0));
}

TEST_CASE("a throw that a peer flies through is not answered, and one that gets no answer is an error")
{
    const Script script(along_x);
    CHECK_FALSE(peers::peer_contestant("ode", script.file(), {}).fly(thrown(), 0.1, 3).answered);
    const Script broken("exit 1\n");
    CHECK_THROWS_AS(peers::peer_contestant("ode", broken.file(), {}).fly(thrown(), 0.1, 3), InputError);
    const Script slow("exec sleep 1000\n");
    CHECK_THROWS_AS(peers::peer_contestant("ode", slow.file(), [] { return false; }).fly(thrown(), 0.1, 3), Stopped);
}
