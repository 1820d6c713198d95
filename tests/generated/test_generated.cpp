#include "generated/generate.hpp"
#include "generated/shrink.hpp"
#include "generated/tally.hpp"
#include "generated/write_scene.hpp"
#include "support/recorded.hpp"
#include "support/scenes.hpp"

#include <carom/io.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>
#include <set>

using namespace carom;
using namespace carom::test;

TEST_CASE("generated scenes are valid, of eight kinds, and the same each time")
{
    std::set<std::string> kinds, names;
    std::size_t most = 0;
    for (std::uint64_t index = 0; index < 80; ++index) {
        const GeneratedScene drawn = generate_scene(3, index);
        INFO(drawn.scene.name);
        CHECK(validate(drawn.scene).empty());
        CHECK(drawn.scene.end_time == 2);
        CHECK(std::any_of(drawn.scene.materials.begin(), drawn.scene.materials.end(),
                          [](const Material& m) { return m.restitution < 1; }));
        CHECK(scene_text(generate_scene(3, index).scene) == scene_text(drawn.scene));
        kinds.insert(drawn.kind);
        names.insert(scene_text(drawn.scene));
        most = std::max(most, drawn.scene.spheres.size());
    }
    CHECK(kinds.size() == 8);
    CHECK(names.size() == 80);
    CHECK(most > 20);
}

TEST_CASE("scenes whose recordings were refused once hold")
{
    // A series with the gravity of the slide that it ended; an impulse of a floor too small for an event; a sphere
    // pinched by gaps of 1e-9 r that was moved ten radii aside to close both.
    for (const std::uint64_t index : {899, 902, 1141}) {
        const GeneratedScene drawn = generate_scene(1, index);
        INFO(drawn.scene.name);
        const MemorySource source = recorded(drawn.scene);
        const Certificate c = examined(source);
        INFO(first_violation(c));
        CHECK(c.holds());
        CHECK(c.complete);
    }
}

TEST_CASE("recordings of generated scenes hold under drag, too")
{
    std::vector<std::uint64_t> indices(16);
    std::iota(indices.begin(), indices.end(), 0);
    indices.push_back(74);  // two spheres in a groove, whose accelerations differ by a rounding, met unseen
    for (const std::uint64_t index : indices) {
        GeneratedScene drawn = generate_scene(7, index);
        Random random(77 * index);
        drawn.scene.drag = random.log_uniform(1e-3, 10);
        RunOptions options;
        options.max_events = 20'000;
        const Certificate c = examined(recorded(drawn.scene, options));
        INFO(drawn.scene.name << ", drag " << drawn.scene.drag << ": " << first_violation(c));
        CHECK(c.holds());
        CHECK(c.body_seconds.not_certified == 0);
    }
}

TEST_CASE("a written scene is read as it was, normals to rounding, everything else bit for bit")
{
    for (std::uint64_t index = 0; index < 16; ++index) {
        const Scene scene = generate_scene(4, index).scene;
        const Scene again = parse_scene(scene_text(scene), "again.json");
        INFO(scene.name);
        REQUIRE(again.spheres.size() == scene.spheres.size());
        REQUIRE(again.planes.size() == scene.planes.size());
        CHECK(again.end_time == scene.end_time);
        CHECK(again.gravity == scene.gravity);
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
            const Sphere &was = scene.spheres[i], &is = again.spheres[i];
            CHECK(is.position == was.position);
            CHECK(is.velocity == was.velocity);
            CHECK(is.mass == was.mass);
            CHECK(is.radius == was.radius);
            CHECK(is.fixed == was.fixed);
            for (std::size_t p = 0; p < scene.planes.size(); ++p) {
                const ContactLaw law = plane_contact_law(scene, was.material, scene.planes[p].material),
                                 read = plane_contact_law(again, is.material, again.planes[p].material);
                CHECK(read.restitution == law.restitution);
                CHECK(read.tangential == law.tangential);
            }
            const ContactLaw law = sphere_contact_law(scene, was.material, scene.spheres[0].material),
                             read = sphere_contact_law(again, is.material, again.spheres[0].material);
            CHECK(read.restitution == law.restitution);
            CHECK(read.tangential == law.tangential);
        }
        for (std::size_t p = 0; p < scene.planes.size(); ++p) {
            CHECK((again.planes[p].normal - scene.planes[p].normal).norm() <= 0x1p-51);
            CHECK(again.planes[p].offset == scene.planes[p].offset);
        }
    }
}

TEST_CASE("a failing scene is shrunk to what it fails by")
{
    // Fails while these two spheres and that plane are there, for longer than 0.5.
    const Scene scene = generate_scene(1, 0).scene;
    REQUIRE(scene.spheres.size() > 10);
    const auto has = [](const auto& bodies, const std::string& id) {
        return std::any_of(bodies.begin(), bodies.end(), [&](const auto& b) { return b.id == id; });
    };
    int asked = 0;
    const auto fails = [&](const Scene& s) {
        ++asked;
        return has(s.spheres, "s3") && has(s.spheres, "s9") && has(s.planes, "plane-2") && s.end_time > 0.5;
    };
    const Scene small = shrink(scene, fails);
    CHECK(small.spheres.size() == 2);
    CHECK(small.planes.size() == 1);
    CHECK(small.end_time < 1);
    CHECK(fails(small));
    CHECK(asked <= 201);
}

TEST_CASE("a trial tells a run that is fine from others")
{
    Scene scene = empty_scene(2, earth, 0.5);
    add_floor(scene);
    add_sphere(scene, 0.1, {0, 0, 1.1});
    add_sphere(scene, 0.1, {0, 0, 1.3001});  // hits it on its way up, within a window
    const Trial fine = run_trial(scene, 10);
    CHECK(complaint(fine).empty());
    CHECK(fine.counts.impacts > 1);
    CHECK(fine.busiest_window > 0);
    CHECK(fine.penetration < 1e-9);

    Trial wrong = fine;
    wrong.lost = 1;
    CHECK(complaint(wrong) == "lost spheres");
    wrong = fine;
    wrong.busiest_window = 1.5;
    CHECK(complaint(wrong) == "more impacts than the bound");
    wrong = fine;
    wrong.penetration = 1e-6;
    CHECK(complaint(wrong) == "deeper than stated");
    wrong.stated = 1e-6;
    CHECK(complaint(wrong).empty());
    wrong.stated = 0.1;
    CHECK(complaint(wrong) == "sunk");
    wrong.counts.guarded = 1;
    CHECK(complaint(wrong).empty());
    CHECK(complaint(Trial{}) == "crashed or hung");

    Tally tally;
    for (std::uint64_t k = 0; k < 100; ++k) tally.add(k, "drop", fine);
    CHECK(tally.targets_met());
    tally.add(100, "drop", Trial{});
    CHECK_FALSE(tally.targets_met());
    CHECK_THAT(tally.table(10),
               Catch::Matchers::Contains("crashed or hung") && Catch::Matchers::Contains("targets MISSED"));
}

TEST_CASE("a process that takes more than its time is a result")
{
    Scene scene = empty_scene(1e6);  // elastic, in a slot of 1e-7: more impacts than can be made
    add_plane(scene, "left", Vec3::UnitX(), -0.5 - 1e-7);
    add_plane(scene, "right", -Vec3::UnitX(), -0.5 - 1e-7);
    add_sphere(scene, 0.5, Vec3::Zero(), {1, 0, 0});
    const Trial trial = run_trial(scene, 0.2);
    CHECK(trial.ended);
    CHECK(complaint(trial) == "time_limit");
}
