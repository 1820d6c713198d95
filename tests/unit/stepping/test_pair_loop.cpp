/// \file
/// pbd against a slow twin: the handout's loop over all pairs, each tested where those before it have left it.
#include "run_all.hpp"
#include "small_scenes.hpp"
#include "stepping/contact.hpp"
#include "stepping/contact_order.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

using namespace carom;
using namespace carom::test;

namespace {

/// The handout's method for one material, written out.
class SlowTwin {
public:
    SlowTwin(const Scene& scene, const PositionBased& method)
        : scene_(scene), method_(method), random_(method.order, method.seed)
    {
        for (const Sphere& s : scene.spheres) {
            position.push_back(s.position);
            velocity.push_back(s.velocity);
        }
    }

    void step(double h)
    {
        for (std::size_t i = 0; i < position.size(); ++i) {
            if (scene_.spheres[i].fixed) continue;
            velocity[i] += h * scene_.gravity;
            position[i] += h * velocity[i];
        }
        for (int pass = 0; pass < method_.passes; ++pass) {
            const bool respond = pass == 0 || !method_.literal;
            for (const auto& [i, j] : arranged(all_pairs())) pair(i, j, respond);
            for (const auto& [i, w] : arranged(all_walls())) wall(i, w - position.size(), respond);
        }
    }

    std::vector<Vec3> position, velocity;
    std::int64_t visits_that_no_list_had = 0;  ///< pairs that overlapped at their turn only

private:
    using Pair = std::pair<std::size_t, std::size_t>;

    std::vector<Pair> all_pairs() const
    {
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < position.size(); ++i)
            for (std::size_t j = i + 1; j < position.size(); ++j) pairs.emplace_back(i, j);
        return pairs;
    }
    std::vector<Pair> all_walls() const
    {
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < position.size(); ++i)
            for (std::size_t w = 0; w < scene_.planes.size(); ++w) pairs.emplace_back(i, position.size() + w);
        return pairs;
    }

    double gap(const Pair& pair) const
    {
        const auto& [i, j] = pair;
        if (j < position.size())
            return (position[i] - position[j]).norm() - (scene_.spheres[i].radius + scene_.spheres[j].radius);
        const Plane& p = scene_.planes[j - position.size()];
        return p.normal.dot(position[i]) - p.offset - scene_.spheres[i].radius;
    }

    std::vector<Pair> arranged(std::vector<Pair> pairs)
    {
        if (method_.order == ContactOrder::reverse) std::reverse(pairs.begin(), pairs.end());
        if (method_.order == ContactOrder::deepest)
            std::stable_sort(pairs.begin(), pairs.end(), [&](const Pair& x, const Pair& y) { return gap(x) < gap(y); });
        if (method_.order == ContactOrder::random) {
            const std::uint64_t salt = random_.draw();
            const auto rank = [&](const Pair& p) {
                return stepping::mix_bits(salt + stepping::mix_bits(std::uint64_t{p.first} << 32 | p.second));
            };
            std::sort(pairs.begin(), pairs.end(), [&](const Pair& x, const Pair& y) { return rank(x) < rank(y); });
        }
        if (!pairs.empty() && pairs.front().second < position.size()) {
            overlapping_.clear();
            for (const Pair& p : pairs)
                if (gap(p) <= 0) overlapping_.push_back(p);
            std::sort(overlapping_.begin(), overlapping_.end());
        }
        return pairs;
    }

    double inverse_mass(std::size_t i) const { return scene_.spheres[i].fixed ? 0 : 1 / scene_.spheres[i].mass; }

    void pair(std::size_t i, std::size_t j, bool respond)
    {
        if (scene_.spheres[i].fixed && scene_.spheres[j].fixed) return;
        const double sum = scene_.spheres[i].radius + scene_.spheres[j].radius;
        const Vec3 between = position[i] - position[j];
        const double square = between.x() * between.x() + between.y() * between.y() + between.z() * between.z();
        if (square > sum * sum) return;
        if (!std::binary_search(overlapping_.begin(), overlapping_.end(), Pair(i, j))) ++visits_that_no_list_had;
        const double distance = std::sqrt(square);
        const Vec3 u = distance > 0 ? Vec3(between / distance) : Vec3::UnitX();
        const double e = scene_.materials[0].restitution;
        const double wi = inverse_mass(i), wj = inverse_mass(j);
        const double rate = (velocity[i] - velocity[j]).dot(u);
        if (respond && (method_.literal || rate < 0)) {
            const Vec3 impulse = (-(1 + e) * (1 / (wi + wj)) * rate) * u;
            velocity[i] += wi * impulse;
            velocity[j] -= wj * impulse;
        }
        const double gap = distance - sum;
        const double share = method_.mass_weighted || wi == 0 || wj == 0 ? wi / (wi + wj) : 0.5;
        position[i] -= (share * gap) * u;
        position[j] += ((1 - share) * gap) * u;
    }

    void wall(std::size_t i, std::size_t w, bool respond)
    {
        if (scene_.spheres[i].fixed) return;
        const Vec3& n = scene_.planes[w].normal;
        const double height =
            n.x() * position[i].x() + n.y() * position[i].y() + n.z() * position[i].z() - scene_.planes[w].offset;
        const double gap = height - scene_.spheres[i].radius;
        if (gap > 0) return;
        const double rate = velocity[i].dot(n);
        if (respond && (method_.literal || rate < 0)) velocity[i] -= ((1 + scene_.materials[0].restitution) * rate) * n;
        position[i] -= gap * n;
    }

    const Scene& scene_;
    const PositionBased& method_;
    stepping::ContactArranger random_;
    std::vector<Pair> overlapping_;
};

