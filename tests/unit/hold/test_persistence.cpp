// Which contacts of a component persist, with figures that can be found by hand.
#include "hold/persistence.hpp"
#include "motion/state.hpp"
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double g = 10;
const Vec3 down{0, 0, -g};

/// The persistence of all contacts that a scene declares, as it begins.
class Decided {
public:
    explicit Decided(const Scene& scene)
        : state_(scene, Precision::plain), result(state_, declared_components(state_).front())
    {
    }

private:
    State state_;

public:
    Persistence result;

    std::size_t contact(BodyId a, Partner b) const
    {
        const auto& contacts = result.component().problem.contacts;
        const auto found = std::find_if(contacts.begin(), contacts.end(), [&](const Contact& c) {
            return result.component().id_of_a(c) == a && c.partner == b;
        });
        REQUIRE(found != contacts.end());
        return static_cast<std::size_t>(found - contacts.begin());
    }
    bool persists(BodyId a, Partner b) const { return result.persists(contact(a, b)); }
    double force(BodyId a, Partner b) const { return result.force(contact(a, b)); }
    const Vec3& velocity(std::size_t body) const { return result.component().problem.bodies[body].velocity; }
    double rate(BodyId a, Partner b) const
    {
        const Contact& c = result.component().problem.contacts[contact(a, b)];
        const Vec3 other = c.b ? velocity(static_cast<std::size_t>(*c.b)) : Vec3(Vec3::Zero());
        return c.normal.dot(velocity(static_cast<std::size_t>(c.a)) - other);
    }
};

void add_fixed(Scene& scene, const Vec3& place)
{
    add_sphere(scene, 0.5, place);
    scene.spheres.back().fixed = true;
}

Partner sphere(BodyId id)
{
    return Partner::sphere(id);
}

const Partner floor_plane = Partner::plane(0);

}  // namespace

TEST_CASE("all of four supports under a ball persist, though three would carry it, and together they carry its weight")
{
    Scene scene = empty_scene(1, down, 0.5);
    add_sphere(scene, 0.5, {0, 0, std::sqrt(0.5)});
    for (const double x : {0.5, -0.5})
        for (const double y : {0.5, -0.5}) add_fixed(scene, {x, y, 0});
    const Decided decided(scene);
    double carried = 0;
    for (BodyId support = 1; support <= 4; ++support) {
        CHECK(decided.persists(0, sphere(support)));
        carried += std::sqrt(0.5) * decided.force(0, sphere(support));
    }
    CHECK(carried == Approx(g).epsilon(1e-12));
    CHECK(decided.result.rests(0));
}

TEST_CASE("two contacts between which a ball is jammed persist, though its way would open each, and it goes on")
{
    Scene scene = empty_scene(1);
    add_sphere(scene, 0.5, {0, 0, 0}, {0, 0, 1});
    add_fixed(scene, {-1, 0, 0});
    add_fixed(scene, {1, 0, 0});
    Decided decided(scene);
    CHECK(decided.persists(0, sphere(1)));
    CHECK(decided.persists(0, sphere(2)));
    CHECK(decided.velocity(0) == Vec3(0, 0, 1));
    CHECK(decided.result.energy_taken() == 0);

    // What a step found open is out for good, jammed or not.
    decided.result.release({decided.contact(0, sphere(1))});
    CHECK_FALSE(decided.persists(0, sphere(1)));
    CHECK(decided.persists(0, sphere(2)));
    CHECK(decided.velocity(0) == Vec3(0, 0, 1));
}

TEST_CASE("a contact that carries exactly nothing persists while nothing opens it")
{
    for (const Vec3& gravity : {Vec3(Vec3::Zero()), down}) {
        Scene scene = empty_scene(1, gravity, 0.5);
        add_floor(scene);
        add_sphere(scene, 0.5, {0, 0, 0.5}, {1, 2, 0});
        add_sphere(scene, 0.5, {1, 0, 0.5}, {1, 2, 0});
        const Decided decided(scene);
        CHECK(decided.persists(0, sphere(1)));
        CHECK(decided.force(0, sphere(1)) == 0);
        CHECK_FALSE(decided.result.turns(decided.contact(0, sphere(1))));
        for (const BodyId ball : {0, 1}) {
            CHECK(decided.persists(ball, floor_plane));
            CHECK(decided.force(ball, floor_plane) == Approx(gravity.norm()));
            CHECK(decided.velocity(static_cast<std::size_t>(ball)) == Vec3(1, 2, 0));
        }
    }
}

