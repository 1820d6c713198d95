#include "flight/frame.hpp"

#include "support/multiprecision.hpp"
#include "support/random.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using carom::test::Random;
using Real = carom::test::Float200;

namespace {

Real exact(const Frame& frame, const EpochTime& t)
{
    return Real(t.epoch) * Real(frame.epoch_length) + Real(t.offset);
}
Real exact(const Frame& frame, const Place& p, int k)
{
    return Real(p.cell[k]) * Real(frame.cell_size) + Real(p.local[k]);
}

bool is_normal(const Frame& frame, const EpochTime& t)
{
    return t.offset >= 0 && t.offset < frame.epoch_length;
}
bool is_normal(const Frame& frame, const Place& p)
{
    bool normal = true;
    for (int k = 0; k < 3; ++k) normal = normal && p.local[k] >= 0 && p.local[k] < frame.cell_size;
    return normal;
}

}  // namespace

TEST_CASE("a time after another is right to the resolution of an epoch, however far")
{
    Random random(1);
    for (const double length : {1.0, 0x1p-20, 0x1p10}) {
        const Frame frame{length, 1};
        for (int i = 0; i < 5000; ++i) {
            const EpochTime from{i % 2 == 0 ? 0 : std::int64_t{1} << 40, random.uniform(0, length)};
            const double dt = random.log_uniform(1e-20, 1e9);
            const EpochTime to = frame.after(from, dt);
            CHECK(is_normal(frame, to));
            CHECK(from <= to);
            CHECK(abs(exact(frame, to) - exact(frame, from) - Real(dt)) <= Real(0x1p-53) * Real(length));
        }
    }
}

TEST_CASE("between undoes after, to the resolution of an epoch, also 2^40 epochs away")
{
    Random random(2);
    const Frame frame{0x1p-6, 1};
    for (const std::int64_t epoch : {std::int64_t{0}, std::int64_t{1} << 40, std::int64_t{1} << 60}) {
        for (int i = 0; i < 5000; ++i) {
            const EpochTime from{epoch, random.uniform(0, frame.epoch_length)};
            const double dt = random.log_uniform(1e-12, 10);
            const double back = frame.between(from, frame.after(from, dt));
            CHECK(std::abs(back - dt) <= 0x1p-53 * frame.epoch_length + 0x1p-52 * dt);
        }
    }
}

TEST_CASE("the same steps in a later epoch give the same bits")
{
    Random random(3);
    const Frame frame{0x1p-3, 1};
    EpochTime now{}, later{std::int64_t{1} << 40, 0};
    for (int i = 0; i < 5000; ++i) {
        const double dt = random.log_uniform(1e-9, 10);
        now = frame.after(now, dt);
        later = frame.after(later, dt);
        CHECK(later.offset == now.offset);
        CHECK(later.epoch - now.epoch == std::int64_t{1} << 40);
    }
}

TEST_CASE("steps that end at or next to the border of an epoch are normal")
{
    const Frame frame{1, 1};
    const double below = std::nextafter(1.0, 0.0);
    CHECK(frame.after({0, 0}, 1) == EpochTime{1, 0});
    CHECK(frame.after({0, 0.5}, 0.5) == EpochTime{1, 0});
    CHECK(frame.after({0, below}, 0x1p-53) == EpochTime{1, 0});
    CHECK(frame.after({0, 0}, below) == EpochTime{0, below});
    CHECK(frame.after({7, 0.25}, 0) == EpochTime{7, 0.25});
    CHECK(frame.after({0, 0.75}, 3.5) == EpochTime{4, 0.25});
    for (const double offset : {0.0, 1e-300, 0x1p-54, 0.5, below})
        for (const double dt : {1e-300, 0x1p-54, 0x1p-53, below, 1.0, 1 + 0x1p-52, 2 - 0x1p-52, 1e15, 1e15 + 0.125}) {
            const EpochTime to = frame.after({3, offset}, dt);
            INFO("offset " << offset << ", dt " << dt);
            CHECK(is_normal(frame, to));
            CHECK(abs(exact(frame, to) - 3 - Real(offset) - Real(dt)) <= Real(0x1p-53));
        }
}

TEST_CASE("never is later than everything, and an infinite or absurd wait ends there")
{
    const Frame frame{0.5, 1};
    CHECK(frame.after({0, 0}, std::numeric_limits<double>::infinity()) == never);
    CHECK(frame.after({0, 0}, 0x1p62) == never);
    CHECK(frame.after({0, 0}, 1e300) == never);
    CHECK(frame.after({0, 0}, 0x1p60) < never);
    CHECK(EpochTime{std::int64_t{1} << 62, 0.4} < never);
    CHECK(frame.between({0, 0}, never) == std::numeric_limits<double>::infinity());
}