/// Spheres of mixed sizes that fall into a corner, some fixed, some overlapping from the start.
Scene heap(std::size_t n, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::vector<Sphere> spheres;
    const double side = 0.35 * std::cbrt(static_cast<double>(n));
    for (std::size_t k = 0; k < n; ++k) {
        const double radius = k % 7 == 0 ? 0.35 : 0.06 + 0.1 * uniform(random);
        const Vec3 position = Vec3(0.1, 0.1, 0.1) + uniform_vector(random, 0, side);
        const Vec3 velocity = uniform_vector(random, -1, 1);
        Sphere s = ball(radius, position, velocity, 0.5 + uniform(random));
        if (k % 11 == 5) {
            s.fixed = true;
            s.velocity = Vec3::Zero();
        }
        spheres.push_back(s);
    }
    std::vector<Plane> walls{wall(Vec3::UnitZ(), 0), wall(Vec3::UnitX(), 0), wall(Vec3(0.6, 0.8, 0), 0),
                             wall(-Vec3::UnitX(), -side), wall(-Vec3::UnitY(), -side)};
    Scene scene = scene_of(std::move(spheres), std::move(walls), Vec3(0.1, -0.2, -9.81));
    scene.materials[0].restitution = 0.6;
    return scene;
}

/// Columns of balls that lie on each other.
Scene stacks(std::size_t columns, std::size_t height)
{
    std::vector<Sphere> spheres;
    for (std::size_t c = 0; c < columns; ++c)
        for (std::size_t k = 0; k < height; ++k)
            spheres.push_back(ball(0.1, Vec3(0.21 * static_cast<double>(c), 0, 0.1 + 0.2 * static_cast<double>(k))));
    return scene_of(std::move(spheres), {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -9.81));
}

/// \return pairs that only the single loop sees
std::int64_t check_same(const Scene& scene, const PositionBased& method, int count)
{
    SlowTwin twin(scene, method);
    for (int k = 0; k < count; ++k) twin.step(method.dt);
    const Outcome outcome = run_discrete(scene, method, until(method.dt * count));
    REQUIRE(outcome.counts.steps == count);
    for (std::size_t i = 0; i < twin.position.size(); ++i) {
        CAPTURE(i);
        REQUIRE(outcome.final[i].position == twin.position[i]);
        REQUIRE(outcome.final[i].velocity == twin.velocity[i]);
    }
    return twin.visits_that_no_list_had;
}

}  // namespace

