#include "audit/minimal_scene.hpp"
#include "drop.hpp"

#include <carom/checks.hpp>

#include <catch2/catch.hpp>

#include <string>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double drag = 3;  // 1/s

/// A ball that flies under gravity and drag at a floor, a plate from behind, a fixed sphere or another ball.
struct Damped {
    Scene scene = empty_scene(1, earth);
    std::vector<Path> paths;
    double touch = 0.2503;

    explicit Damped(const std::string& target)
    {
        scene.drag = drag;
        const Vec3 at{0, 0, 0.1}, velocity{0.7, 0, -2};  // at the touch
        Path path{{touch, at, velocity}};
        if (target == "floor") add_floor(scene);
        if (target == "plate") {
            add_plane(scene, "plate", -Vec3::UnitZ(), 0.01);
            scene.planes[0].thickness = 0.02;
        }
        if (target == "sphere") {
            add_sphere(scene, 0.2, {0, 0, -0.2});
            scene.spheres[0].fixed = true;
            paths.push_back({{0, {0, 0, -0.2}, Vec3::Zero()}});
        }
        if (target == "ball") {
            Path other{{touch, {0, 0, -0.2}, {-0.2, 0, 1}}};
            begin_at_zero(other);
            add_sphere(scene, 0.2, other[0].place, other[0].velocity);
            paths.push_back(other);
        }
        begin_at_zero(path);
        add_sphere(scene, 0.1, path[0].place, path[0].velocity);
        paths.push_back(path);
    }

    /// The ball's velocity along z is turned at `time`; of a ball that it meets theirs are exchanged.
    void bounce_at(double time)
    {
        Path& path = paths.back();
        Vec3 velocity = damped_at(path, earth, drag, time).velocity, other = Vec3::Zero();
        const bool has_other = paths.size() > 1 && !scene.spheres[0].fixed;
        if (has_other) other = damped_at(paths[0], earth, drag, time).velocity;
        if (has_other) {
            std::swap(velocity.z(), other.z());
            paths[0].push_back({time, damped_at(paths[0], earth, drag, time).place, other});
        } else {
            velocity.z() = -velocity.z();
        }
        path.push_back({time, damped_at(path, earth, drag, time).place, velocity});
    }
    audit::TraceAudit audited() const
    {
        Frames frames;
        for (const double t : equal_times(rate, 0.4)) {
            audit::Frame& frame = frames.frames.emplace_back();
            frame.time = t;
            for (std::size_t i = 0; i < paths.size(); ++i)
                frame.places.push_back(scene.spheres[i].fixed ? scene.spheres[i].position
                                                              : damped_at(paths[i], earth, drag, t).place);
        }
        return audit::audit_trace(scene, frames);
    }

private:
    static void begin_at_zero(Path& path) { path = {damped_at(path, earth, drag, 0)}; }
};

}  // namespace

TEST_CASE("under drag an exact bounce is found, a deleted one missed, and a shifted one late by that much")
{
    const std::string target = GENERATE("floor", "plate", "sphere", "ball");
    CAPTURE(target);
    Damped exact(target);
    exact.bounce_at(exact.touch);
    const audit::TraceAudit right = exact.audited();
    CHECK(right.found_wrong() == 0);
    CHECK(right.touches.found == 1);
    CHECK(right.bodies.without_flight <= 4);

    const Damped deleted(target);
    const audit::TraceAudit missed = deleted.audited();
    REQUIRE(missed.touches.missed == 1);
    CHECK(missed.findings.front().time == Approx(deleted.touch).margin(1e-11));

    const double delay = 0.6 / rate;
    Damped shifted(target);
    shifted.bounce_at(shifted.touch + delay);
    const audit::TraceAudit late = shifted.audited();
    REQUIRE(late.touches.late == 1);
    CHECK(late.touches.missed + late.touches.early + late.invented == 0);
    CHECK(late.findings.front().by == Approx(delay).margin(1e-11));
}

TEST_CASE("under drag a kick is invented at its time, and the event method's own scene of a miss shows the touch")
{
    Damped kicked("floor");
    const double when = 0.1311;
    Path& path = kicked.paths.back();
    path.push_back({when, damped_at(path, earth, drag, when).place, {3, 0, 0}});
    const audit::TraceAudit result = kicked.audited();
    CHECK(result.invented == 1);
    CHECK(result.findings.front().time == Approx(when).margin(1e-9));

    const Damped deleted("floor");
    const audit::TraceAudit missed = deleted.audited();
    const Scene small = audit::minimal_scene(deleted.scene, missed.findings.front());
    CHECK(small.drag == drag);
    const CheckReport checks = check_scene(small);
    REQUIRE(checks.results.size() == 1);
    CHECK(checks.results.front().verdict == CheckVerdict::holds);
}
