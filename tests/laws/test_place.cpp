#include "laws/methods.hpp"
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

TEST_CASE("law: a scene shifted by whole cells is the same run, bit for bit")
{
    for (const Claims& claims : methods()) {
        if (!claims.exact) continue;
        for (const double e : {1.0, 0.8}) {
            Scene scene = gas(7, 40, 2, earth, e);
            // Few bits, so that the shifted coordinates are doubles, too.
            for (auto& s : scene.spheres)
                for (int k = 0; k < 3; ++k) s.position[k] = std::ldexp(std::floor(std::ldexp(s.position[k], 16)), -16);
            Scene other = scene;
            const Vec3 shift(0x1p30, -0x1p34, 96);
            for (auto& s : other.spheres) s.position += shift;
            for (auto& p : other.planes) p.offset += p.normal.dot(shift);
            const Recorded a = record(scene, claims.method), b = record(other, claims.method);
            INFO(claims.label << ", e " << e << " " << a.outcome.message << " / " << b.outcome.message);
            CHECK(a.events.size() > 20);
            CHECK(a.events.size() == b.events.size());
            CHECK(a.outcome.event_hash == b.outcome.event_hash);
            for (std::size_t i = 0; i < scene.spheres.size(); ++i)
                CHECK(a.outcome.final[i].velocity == b.outcome.final[i].velocity);
        }
    }
}