TEST_CASE(
    "pbd is the double loop over all pairs in which each is tested where those before it have left it, bit for bit",
    "[stepping]")
{
    // Small scenes are searched pair by pair, large ones by a grid.
    for (const std::size_t n : {5U, 40U, 300U}) {
        for (const bool literal : {false, true}) {
            for (const ContactOrder order :
                 {ContactOrder::index, ContactOrder::reverse, ContactOrder::random, ContactOrder::deepest}) {
                CAPTURE(n, literal, name(order));
                // Powers of two, so that the length of a step is the same in both.
                PositionBased method{steps(1.0 / 128, 1, 2)};
                method.order = order;
                method.literal = literal;
                const std::int64_t late = check_same(heap(n, n), method, n == 300 ? 40 : 100);
                if (n == 300) CHECK(late > 100);
            }
        }
    }
}

TEST_CASE("pbd is the double loop for stacks, shared by mass or half and half", "[stepping]")
{
    for (const bool weighted : {false, true}) {
        PositionBased method{steps(1.0 / 64)};
        method.mass_weighted = weighted;
        CHECK(check_same(stacks(1, 5), method, 192) > 0);
        CHECK(check_same(stacks(1, 10), method, 192) > 0);
        CHECK(check_same(stacks(20, 10), method, 60) > 0);
    }
}

TEST_CASE("pbd is the double loop where corrections outdo all overlaps, as under a very heavy top", "[stepping]")
{
    // Both of a pair leave their cells at once, and one of them has a list.
    std::vector<Sphere> tower;
    for (std::size_t k = 0; k < 10; ++k)
        tower.push_back(ball(0.125, Vec3(0, 0, 0.125 + 0.25 * static_cast<double>(k)), Vec3::Zero(), k < 9 ? 1 : 1e12));
    Scene scene = scene_of(std::move(tower), {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -8));
    scene.materials[0].restitution = 0.5;
    CHECK(check_same(scene, PositionBased{steps(1.0 / 16)}, 3200) > 0);
}

TEST_CASE("Under jacobi what a correction pushes together waits for the next step, else not", "[stepping]")
{
    // 0 and 1 overlap by 2 d; parted, 1 overlaps 2, which it did not touch, by d / 2.
    const double d = 0.01;
    const Scene scene =
        scene_of({ball(0.1, Vec3(0, 0, 0)), ball(0.1, Vec3(0.2 - 2 * d, 0, 0)), ball(0.1, Vec3(0.4 - 1.5 * d, 0, 0))});
    PositionBased method{steps(0.01)};
    const auto gap_of_last = [&] {
        const auto final = run_discrete(scene, method, until(0.01)).final;
        return final[2].position.x() - final[1].position.x() - 0.2;
    };
    CHECK(gap_of_last() == Approx(0).margin(1e-15));
    method.order = ContactOrder::jacobi;
    CHECK(gap_of_last() == Approx(-d / 2));
}

TEST_CASE("A projection off one wall into another is seen in the same pass, not under jacobi", "[stepping]")
{
    // A wedge: pushed up from the floor, the ball comes into the slanted wall above it.
    const Scene scene =
        scene_of({ball(0.1, Vec3(0, 0, 0.05))}, {wall(Vec3::UnitZ(), 0), wall(Vec3(0.6, 0, -0.8), -0.15)});
    const auto height = [](const Vec3& p) { return 0.6 * p.x() - 0.8 * p.z() + 0.15 - 0.1; };
    PositionBased method{steps(0.01)};
    CHECK(height(scene.spheres[0].position) > 0);
    CHECK(height(run_discrete(scene, method, until(0.01)).final[0].position) == Approx(0).margin(1e-15));
    method.order = ContactOrder::jacobi;
    CHECK(height(run_discrete(scene, method, until(0.01)).final[0].position) == Approx(-0.03));
}

TEST_CASE("The order jacobi is refused by methods that do not have it", "[stepping]")
{
    StepOptions options = steps(0.01);
    options.order = ContactOrder::jacobi;
    const Scene scene = scene_of({ball(0.1, Vec3::Zero())});
    for (const Method& method : all_discrete(options)) {
        CAPTURE(name(method));
        const Outcome outcome = run_discrete(scene, method, until(0.1));
        const bool is_pbd = name(method) == "pbd";
        CHECK((outcome.status == Status::reached_end) == is_pbd);
        if (!is_pbd) CHECK(outcome.message.find("jacobi") != std::string::npos);
    }
}
