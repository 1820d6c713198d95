#include "study/audit/auditor.hpp"
#include "study/share.hpp"

#include "make_sphere.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace carom;
using namespace carom::study;

namespace {

/// Quantile of the normal distribution that leaves 0.05 % on each side.
constexpr double two_sided_999 = 3.290526731491926;

Plane plane_at(const char* id, const Vec3& normal, double offset, std::optional<double> thickness = std::nullopt)
{
    Plane plane;
    plane.id = id;
    plane.normal = normal;
    plane.offset = offset;
    plane.thickness = thickness;
    return plane;
}

/// A ball of radius 0.1 and speed 1 that goes to and fro along x between two plates 0.1 thick, 4 apart, without
/// gravity: `impacts` impacts.
Scene between_plates(int impacts)
{
    Scene scene;
    scene.spheres.push_back(make_sphere("ball", 0.1));
    scene.spheres.back().velocity = Vec3(1, 0, 0);
    scene.planes = {plane_at("left", Vec3(1, 0, 0), -2, 0.1), plane_at("right", Vec3(1, 0, 0), 2, 0.1)};
    scene.end_time = (impacts - 0.5) * 3.7 + 1.85;  // free way 4 - 0.1 - 0.2, the first time half of it
    return scene;
}

/// A ball under g = 10 that meets a floor again and again with speed 2, nothing lost.
Scene bouncing()
{
    Scene scene;
    scene.gravity = Vec3(0, 0, -10);
    scene.end_time = 8;
    scene.spheres.push_back(make_sphere("ball", 0.1, Vec3(0, 0, 0.3)));
    scene.planes = {plane_at("floor", Vec3(0, 0, 1), 0)};
    return scene;
}

Audit audit_of(const Scene& scene, const std::string& method, double dt)
{
    StepOptions step;
    step.dt = dt;
    Auditor auditor(scene, scene.end_time, dt, {});
    Patience patience;
    return auditor.audit(make_method(method, step), patience);
}

bool is_within(double share, std::int64_t part, const Audit& audit)
{
    const Share seen = wilson_share(part, audit.audited, two_sided_999);
    CAPTURE(share, seen.value, seen.low, seen.high, audit.audited);
    CHECK(audit.audited > 500);
    return seen.low <= share && share <= seen.high;
}

}  // namespace

TEST_CASE("the share of plates that a velocity method misses is 1 - (r + thickness/2)/(v dt)", "[audit]")
{
    const Scene scene = between_plates(2000);
    for (const double ratio : {0.5, 1.5, 3.0, 10.0}) {
        CAPTURE(ratio);
        const Audit audit = audit_of(scene, "velocity", ratio * 0.15);
        CHECK(audit.audited == 2000);
        CHECK(audit.crowded == 0);
        CHECK(is_within(std::max(0.0, 1 - 1 / ratio), audit.missed, audit));
        CHECK(audit.found + audit.missed == audit.audited);  // what is answered is mirrored exactly
        if (ratio < 4) CHECK(audit.looked_at > 100);         // otherwise three steps are longer than a flight
        CHECK(audit.invented == 0);                          // without gravity every stepper flies exactly
    }
}

TEST_CASE("on a thick wall without gravity every impact is found, half a step late on average", "[audit]")
{
    Scene scene = between_plates(400);
    scene.planes = {plane_at("left", Vec3(1, 0, 0), -1.95), plane_at("right", Vec3(-1, 0, 0), -1.95)};
    for (const char* method : {"pbd", "velocity", "moreau", "bisection"}) {
        CAPTURE(method);
        const Audit audit = audit_of(scene, method, 0.5);
        CHECK(audit.found == audit.audited);
        REQUIRE(audit.delay);
        // The mean of n uniform delays is within 4 sigma = 4 / sqrt(12 n).
        const double expected = method == std::string("bisection") ? 0 : 0.5;
        CHECK(*audit.delay == Approx(expected).margin(4 / std::sqrt(12.0 * static_cast<double>(audit.audited))));
    }
}

TEST_CASE("under gravity the velocity after a bounce is right as often as Euler's error of it says", "[audit]")
{
    // Impact at the part f of the step, psi = 1 - f of it left: a response at the end of the step gives what fell in it
    // back, an error of 2 g dt psi; one at the start of the next, 2 g dt (1 + psi). Right: at most 1 % of 2 w.
    const Scene scene = bouncing();
    for (const double kappa : {0.005, 0.008, 0.02, 0.05}) {  // g dt / w
        CAPTURE(kappa);
        const double dt = kappa * 2 / 10;
        const Audit late_response = audit_of(scene, "velocity", dt), response = audit_of(scene, "pbd", dt);
        CHECK(is_within(std::min(1.0, 0.01 / kappa), response.found, response));
        CHECK(is_within(std::clamp(0.01 / kappa - 1, 0.0, 1.0), late_response.found, late_response));
        CHECK(response.found + response.wrong == response.audited);
    }
}

TEST_CASE("under a ceiling Euler's lag makes as many answers late as it says", "[audit]")
{
    // Euler lags g dt^2 / 2 behind after a step, so that with psi of the step left the ball has not yet reached the
    // ceiling if psi w dt - g (psi dt)^2 / 2 < g dt^2 / 2: psi < (1 - sqrt(1 - k^2)) / k with k = g dt / w.
    Scene scene;
    scene.gravity = Vec3(0, 0, -10);
    scene.spheres.push_back(make_sphere("ball", 0.1));
    scene.spheres.back().velocity = Vec3(0, 0, 6);  // meets the ceiling with speed 2 after 0.4
    scene.planes = {plane_at("ceiling", Vec3(0, 0, -1), -1.7)};
    scene.end_time = 0.5;
    for (const double kappa : {0.1, 0.3}) {
        const double share = (1 - std::sqrt(1 - kappa * kappa)) / kappa;
        for (const char* method : {"pbd", "velocity"}) {
            CAPTURE(kappa, method);
            const Audit audit = audit_of(scene, method, kappa * 2 / 10);
            CHECK(is_within(share, audit.late, audit));
            CHECK(audit.missed == 0);
        }
    }
}

