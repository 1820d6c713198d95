/// Tracks leave out only what certainly does not come: the exact kernel is the oracle.
#include "predict/wide_tracks.hpp"

#include "motion/kinematics.hpp"
#include "support/random.hpp"
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace carom;
using namespace carom::test;

namespace {

/// Spheres that have all been turned at random times since the start.
State stirred(const Scene& scene, Random& random, Tracks& tracks, State state, EpochTime& now)
{
    for (int i = 0; i < 2000; ++i) {
        now = state.frame.after(now, random.uniform(0, 2e-4));
        Change change;
        change.body = random.integer(0, static_cast<int>(scene.spheres.size()) - 1);
        change.flight = flown(state, change.body, now);
        change.flight.velocity = random.in_cube(random.coin() ? 2 : 1e-6);
        state.bodies.set(change);
        tracks.follow(state, change.body, now);
    }
    return state;
}

template <bool gravity>
void check_against_kernel(const Vec3& acceleration, const Vec3& centre)
{
    Random random(5);
    Scene scene = empty_scene(10, acceleration);
    for (int i = 0; i < 200; ++i)
        add_sphere(scene, random.uniform(0.05, 0.15), centre + random.in_cube(2), random.in_cube(1));
    const State start(scene, Precision::plain);
    Tracks tracks(start);
    EpochTime now{};
    const State state = stirred(scene, random, tracks, start, now);
    const double age = tracks.age(state.frame, now);
    std::vector<BodyId> all(scene.spheres.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<BodyId>(i);
    std::vector<Meeting> room;
    int contacts = 0, left_out = 0;
    for (const BodyId body : all) {
        std::vector<BodyId> others = all;
        std::erase(others, body);
        const auto found = tracks.meetings<gravity>(body, age, others, room);
        for (const BodyId other : others) {
            const auto at =
                std::find_if(found.begin(), found.end(), [&](const Meeting& m) { return m.other == other; });
            left_out += at == found.end();
            const ContactTime contact =
                PlainKinematics<gravity>::pair_time(state, std::min(body, other), std::max(body, other), never);
            const double soonest = soonest_contact<gravity>(tracks[body], tracks[other], age, tracks.least_square());
            CAPTURE(body, other, soonest);
            if (at != found.end() && soonest > 0 && soonest < 1e3) CHECK(at->soonest == Approx(soonest).epsilon(1e-6));
            if (!contact.comes || contact.time < now) continue;  // nothing made an impact of what was before
            ++contacts;
            REQUIRE(at != found.end());
            CHECK(at->soonest <= state.frame.between(now, contact.time) * (1 + 1e-12) + 1e-12);
            CHECK(soonest <= state.frame.between(now, contact.time) * (1 + 1e-12) + 1e-12);
        }
    }
    CHECK(contacts > 50);
    CHECK(left_out > 10'000);
}

}  // namespace

TEST_CASE("no contact that the kernel finds is left out by tracks or comes before the time that they tell")
{
    for (const Vec3& centre : {Vec3(0, 0, 0), Vec3(1e9, -1e9, 3e8)}) {
        check_against_kernel<false>(Vec3::Zero(), centre);
        check_against_kernel<true>({0.3, -0.2, -9.81}, centre);
    }
}