TEST_CASE("a coordinate is split exactly into cell and rest")
{
    Random random(4);
    for (const double cell : {0x1p-7, 1.0, 0x1p5}) {
        const Frame frame{1, cell};
        for (int i = 0; i < 5000; ++i) {
            Vec3 p;
            for (int k = 0; k < 3; ++k) p[k] = random.sign() * random.log_uniform(1e-6, 1e9);
            const Place place = place_at(frame, p);
            CHECK(is_normal(frame, place));
            // Below 0 the rest is counted from the next cell: exact to its resolution.
            for (int k = 0; k < 3; ++k)
                CHECK(abs(exact(frame, place, k) - Real(p[k])) <= (p[k] < 0 ? Real(0x1p-53) * Real(cell) : Real(0)));
            for (int k = 0; k < 3; ++k)
                CHECK(std::abs(position_of(frame, place)[k] - p[k]) <= 0x1p-53 * (std::abs(p[k]) + cell));
        }
    }
    const Frame frame{1, 1};
    const Place edge = place_at(frame, {-1e-300, -1, 2});
    CHECK(is_normal(frame, edge));
    CHECK(edge.cell[0] == 0);
    CHECK(edge.cell[1] == -1);
    CHECK(edge.cell[2] == 2);
}

TEST_CASE("a moved place is normal, and right to the rounding of the displacement")
{
    Random random(5);
    const Frame frame{1, 0.25};
    for (int i = 0; i < 10000; ++i) {
        Place from = place_at(frame, random.in_cube(10));
        Vec3 d;
        for (int k = 0; k < 3; ++k) d[k] = random.sign() * random.log_uniform(1e-20, 1e6);
        const Place to = moved(frame, from, d);
        CHECK(is_normal(frame, to));
        for (int k = 0; k < 3; ++k)
            CHECK(abs(exact(frame, to, k) - exact(frame, from, k) - Real(d[k])) <=
                  Real(0x1p-52) * (Real(std::abs(d[k])) + Real(frame.cell_size)));
    }
    Place low;  // at a lower wall, moved down by less than the resolution
    const Place to = moved(frame, low, {-1e-300, -1e-17, -0.25});
    CHECK(is_normal(frame, to));
}

TEST_CASE("a shift by whole cells leaves the local bits alone, in place and in motion")
{
    Random random(6);
    const Frame frame{1, 2};
    for (int i = 0; i < 3000; ++i) {
        Vec3 p;
        for (int k = 0; k < 3; ++k) p[k] = std::ldexp(static_cast<double>(random.integer(0, 1 << 30)), -20);
        const Vec3 shift(2.0 * random.integer(-1000, 1000), 2.0 * random.integer(-1000, 1000), 2048);
        Place near = place_at(frame, p), far = place_at(frame, p + shift);
        const Vec3 d = random.in_cube(50);
        for (int step = 0; step < 2; ++step) {
            for (int k = 0; k < 3; ++k) {
                CHECK(near.local[k] == far.local[k]);
                CHECK(static_cast<double>(far.cell[k] - near.cell[k]) * frame.cell_size == shift[k]);
            }
            near = moved(frame, near, d);
            far = moved(frame, far, d);
        }
    }
}

TEST_CASE("the rulers of a scene are powers of two that fit its radii and speeds")
{
    Scene scene;
    scene.end_time = 10;
    scene.gravity = {0, 0, -9.81};
    Sphere s;
    s.radius = 0.3;
    s.velocity = {100, 0, 0};
    scene.spheres = {s, s};
    scene.spheres[1].radius = 7;
    scene.spheres[1].position = {20, 0, 0};
    const Frame frame = make_frame(scene);
    CHECK(power_of_two_below(frame.epoch_length) == frame.epoch_length);
    CHECK(power_of_two_below(frame.cell_size) == frame.cell_size);
    CHECK(frame.cell_size > 0.6);
    CHECK(frame.cell_size <= 1.2);
    CHECK(frame.epoch_length * 100 <= 0.3);
    CHECK(frame.epoch_length * 1000 >= 0.3);
    CHECK(power_of_two_below(1) == 1);
    CHECK(power_of_two_below(1.99) == 1);
    CHECK(power_of_two_below(0.75) == 0.5);
    CHECK(make_frame(Scene{}).epoch_length > 0);
}