TEST_CASE("a fall that Euler exaggerates onto a sphere that it clears is invented", "[audit]")
{
    // Over the top of a fixed sphere, R = r1 + r2 = 1, at u^2 = 1.5 g R: the parabola keeps clear, for it falls 0.5 g
    // t^2 where the sphere falls away by u^2 t^2 / 2R = 0.75 g t^2. A quarter of a step before the top the gap is 0.25
    // g (dt/4)^2, and still closing; Euler is 0.5 g dt^2 lower.
    constexpr double dt = 0.02, g = 10, until_top = 1.25 * dt;
    const double u = std::sqrt(1.5 * g);
    Scene scene;
    scene.gravity = Vec3(0, 0, -g);
    scene.end_time = 1;
    scene.spheres = {make_sphere("ball", 0.5, Vec3(-u * until_top, 0, 1.0001 - g * until_top * until_top / 2)),
                     make_sphere("bump", 0.5)};
    scene.spheres[0].velocity = Vec3(u, 0, g * until_top);
    scene.spheres[1].fixed = true;
    const Truth truth = record_truth(scene, 1, {});
    CHECK(truth.contacts.empty());
    CaseRunner runner(scene, truth);
    StepOptions step;
    step.dt = dt;
    CHECK(runner.invents({0, 0, {0, 1}}, make_method("pbd", step)));
    CHECK_FALSE(runner.invents({0, 0.5, {0, 1}}, make_method("pbd", step)));  // far away by then
}

TEST_CASE("the truth has the states that the run shows, in the midst of a series too", "[audit]")
{
    Scene scene;
    scene.gravity = Vec3(0, 0, -9.81);
    scene.end_time = 4;
    scene.materials = {{"rubber", 0.7, 0.9, ""}};
    scene.spheres = {make_sphere("left", 0.1, Vec3(0, 0, 0.5)), make_sphere("right", 0.1, Vec3(5, 0, 0.6))};
    scene.spheres[0].velocity = Vec3(0.3, 0, 0);
    scene.planes = {plane_at("floor", Vec3(0, 0, 1), 0)};
    const Truth truth = record_truth(scene, 4, {});
    std::size_t shown = 0;
    Observer observer;
    observer.sample_times = sample_grid(4, 4001);
    observer.on_sample = [&](std::size_t, double time, std::span<const BodyState> states) {
        for (BodyId body = 0; body < 2; ++body) {
            const TruthState state = truth.state(body, time);
            const BodyState& seen = states[static_cast<std::size_t>(body)];
            // The tail of a series is told as a slide, which nothing slows: 0.05 for 0.003.
            const double allowed = seen.mode == Mode::series ? 2e-4 : 1e-12;
            if ((state.position - seen.position).norm() > allowed) FAIL_CHECK("off at " << time);
            shown += seen.mode == Mode::series && (state.velocity - seen.velocity).norm() < 1e-9;
        }
    };
    simulate(scene, EventDriven{}, {}, observer);
    CHECK(shown > 10);
    // From 0.4: impact at t1 = sqrt(2 h / g), then every flight 0.7 times the one before, the first 2 * 0.7 t1.
    const double t1 = std::sqrt(2 * 0.4 / 9.81);
    double time = t1, flight = 1.4 * t1;
    std::size_t k = 0;
    for (const TruthContact& contact : truth.contacts) {
        if (contact.a != 0 || contact.b != 2) continue;
        CHECK(contact.time == Approx(time).epsilon(1e-9));
        time += flight;
        flight *= 0.7;
        ++k;
    }
    CHECK(k > 12);  // v_c is 0.0044, the first impact 2.8: 18 bounces
}

TEST_CASE("where the event method refuses a scene nobody is asked about anything", "[audit]")
{
    Scene scene = bouncing();
    scene.gravity = Vec3(0, 0, -1e200);  // beyond the range that it takes
    StepOptions step;
    step.dt = 0.01;
    Auditor auditor(scene, scene.end_time, step.dt, {});
    Patience patience;
    const Audit audit = auditor.audit(make_method("pbd", step), patience);
    CHECK(audit.audited == 0);
    CHECK(audit.looked_at == 0);
}

TEST_CASE("who has two contacts within two steps is crowded, and a case has only those who may come near", "[audit]")
{
    Scene scene;
    scene.end_time = 10;
    for (int i = 0; i < 100; ++i) scene.spheres.push_back(make_sphere("far", 0.1, Vec3(0, 100 + 10.0 * i, 0)));
    scene.spheres.push_back(make_sphere("a", 0.1, Vec3(0, 0, 0)));
    scene.spheres.push_back(make_sphere("b", 0.1, Vec3(2.2, 0, 0)));
    scene.spheres.push_back(make_sphere("c", 0.1, Vec3(3.4, 0, 0)));
    scene.spheres[100].velocity = Vec3(1, 0, 0);  // meets b after 2, b meets c after 3
    const Truth truth = record_truth(scene, 20, {});
    REQUIRE(truth.contacts.size() == 2);
    const AuditCases coarse = make_cases(scene, truth, {0, 1}, 1.1, 10, 1),
                     fine = make_cases(scene, truth, {0}, 0.1, 10, 1);
    CHECK(coarse.crowded > 400);
    CHECK(fine.crowded == 0);
    REQUIRE_FALSE(fine.contacts.empty());
    for (const ContactCase& each : fine.contacts) CHECK(each.bodies.size() <= 3);
}
