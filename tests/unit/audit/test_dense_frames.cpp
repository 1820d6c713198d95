#include "audit/frames_at_steps.hpp"
#include "drop.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

TEST_CASE("frames within the steps of a method that moves straight are no findings, and at its steps they are judged")
{
    // Velocity first, then the place: the path of the floor's ball by the semi-implicit Euler method.
    const double step = 1.0 / 60;
    const int denser = GENERATE(4, 10);
    const double digits = GENERATE(1e-12, 1e-5);  // as printed: at 1e-5 a line in a step looks like a parabola
    CAPTURE(denser, digits);
    Drop drop;
    drop.path.clear();
    Vec3 place{0, 0, 1.1}, velocity = Vec3::Zero();
    for (int k = 0; k < 26; ++k) {
        velocity += step * earth;
        drop.path.push_back({k * step, place, velocity});
        place += step * velocity;
    }
    Frames frames = frames_of({drop.path}, Vec3::Zero(), equal_times(60.0 * denser, 25 * step - 1e-9));
    for (audit::Frame& frame : frames.frames)
        for (int axis = 0; axis < 3; ++axis)
            frame.places[0][axis] = std::round(frame.places[0][axis] / digits) * digits;
    frames.rounding() = {};
    frames.rounding().places.see(digits == 1e-12 ? "0.123456789012" : "0.12345");
    frames.rounding().time = 1e-15;
    Frames again = frames;
    const audit::TraceAudit dense = audit::audit_trace(drop.scene, frames);
    CHECK(dense.found_wrong() == 0);
    if (digits == 1e-12) CHECK(dense.bodies.straight > dense.bodies.all / 2);
    audit::FramesAtSteps at_steps(again, step);
    const audit::TraceAudit judged = audit::audit_trace(drop.scene, at_steps);
    CHECK(judged.frames == 25);
    CHECK(judged.found_wrong() == 0);
    CHECK(judged.bodies.decided >= judged.bodies.all - 1);  // what gravity adds in the first step is the bound itself
}
