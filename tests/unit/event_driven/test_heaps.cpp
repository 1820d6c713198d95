/// Heaps: windows in which nothing overlaps, exact rest, and what wakes it.
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

/// Balls of 8 to 16 mm fall into a box four or five of them wide.
Scene dropped(std::uint64_t seed, int count, double restitution, double end_time)
{
    constexpr double side = 0.1;
    Scene scene = empty_scene(end_time, earth, restitution);
    scene.guard.fallback = GuardFallback::windows;
    Random random(seed);
    add_box(scene, side);
    fill_box(scene, random, count, side, 0.008, 0.016, 0);
    return scene;
}

bool rest(const Outcome& out, std::size_t first, std::size_t last)
{
    return std::all_of(out.final.begin() + static_cast<std::ptrdiff_t>(first),
                       out.final.begin() + static_cast<std::ptrdiff_t>(last),
                       [](const BodyState& s) { return s.mode == Mode::resting && s.velocity.isZero(0); });
}

/// Places as flights have them, in arithmetic of its own.
class Paths {
public:
    void begin(const RunFrame& frame) { frame_ = frame; }
    void add(const FlightRecord& flight) { flights_.push_back(flight); }

    /// The lowest gap of all pairs of spheres at any time [smaller radius], but for numeric steps, whose parabolas are
    /// no exact paths: of flights with one acceleration in closed form, of others at times a 64th of the interval
    /// apart.
    double lowest_gap(const Scene& scene, double end) const
    {
        std::vector<std::vector<FlightRecord>> paths(scene.spheres.size());
        for (const FlightRecord& f : flights_) paths[static_cast<std::size_t>(f.body)].push_back(f);
        long double lowest = 1;
        for (std::size_t i = 0; i < paths.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const long double sum = static_cast<long double>(scene.spheres[i].radius) + scene.spheres[j].radius,
                                  radius = std::min(scene.spheres[i].radius, scene.spheres[j].radius);
                std::size_t a = 0, b = 0;
                while (a < paths[i].size() && b < paths[j].size()) {
                    const long double from = std::max(start(paths[i][a]), start(paths[j][b])),
                                      to = std::min(next(paths[i], a, end), next(paths[j], b, end));
                    if (!is_stepping(paths[i][a]) && !is_stepping(paths[j][b]))
                        lowest = std::min(lowest, (nearest(paths[i][a], paths[j][b], from, to) - sum) / radius);
                    const bool a_ends = next(paths[i], a, end) <= to, b_ends = next(paths[j], b, end) <= to;
                    a += a_ends;
                    b += b_ends;
                }
            }
        return static_cast<double>(lowest);
    }

private:
    using Point = std::array<long double, 3>;

    static bool is_stepping(const FlightRecord& f)
    {
        return f.mode == Mode::numeric && f.acceleration == own_acceleration;
    }
    long double start(const FlightRecord& f) const
    {
        return static_cast<long double>(f.start.epoch) * frame_.epoch_length + f.start.offset;
    }
    long double next(const std::vector<FlightRecord>& path, std::size_t k, double end) const
    {
        return k + 1 < path.size() ? start(path[k + 1]) : static_cast<long double>(end);
    }
    Point place(const FlightRecord& f, long double time) const
    {
        const long double t = time - start(f);
        Point out{};
        for (std::size_t k = 0; k < 3; ++k) {
            const long double a =
                f.acceleration == own_acceleration
                    ? f.own[k]
                    : frame_.accelerations[static_cast<std::size_t>(f.acceleration)][static_cast<Eigen::Index>(k)];
            out[k] =
                static_cast<long double>(f.cell[k]) * frame_.cell_size + f.local[k] + t * f.velocity[k] + t * t * a / 2;
        }
        return out;
    }
    static long double dot(const Point& x, const Point& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }
    Point apart(const FlightRecord& a, const FlightRecord& b, long double time) const
    {
        Point out = place(a, time);
        const Point other = place(b, time);
        for (std::size_t k = 0; k < 3; ++k) out[k] -= other[k];
        return out;
    }
    long double nearest(const FlightRecord& a, const FlightRecord& b, long double from, long double to) const
    {
        const Point first = apart(a, b, from), last = apart(a, b, to);
        long double least = std::min(dot(first, first), dot(last, last));
        if (a.acceleration == b.acceleration && a.acceleration != own_acceleration) {
            Point way{};
            for (std::size_t k = 0; k < 3; ++k) way[k] = last[k] - first[k];
            const long double square = dot(way, way);
            if (square > 0) {
                const long double part = std::clamp(-dot(first, way) / square, 0.0L, 1.0L);
                Point at = first;
                for (std::size_t k = 0; k < 3; ++k) at[k] += part * way[k];
                least = std::min(least, dot(at, at));
            }
        } else {
            for (int k = 1; k < 64; ++k) {
                const Point at = apart(a, b, from + k * (to - from) / 64);
                least = std::min(least, dot(at, at));
            }
        }
        return std::sqrt(least);
    }

