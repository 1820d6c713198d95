/// Schedules: whatever the broad phase and the queue, the next contact is the same, for every kinematics.
#include "predict/schedule.hpp"

#include "support/random.hpp"
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

/// Small spheres in a box, which fly in every direction; one is fixed.
Scene crowd(Random& random, const Vec3& gravity)
{
    Scene scene = empty_scene(10, gravity);
    for (int axis = 0; axis < 3; ++axis) {
        add_plane(scene, "low-" + std::to_string(axis), Vec3::Unit(axis));
        add_plane(scene, "high-" + std::to_string(axis), -Vec3::Unit(axis), -4);
    }
    for (int i = 0; i < 64; ++i) {
        const Vec3 site(i % 4 + 0.5, i / 4 % 4 + 0.5, i / 16 + 0.5);
        add_sphere(scene, 0.1 + 0.1 * (i % 3), site + random.in_cube(0.15), random.in_cube(2));
    }
    scene.spheres[17].fixed = true;
    scene.spheres[17].velocity = Vec3::Zero();
    return scene;
}

/// The next event that is no business of the grid alone.
template <class Schedule>
Key next_contact(Schedule& schedule, const State& state, Counts& counts)
{
    for (;;) {
        const auto next = schedule.next();
        if (next.key.kind == Scheduled::cell_crossing)
            schedule.leave(state, next.key, counts);
        else if (schedule.is_stale(state, next))
            schedule.predict_again(state, next, counts);
        else if (!schedule.refine(state, next, counts))
            return next.key;
    }
}

/// The body flies on from `now` at another velocity.
Change turned(const State& state, BodyId body, const EpochTime& now, const Vec3& velocity)
{
    Change change;
    change.body = body;
    change.flight = flown(state, body, now);
    change.flight.velocity = velocity;
    return change;
}

template <class Kinematics>
void check_twins(const Vec3& gravity, Precision precision, double drag = 0)
{
    Random random(11);
    Scene scene = crowd(random, gravity);
    scene.drag = drag;
    State state(scene, precision);
    Counts counts;
    Schedule<Kinematics, CellGrid, EventQueue> grid(state, counts);
    Schedule<Kinematics, AllPairs, EventQueue> pairs(state, counts);
    Schedule<Kinematics, AllPairs, LinearQueue> linear(state, counts);
    Schedule<Kinematics, CellGrid, LinearQueue> linear_grid(state, counts);
    Schedule<Kinematics, NeighbourLists, EventQueue> lists(state, counts);
    int with_spheres = 0;
    for (int i = 0; i < 300; ++i) {
        const Key key = next_contact(grid, state, counts);
        CAPTURE(i, key.a, key.b.index);
        REQUIRE(next_contact(pairs, state, counts) == key);
        REQUIRE(next_contact(linear, state, counts) == key);
        REQUIRE(next_contact(linear_grid, state, counts) == key);
        REQUIRE(next_contact(lists, state, counts) == key);
        with_spheres += key.b.is_sphere();
        // Whoever meets somebody goes anywhere but on: what impacts do is another matter.
        std::vector<Change> changes;
        for (const BodyId body : {key.a, key.b.is_sphere() ? key.b.index : key.a})
            if (!state.is_fixed(body) && (changes.empty() || changes.front().body != body))
                changes.push_back(turned(state, body, key.time, -0.9 * flown(state, body, key.time).velocity));
        for (const Change& change : changes) state.bodies.set(change);
        grid.flights_changed(state, changes, key.time, counts);
        pairs.flights_changed(state, changes, key.time, counts);
        linear.flights_changed(state, changes, key.time, counts);
        linear_grid.flights_changed(state, changes, key.time, counts);
        lists.flights_changed(state, changes, key.time, counts);
    }
    CHECK(with_spheres > 20);
    CHECK(counts.cell_crossings > 0);
    CHECK(counts.list_rebuilds > 0);
}

}  // namespace

TEST_CASE(
    "without gravity the next contact does not depend on broad phase and "
    "queue")
{
    check_twins<PlainKinematics<false>>(Vec3::Zero(), Precision::plain);
}

TEST_CASE("under gravity the next contact does not depend on broad phase and queue")
{
    check_twins<PlainKinematics<true>>({0.3, -0.2, -9.81}, Precision::plain);
}

TEST_CASE("under drag the next contact does not depend on broad phase and queue")
{
    check_twins<DampedKinematics>({0.3, -0.2, -9.81}, Precision::plain, 0.7);
    check_twins<DampedKinematics>(Vec3::Zero(), Precision::plain, 0.02);
}

TEST_CASE(
    "in certified runs the next contact does not depend on broad phase "
    "and queue")
{
    check_twins<CertifiedKinematics>({0.3, -0.2, -9.81}, Precision::certified);
}

TEST_CASE(
    "kinematics in double and in double-double tell of the same "
    "contacts, the certified ones no later")
{
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        const Scene scene = crowd(random, {0, 0, -1});
        const State plain(scene, Precision::plain), certified(scene, Precision::certified);
        for (BodyId b = 1; b < plain.count(); ++b)
            for (BodyId a = 0; a < b; ++a) {
                const ContactTime rounded = PlainKinematics<true>::pair_time(plain, a, b, never);
                const ContactTime sure = CertifiedKinematics::pair_time(certified, a, b, never);
                CAPTURE(seed, a, b);
                REQUIRE(rounded.comes == sure.comes);
                if (!sure.comes || !sure.rough) continue;
                ++found;
                const EpochTime exact = CertifiedKinematics::exact_time(certified, a, Partner::sphere(b));
                CHECK(sure.time <= exact);
                CHECK(plain.frame.between(exact, rounded.time) == Approx(0).margin(1e-12));
            }
    }
    CHECK(found > 200);
}

TEST_CASE(
    "a rough time is not after the contact, however long the wait and "
    "however slight the touch")
{
    Random random(13);
    int rough = 0;
    for (int i = 0; i < 20000; ++i) {
        const double away = random.log_uniform(10, 1e7), half_chord = random.log_uniform(1e-8, 1e-2);
        Scene scene = empty_scene(1e8);
        add_sphere(scene, 0.5, Vec3::Zero(), {1, 0, 0});
        add_sphere(scene, 0.5, {away, std::sqrt((1 - half_chord) * (1 + half_chord)), 0});
        scene.spheres[1].fixed = true;
        const State state(scene, Precision::certified);
        const ContactTime sure = CertifiedKinematics::pair_time(state, 0, 1, never);
        if (!sure.comes) continue;
        ++rough;
        CAPTURE(i, away, half_chord);
        REQUIRE(sure.time <= CertifiedKinematics::exact_time(state, 0, Partner::sphere(1)));
    }
    CHECK(rough > 1000);
}
