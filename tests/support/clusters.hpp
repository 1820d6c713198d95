/// \file
/// Clusters of contacts for tests and benchmarks: those of the literature, and random ones with what an impact owes
/// them.
#pragma once

#include "impact/resolve_cluster.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace carom::test {

/// Bodies on the x axis, each touching the next.
inline ContactProblem row(const std::vector<double>& masses, const std::vector<double>& speeds, double e = 1)
{
    ContactProblem out;
    for (std::size_t i = 0; i < masses.size(); ++i) {
        out.bodies.push_back({Vec3(speeds[i], 0, 0), 1 / masses[i]});
        if (i > 0) out.contacts.push_back({static_cast<int>(i) - 1, static_cast<int>(i), Vec3(-1, 0, 0), e, 1});
    }
    return out;
}

/// Five equal balls, the first k come in at speed 1.
inline ContactProblem cradle(int k, double e = 1)
{
    std::vector<double> speeds(5, 0.0);
    for (int i = 0; i < k; ++i) speeds[static_cast<std::size_t>(i)] = 1;
    return row(std::vector<double>(5, 1.0), speeds, e);
}

/// A ball at speed 1 hits two touching ones symmetrically.
inline ContactProblem bernoulli(double e)
{
    const double half_root_3 = std::sqrt(3.0) / 2;
    ContactProblem out;
    out.bodies = {{Vec3(1, 0, 0), 1}, {Vec3::Zero(), 1}, {Vec3::Zero(), 1}};
    out.contacts = {{0, 1, Vec3(-half_root_3, -0.5, 0), e, 1},
                    {0, 2, Vec3(-half_root_3, 0.5, 0), e, 1},
                    {1, 2, Vec3(0, 1, 0), e, 1}};
    return out;
}

/// Equal discs at places of the plane, of diameter 1, all at rest; those that touch are in contact.
inline ContactProblem discs(const std::vector<Vec3>& places)
{
    ContactProblem out;
    for (std::size_t i = 0; i < places.size(); ++i) {
        out.bodies.push_back({Vec3::Zero(), 1});
        for (std::size_t j = 0; j < i; ++j) {
            const Vec3 between = places[i] - places[j];
            if (between.norm() > 1 + 1e-9) continue;
            out.contacts.push_back({static_cast<int>(i), static_cast<int>(j), between.normalized(), 1, 1});
        }
    }
    return out;
}

/// Fifteen in a triangle and the cue ball on its axis, which comes in at speed 1; the cue is body 0. Ball (row, place).
inline ContactProblem rack_of_15()
{
    std::vector<Vec3> places{Vec3(-1, 0, 0)};
    for (int r = 0; r < 5; ++r)
        for (int k = 0; k <= r; ++k) places.emplace_back(r * std::sqrt(3.0) / 2, k - r / 2.0, 0);
    ContactProblem out = discs(places);
    out.bodies.front().velocity = Vec3(1, 0, 0);
    return out;
}

/// n balls at rest on a floor, one on the other, and one that comes down at speed 1.
inline ContactProblem hit_tower(int n)
{
    ContactProblem out;
    for (int i = 0; i <= n; ++i) {
        out.bodies.push_back({Vec3(0, 0, i == n ? -1 : 0), 1});
        out.contacts.push_back({i, i == 0 ? immovable : std::optional(i - 1), Vec3(0, 0, 1), 1, 1});
    }
    return out;
}

/// A ball of mass 1 onto one of mass 2 that rests on the floor.
inline ContactProblem onto_resting()
{
    ContactProblem out;
    out.bodies = {{Vec3(0, 0, -1), 1}, {Vec3::Zero(), 0.5}};
    out.contacts = {{0, 1, Vec3(0, 0, 1), 1, 1}, {1, immovable, Vec3(0, 0, 1), 1, 1}};
    return out;
}

/// A sphere that touches two planes of interior angle `angle` [rad], given by its half's sine and cosine.
inline ContactProblem wedge(double cosine, double sine, const Vec3& velocity)
{
    ContactProblem out;
    out.bodies = {{velocity, 1}};
    out.contacts = {{0, immovable, Vec3(cosine, sine, 0), 1, 1}, {0, immovable, Vec3(-cosine, sine, 0), 1, 1}};
    return out;
}

/// A sphere between two parallel planes that touch it, moving slantwise.
inline ContactProblem pinched()
{
    ContactProblem out;
    out.bodies = {{Vec3(1, 0.5, 0), 1}};
    out.contacts = {{0, immovable, Vec3(1, 0, 0), 1, 1}, {0, immovable, Vec3(-1, 0, 0), 1, 1}};
    return out;
}