    RunFrame frame_;
    std::vector<FlightRecord> flights_;
};

}  // namespace

TEST_CASE("several heaps in a wide box, whose windows reach into each other, go on and do not overlap", "[heap]")
{
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        Scene scene = empty_scene(0.8, earth, 0.5);
        scene.guard.fallback = GuardFallback::windows;
        constexpr double side = 0.3;
        add_box(scene, side);
        Random random(seed);
        fill_box(scene, random, 60, side, 0.008, 0.016, 0);
        Paths paths;
        Observer observer;
        observer.on_frame = [&](const RunFrame& frame) { paths.begin(frame); };
        observer.on_flight = [&](const FlightRecord& flight) { paths.add(flight); };
        const Outcome out = simulate(scene, EventDriven{}, {}, observer);
        CAPTURE(seed, out.message);
        REQUIRE(out.status == Status::reached_end);
        CHECK(out.energy_taken.window >= 0);
        // Stepped pieces before the windows leave up to some 1e-6 r (docs/regimes.md).
        CHECK(paths.lowest_gap(scene, scene.end_time) > -1e-6);
    }
}

TEST_CASE("a heap of thirty-six comes to exact rest, does not overlap in windows and has gained no energy after them",
          "[heap]")
{
    for (const double e : {0.3, 0.5})
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const Scene scene = dropped(seed, 36, e, 2);
            Paths paths;
            Observer observer;
            observer.on_frame = [&](const RunFrame& frame) { paths.begin(frame); };
            observer.on_flight = [&](const FlightRecord& flight) { paths.add(flight); };
            observer.sample_times = sample_grid(scene.end_time, 2000);
            double before = energy(scene, initial_states(scene)), rise = 0;
            const double start = before;
            observer.on_sample = [&](std::size_t, double, std::span<const BodyState> states) {
                // Within a window what rebounds will give back is stored.
                if (std::any_of(states.begin(), states.end(),
                                [](const BodyState& s) { return s.mode == Mode::numeric; }))
                    return;
                const double now = energy(scene, {states.begin(), states.end()});
                rise = std::max(rise, now - before);
                before = now;
            };
            const Outcome out = simulate(scene, EventDriven{}, {}, observer);
            CAPTURE(e, seed, out.message);
            REQUIRE(out.status == Status::reached_end);
            CHECK(out.counts.guarded > 0);
            CHECK(rest(out, 0, scene.spheres.size()));
            CHECK(rise <= 1e-12 * start);
            CHECK(paths.lowest_gap(scene, scene.end_time) > -1e-9);
        }
}

TEST_CASE("walls and floor carry the weight of a heap at rest", "[heap]")
{
    Scene scene = dropped(5, 36, 0.4, 2);
    const Outcome before = record(scene).outcome;
    scene.end_time = 2.5;
    const Outcome after = record(scene).outcome;
    REQUIRE(rest(before, 0, scene.spheres.size()));
    double mass = 0;
    for (const Sphere& s : scene.spheres) mass += s.mass;
    Vec3 carried = Vec3::Zero();
    for (std::size_t p = 0; p < scene.planes.size(); ++p) {
        const double impulse = after.plane_impulses[p] - before.plane_impulses[p];
        CHECK(impulse >= 0);
        carried += impulse * scene.planes[p].normal;
    }
    CHECK((carried / 0.5 + mass * scene.gravity).norm() < 1e-8 * mass * scene.gravity.norm());
}

TEST_CASE("planes take the momentum that a heap loses in windows", "[heap]")
{
    const Scene scene = dropped(6, 36, 0.3, 0.15);
    const Outcome out = record(scene).outcome;
    REQUIRE(out.body_seconds.guarded > 0);
    Vec3 momentum = Vec3::Zero(), taken = Vec3::Zero();
    double mass = 0;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        momentum += scene.spheres[i].mass * out.final[i].velocity;
        mass += scene.spheres[i].mass;
    }
    for (std::size_t p = 0; p < scene.planes.size(); ++p) taken += out.plane_impulses[p] * scene.planes[p].normal;
    const Vec3 fallen = mass * scene.end_time * scene.gravity;
    // The books of numeric steps before the windows are mean forces: 1e-6 of it is theirs.
    CHECK((momentum - taken - fallen).norm() < 1e-5 * fallen.norm());
}

