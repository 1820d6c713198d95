// A few bodies that bounce on each other: the engine, whose thresholds are for heaps, beside the reference, which has
// none.
#include "reference/reference.hpp"
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <map>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double r = 0.1;

Scene on_floor(double end_time, double restitution, std::initializer_list<double> heights)
{
    Scene scene = empty_scene(end_time, earth, restitution);
    add_floor(scene);
    for (const double height : heights) add_sphere(scene, r, {0, 0, height});
    return scene;
}

Scene in_groove(double restitution)
{
    Scene scene = empty_scene(4, earth, restitution);
    add_plane(scene, "left", {1, 0, 1});
    add_plane(scene, "right", {-1, 0, 1});
    add_sphere(scene, r, {0.003, 0, std::sqrt(2.0) * r + 0.01});
    return scene;
}

/// Contacts begin to persist when the reference says, to `time`, and nobody is off by more than `place`.
void check_against_reference(const Scene& scene, double time, double place)
{
    std::map<std::pair<BodyId, BodyId>, double> rests;
    std::vector<std::vector<BodyState>> samples;
    Observer observer;
    observer.sample_times = sample_grid(scene.end_time, 100);
    observer.on_event = [&](const Event& e) {
        if (e.kind == EventKind::rest) rests[{e.a, e.b}] = e.time;
    };
    observer.on_sample = [&](std::size_t, double, std::span<const BodyState> s) {
        samples.emplace_back(s.begin(), s.end());
    };
    const Outcome outcome = simulate(scene, EventDriven{}, {}, observer);
    const Reference reference = make_reference(scene, scene.end_time, observer.sample_times);
    REQUIRE(reference.until == scene.end_time);
    REQUIRE(outcome.status == Status::reached_end);
    CHECK(outcome.counts.guarded == 0);
    for (const ReferenceContact& c : reference.contacts) {
        CAPTURE(c.a, c.b);
        if (c.begin == 0) continue;  // declared
        REQUIRE(rests.contains({c.a, c.b}));
        CHECK(std::abs(rests.at({c.a, c.b}) - c.begin) < time);
    }
    double worst = 0;
    for (std::size_t k = 0; k < samples.size(); ++k)
        for (std::size_t i = 0; i < scene.spheres.size(); ++i)
            worst = std::max(worst, (samples[k][i].position - reference.samples[k][i].position).norm());
    CHECK(worst < place);
}

}  // namespace

TEST_CASE("a ball on a ball at rest, two stacked ones, a column that collapses and a ball in a groove rest in time")
{
    check_against_reference(on_floor(2, 0.5, {r, 3 * r + 1e-3}), 1e-7, 1e-12);
    check_against_reference(on_floor(2, 0.5, {r + 1e-2, 3 * r + 3e-2}), 1e-7, 1e-12);
    check_against_reference(on_floor(1, 0.2, {0.15, 0.36, 0.57}), 1e-7, 1e-12);
    check_against_reference(in_groove(0.5), 1e-7, 1e-12);
}

TEST_CASE("three equal balls in a row that collapse stay where the reference leaves them")
{
    Scene scene = empty_scene(1, Vec3::Zero(), 0.05);
    add_sphere(scene, 0.0625, {-0.25, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.0625, {0, 0, 0});
    add_sphere(scene, 0.0625, {0.375, 0, 0}, {-1, 0, 0});
    std::vector<std::vector<BodyState>> samples;
    Observer observer;
    observer.sample_times = sample_grid(scene.end_time, 100);
    observer.on_sample = [&](std::size_t, double, std::span<const BodyState> s) {
        samples.emplace_back(s.begin(), s.end());
    };
    simulate(scene, EventDriven{}, {}, observer);
    const Reference reference = make_reference(scene, scene.end_time, observer.sample_times);
    for (std::size_t k = 0; k < samples.size(); ++k)
        for (std::size_t i = 0; i < 3; ++i)
            CHECK((samples[k][i].position - reference.samples[k][i].position).norm() < 1e-7);
}
