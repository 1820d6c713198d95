#include "laws/methods.hpp"
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

TEST_CASE("law: elastic impacts keep the energy, kinetic and potential together")
{
    for (const Claims& claims : methods()) {
        for (const Vec3& gravity : {Vec3(0, 0, 0), earth}) {
            if (!claims.energy || (!claims.exact && !gravity.isZero(0))) continue;
            const Scene scene = gas(1, 60, 5, gravity);
            const Outcome outcome = simulate(scene, claims.method);
            INFO(claims.label << ", gravity " << gravity.norm());
            CHECK(outcome.counts.impacts > 100);
            CHECK(energy(scene, outcome.final) == Approx(energy(scene, initial_states(scene))).epsilon(1e-12));
        }
    }
}

TEST_CASE("law: inelastic impacts never gain energy, and lose some")
{
    for (const Claims& claims : methods()) {
        if (claims.is_soft) continue;
        INFO(claims.label);
        Scene scene = gas(2, 60, 2, Vec3::Zero(), 0.9);
        double last = kinetic_energy(scene, initial_states(scene));
        const double first = last;
        Observer observer;
        observer.sample_times = sample_grid(2, 100);
        observer.on_sample = [&](std::size_t, double, std::span<const BodyState> s) {
            const double now = kinetic_energy(scene, {s.begin(), s.end()});
            CHECK(now <= last * (1 + 1e-12));
            last = now;
        };
        simulate(scene, claims.method, {}, observer);
        CHECK(last < 0.95 * first);
    }
}