TEST_CASE("a bullet into a heap keeps momentum along the floor", "[heap]")
{
    Scene scene = dropped(2, 36, 0.3, 1.2);
    scene.planes.clear();
    add_floor(scene);
    for (int k = 0; k < 2; ++k) {  // a trough, open at both ends
        if (k == 0) add_plane(scene, "left", Vec3::UnitX(), 0);
        if (k == 1) add_plane(scene, "right", -Vec3::UnitX(), -0.1);
    }
    add_sphere(scene, 0.01, {0.05, -20, 0.03}, {0, 1000, 0}, 1e-6);
    scene.end_time = 0.3;
    const Outcome out = record(scene).outcome;
    REQUIRE(out.status == Status::reached_end);
    double before = 0, after = 0, moved = 0;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        before += scene.spheres[i].mass * scene.spheres[i].velocity.y();
        after += scene.spheres[i].mass * out.final[i].velocity.y();
        moved += scene.spheres[i].mass * std::abs(out.final[i].velocity.y());
    }
    CHECK(std::abs(after - before) < 1e-12 * std::max(before, moved));
    CHECK(out.final.back().position.y() < 1000 * 0.3 - 20.1);  // it went through none
}

TEST_CASE("a ball that falls on a heap at rest wakes it, and all rest again", "[heap]")
{
    Scene scene = dropped(3, 36, 0.3, 3);
    const Outcome alone = record(scene).outcome;
    REQUIRE(rest(alone, 0, 36));
    add_sphere(scene, 0.012, {0.05, 0.05, 9.81 / 2 + 0.085}, Vec3::Zero(), 4e-6);
    scene.planes.back().offset = -10;  // the ceiling
    const Outcome out = record(scene).outcome;
    REQUIRE(out.status == Status::reached_end);
    CHECK(rest(out, 0, 37));
    double farthest = 0;
    for (std::size_t i = 0; i < 36; ++i)
        farthest = std::max(farthest, (out.final[i].position - alone.final[i].position).norm());
    CHECK(farthest > 1e-6);
    CHECK(out.counts.releases > alone.counts.releases);
}

TEST_CASE("a light ball that falls on a heap at rest moves nothing, and walls and floor carry its weight, too",
          "[heap]")
{
    constexpr double light = 1e-7;
    Scene scene = dropped(6, 36, 0.3, 6);
    double mass = 0;
    for (const Sphere& s : scene.spheres) mass += s.mass;
    add_sphere(scene, 0.012, {0.05, 0.05, 9.81 / 2 + 0.085}, Vec3::Zero(), light * mass);
    scene.planes.back().offset = -10;  // the ceiling
    Observer observer;
    observer.sample_times = {0.98, 6};  // the ball comes at 1 s
    std::vector<std::vector<BodyState>> seen;
    observer.on_sample = [&](std::size_t, double, std::span<const BodyState> states) {
        seen.emplace_back(states.begin(), states.end());
    };
    const Outcome out = simulate(scene, EventDriven{}, {}, observer);
    REQUIRE(rest(out, 0, 37));
    for (std::size_t i = 0; i < 36; ++i) {
        REQUIRE(seen.front()[i].mode == Mode::resting);
        CHECK(seen.back()[i].position == seen.front()[i].position);
    }
    scene.end_time = 6.5;
    const Outcome after = record(scene).outcome;
    Vec3 carried = Vec3::Zero();
    for (std::size_t p = 0; p < scene.planes.size(); ++p)
        carried += (after.plane_impulses[p] - out.plane_impulses[p]) * scene.planes[p].normal;
    CHECK((carried / 0.5 + (1 + light) * mass * scene.gravity).norm() < 1e-10 * mass * scene.gravity.norm());
}

TEST_CASE("a body that touches nothing changes no bit of a heap", "[heap]")
{
    Scene scene = dropped(4, 36, 0.4, 1);
    const Outcome alone = record(scene).outcome;
    add_sphere(scene, 0.01, {0.05, -0.05, 0.05}, Vec3::Zero(), 4e-6);
    scene.spheres.back().fixed = true;
    const Outcome beside = record(scene).outcome;
    REQUIRE(alone.status == Status::reached_end);
    for (std::size_t i = 0; i < 36; ++i) CHECK(alone.final[i].position == beside.final[i].position);
}

TEST_CASE("a heap is the same whatever the broad phase", "[heap]")
{
    const Scene scene = dropped(7, 36, 0.3, 1);
    EventDriven all_pairs, cells;
    all_pairs.broad_phase = BroadPhase::all_pairs;
    cells.broad_phase = BroadPhase::cell_grid;
    CHECK(record(scene, all_pairs).outcome.event_hash == record(scene, cells).outcome.event_hash);
}