/// Equal spheres in a box, side x side in a layer, each on three of the four below it, normals a little off the
/// lattice's: some three contacts a sphere, like a settled pile.
inline ContactProblem pile(int side, int layers)
{
    constexpr double disorder = 0.1;
    carom::Random random(3);
    const double layer_height = std::sqrt(0.5);
    ContactProblem out;
    std::vector<Vec3> places;
    for (int z = 0; z < layers; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                places.emplace_back(x + (z % 2) * 0.5, y + (z % 2) * 0.5, z * layer_height);
                out.bodies.push_back({Vec3::Zero(), 1});
            }
    const auto touches = [&out](int a, std::optional<int> b, const Vec3& n) {
        out.contacts.push_back({a, b, n.normalized(), 1, 1});
    };
    for (int i = 0; i < static_cast<int>(places.size()); ++i) {
        const int x = i % side, y = i / side % side, z = i / side / side;
        if (x == 0) touches(i, immovable, Vec3::UnitX());
        if (x == side - 1) touches(i, immovable, -Vec3::UnitX());
        if (y == 0) touches(i, immovable, Vec3::UnitY());
        if (y == side - 1) touches(i, immovable, -Vec3::UnitY());
        if (z == 0) touches(i, immovable, Vec3::UnitZ());
        const auto missing = static_cast<int>(random.below(4));
        for (int k = 0; k < 4 && z > 0; ++k) {
            const int u = x + k % 2 - 1 + z % 2, v = y + k / 2 - 1 + z % 2;
            if (k == missing || u < 0 || v < 0 || u >= side || v >= side) continue;
            const int below = ((z - 1) * side + v) * side + u;
            const Vec3 between = places[static_cast<std::size_t>(i)] - places[static_cast<std::size_t>(below)];
            touches(i, below, between.normalized() + disorder * random.direction());
        }
    }
    return out;
}

struct RandomClusters {
    int most_contacts = 40;
    double mass_ratio = 1e6;
    double share_jammed = 0.25;
};

/// Connected, in 1 to 3 dimensions, with random normals (no geometry), mixed restitution, some contacts with immovable
/// bodies; a share of them has a body held between two opposite normals.
inline ContactProblem random_cluster(carom::Random& random, const RandomClusters& options)
{
    const auto dimensions = 1 + random.below(3);
    const auto contacts = 1 + random.below(static_cast<std::size_t>(options.most_contacts));
    const auto bodies = 1 + random.below(contacts);
    const double restitution = random.uniform();
    const auto mixture = random.below(4);  // 0: all elastic, 1: one e, else mixed
    const auto direction = [&] {
        Vec3 n = random.direction();
        for (std::size_t k = dimensions; k < 3; ++k) n[static_cast<int>(k)] = 0;
        return n.squaredNorm() > 1e-6 ? Vec3(n / n.norm()) : Vec3(Vec3::UnitX());
    };
    ContactProblem out;
    for (std::size_t i = 0; i < bodies; ++i) {
        // Powers of 2 and a mantissa, as libm differs between machines.
        const int exponent =
            static_cast<int>(random.below(static_cast<std::size_t>(std::ilogb(options.mass_ratio)) + 1));
        const double speed = random.below(3) == 0 ? 0 : random.uniform(0.1, 2);
        const Vec3 velocity = speed * direction();
        out.bodies.push_back({velocity, std::ldexp(random.uniform(0.5, 1), exponent)});
    }
    const auto add = [&](std::size_t a, std::optional<int> b, const Vec3& n) {
        double e = 1;
        if (mixture == 1) e = restitution;
        if (mixture > 1) e = random.below(3) == 0 ? 1 : random.below(3) == 0 ? 0 : random.uniform();
        out.contacts.push_back({static_cast<int>(a), b, n, e, 1});
    };
    for (std::size_t i = 1; i < bodies; ++i) {
        const auto partner = static_cast<int>(random.below(i));
        add(i, partner, direction());
    }
    if (random.uniform() < options.share_jammed) {
        const auto body = random.below(bodies);
        const Vec3 n = direction();
        add(body, immovable, n);
        add(body, immovable, -n);
    }
    for (int tries = 0; tries < 10 * options.most_contacts && out.contacts.size() < contacts; ++tries) {
        const auto a = random.below(bodies);
        const auto b = random.below(bodies + 1);
        const std::optional<int> partner = b == bodies ? immovable : std::optional(static_cast<int>(b));
        const bool known = std::any_of(out.contacts.begin(), out.contacts.end(), [&](const Contact& c) {
            return (c.a == static_cast<int>(a) && c.b == partner) || (c.b == static_cast<int>(a) && c.a == partner);
        });
        if (a == b || (known && partner != immovable)) continue;
        add(a, partner, direction());
    }
    return out;
}

/// What every impact owes, relative to the largest speed or the energy before. All are 0 for perfection.
struct Debts {
    double closing = 0;   ///< of the largest speed
    double momentum = 0;  ///< of the sum of |m v|
    double energy = 0;    ///< gained, of that before
    double pull = 0;      ///< the largest impulse that pulls, of the largest impulse
};

inline Debts debts(const ContactProblem& cluster, const ClusterImpact& impact)
{
    Debts out;
    double speed = 0, energy = 0, energy_after = 0, quantity = 0;
    Vec3 before = Vec3::Zero(), after = Vec3::Zero(), from_outside = Vec3::Zero();
    for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
        const auto& [v, w, id] = cluster.bodies[i];
        speed = std::max(speed, v.norm());
        energy += v.squaredNorm() / w;
        energy_after += impact.velocities[i].squaredNorm() / w;
        before += v / w;
        after += impact.velocities[i] / w;
        quantity += v.norm() / w;
    }
    double largest = 0;
    for (std::size_t i = 0; i < cluster.contacts.size(); ++i) {
        const Contact& contact = cluster.contacts[i];
        out.closing = std::max(out.closing, -closing_rate(contact, impact.velocities) / speed);
        out.pull = std::max(out.pull, -contact.normal.dot(impact.impulses[i]));
        largest = std::max(largest, impact.impulses[i].norm());
        if (contact.b == immovable) from_outside += impact.impulses[i];
    }
    if (largest > 0) out.pull /= largest;
    if (quantity > 0) out.momentum = (after - before - from_outside).norm() / (quantity + largest);
    if (energy > 0) out.energy = energy_after / energy - 1;
    return out;
}

}  // namespace carom::test