TEST_CASE("a contact that opens from no speed opens by a margin of roundings, in whatever direction")
{
    Random random(20);
    for (int trial = 0; trial < 500; ++trial) {
        const Vec3 normal = random.direction().normalized();
        const Vec3 v = 5 * random.across(normal).normalized();
        Scene scene = empty_scene(1, -g * normal, 0.5);
        add_sphere(scene, 0.5, normal, v);
        add_fixed(scene, Vec3::Zero());
        const Decided decided(scene);
        CHECK_FALSE(decided.persists(0, sphere(1)));  // 25 / 1 > g
        CHECK(decided.rate(0, sphere(1)) > 5e-16);
        CHECK((decided.velocity(0) - v).norm() < 5e-14);
    }
}

TEST_CASE("balls that a third one drives apart open by a margin, while the contacts that drive them keep rate 0")
{
    Scene scene = empty_scene(1, down, 0.5);
    add_floor(scene);
    add_sphere(scene, 0.5, {-0.5, 0, 0.5});
    add_sphere(scene, 0.5, {0.5, 0, 0.5});
    add_sphere(scene, 0.5, {0, 0, 0.5 + std::sqrt(0.75)});
    const Decided decided(scene);
    CHECK_FALSE(decided.persists(0, sphere(1)));
    const double opening = decided.rate(0, sphere(1));
    CHECK(opening > 0);
    for (const BodyId ball : {0, 1}) {
        CHECK(decided.persists(ball, floor_plane));
        CHECK(decided.persists(ball, sphere(2)));
        CHECK(decided.velocity(static_cast<std::size_t>(ball)).norm() < 1e-15);
        CHECK(std::abs(decided.rate(ball, floor_plane)) < 1e-12 * opening);
        CHECK(std::abs(decided.rate(ball, sphere(2))) < 1e-12 * opening);
    }
    // The top falls with a, the others part with a sqrt(3): 2 F sin 60 = m (g - a) and F cos 60 = m a sqrt(3).
    const double fall = -decided.result.acceleration(2).z();
    CHECK(decided.result.acceleration(1).x() == Approx(fall * std::sqrt(3.0)));
    CHECK(decided.force(0, sphere(2)) == Approx(2 * fall * std::sqrt(3.0)));
    CHECK(fall == Approx(g / 7));
}

TEST_CASE("a ball that slides along a floor and past a sphere leaves the one on which nothing presses it")
{
    for (const bool pressed_on_floor : {true, false}) {
        Scene scene = empty_scene(1, pressed_on_floor ? down : Vec3(-g, 0, 0), 0.5);
        add_floor(scene);
        add_sphere(scene, 0.5, {0, 0, 0.5}, {0, 2, 0});
        add_fixed(scene, {-0.8, 0, -0.1});
        const Decided decided(scene);
        // Its normal turns at 2 rad/s: 4 of acceleration, beside 0.8 g that presses.
        CHECK(decided.persists(0, floor_plane) == pressed_on_floor);
        CHECK(decided.persists(0, sphere(1)) != pressed_on_floor);
        CHECK(decided.force(0, floor_plane) == Approx(pressed_on_floor ? g : 0));
        CHECK(decided.force(0, sphere(1)) == Approx(pressed_on_floor ? 0 : 4));
        const double of_floor = decided.rate(0, floor_plane), of_sphere = decided.rate(0, sphere(1));
        CHECK(std::abs(pressed_on_floor ? of_floor : of_sphere) < 1e-16);
        CHECK((pressed_on_floor ? of_sphere : of_floor) > 1e-16);
        CHECK((decided.velocity(0) - Vec3(0, 2, 0)).norm() < 1e-14);
    }
}

TEST_CASE("without gravity a contact opens if it would by its tolerance before the end of the run")
{
    for (const double w : {2e-5, 1e-4}) {  // opens by w^2/2 = 2e-10 and 5e-9 within 1, the tolerance is 5e-10
        Scene scene = empty_scene(1);
        add_sphere(scene, 0.5, {0, 0, 0}, {1, 0, 0});
        add_sphere(scene, 0.5, {0, 0, 1}, {1, w, 0});
        const Decided decided(scene);
        CHECK(decided.persists(0, sphere(1)) == (w < 5e-5));
        CHECK(decided.rate(0, sphere(1)) >= 0);
    }
}

TEST_CASE("a new contact that meets a numeric piece opens if it would by its tolerance within a step, others at once")
{
    for (const bool in_piece : {false, true})
        for (const double opening : {1e-5, 1e-4}) {  // by 1e-10 and 1e-9 within a step of 4.5e-3
            Scene scene = empty_scene(1, down, 0.5);
            add_sphere(scene, 0.5, {0, 0, 1}, {0, std::sqrt(g + opening), 0});
            add_fixed(scene, Vec3::Zero());
            State state(scene, Precision::plain);
            ContactComponent component = declared_components(state).front();
            component.problem.contacts.front().persistent = false;
            if (in_piece) state.bodies.set({0, state.flight(0), Stepping{}});
            CHECK(Persistence(state, component).persists(0) == (in_piece && opening < 5e-5));
        }
}
