/// \file
/// Recordings made by hand, of motions that are known exactly.
#pragma once

#include "support/recorded.hpp"

#include <catch2/catch.hpp>

namespace carom::test {

class Handmade {
public:
    /// One cell is a unit of length, one epoch a unit of time.
    explicit Handmade(const Scene& scene) : scene_(scene)
    {
        source.description = described(scene);
        source.description.frame = {1, 1, scene.drag, {Vec3::Zero(), scene.gravity}};
        source.description.end = RecordedEnd{scene.end_time, 0, 0, 0};
    }

    /// Begins with the body where the scene has it.
    FlightRecord& start(Mode mode, std::int32_t support = -1, const Vec3& own = Vec3::Zero())
    {
        const Sphere& s = scene_.spheres[source.flights.size()];
        return add(static_cast<BodyId>(source.flights.size()), 0, s.position, s.velocity, mode, support, own);
    }
    FlightRecord& add(BodyId body, double t, const Vec3& x, const Vec3& v, Mode mode, std::int32_t support = -1,
                      const Vec3& own = Vec3::Zero())
    {
        FlightRecord f;
        f.body = body;
        f.start = {static_cast<std::int64_t>(t), t - std::floor(t)};
        for (std::size_t k = 0; k < 3; ++k) {
            f.local[k] = x[static_cast<int>(k)];
            f.velocity[k] = v[static_cast<int>(k)];
            f.own[k] = own[static_cast<int>(k)];
        }
        f.acceleration = !own.isZero(0) ? own_acceleration : mode == Mode::flying ? 1 : 0;
        f.mode = mode;
        f.support = support;
        source.flights.push_back(f);
        source.after.push_back(source.events.size());
        return source.flights.back();
    }
    void event(EventKind kind, double t, BodyId a, BodyId b, const Vec3& normal, const Vec3& impulse = Vec3::Zero())
    {
        source.events.push_back({kind, {static_cast<std::int64_t>(t), t - std::floor(t)}, t, a, b, normal, impulse});
    }

    Certificate examined(bool all_pairs = false)
    {
        source.seal();
        VerifyOptions options;
        options.all_pairs = all_pairs;
        MemorySource copy = source;
        return verify(copy, options);
    }

    MemorySource source;

private:
    Scene scene_;
};

#define CHECK_HOLDS(certificate)                       \
    do {                                               \
        const Certificate checked = certificate;       \
        INFO(::carom::test::first_violation(checked)); \
        CHECK(checked.holds());                        \
    } while (false)
#define CHECK_REFUSED(certificate, why)                                                      \
    do {                                                                                     \
        const Certificate checked = certificate;                                             \
        CHECK_FALSE(checked.holds());                                                        \
        CHECK_THAT(::carom::test::first_violation(checked), Catch::Matchers::Contains(why)); \
    } while (false)

}  // namespace carom::test
