#include "generated/generate.hpp"

#include "support/random.hpp"
#include "support/scenes.hpp"

#include <array>
#include <cmath>
#include <functional>

namespace carom::test {

namespace {

constexpr double end = 2;

/// What kinds are put together from.
class Builder {
public:
    explicit Builder(std::uint64_t seed) : random(seed)
    {
        scene.end_time = end;
        scene.materials.clear();
    }

    void gravity() { scene.gravity = earth; }

    /// `count` materials called m0, m1, ..: restitutions up to `most`, some exactly 0; a third with a tangential
    /// factor.
    void materials(int count, double most)
    {
        for (int k = 0; k < count; ++k) {
            Material m;
            m.name = "m" + std::to_string(k);
            m.restitution = random.integer(0, 5) == 0 ? 0 : random.uniform(0, most);
            m.tangential = random.integer(0, 2) == 0 ? random.uniform(0.5, 1) : 1;
            scene.materials.push_back(m);
        }
    }

    int any_material() { return random.integer(0, static_cast<int>(scene.materials.size()) - 1); }

    void plane(const Vec3& normal, const Vec3& point)
    {
        Plane p;
        p.id = "plane-" + std::to_string(scene.planes.size());
        p.normal = normal.normalized();
        p.offset = p.normal.dot(point);
        p.material = any_material();
        scene.planes.push_back(p);
    }

    /// Walls of [0, x] x [0, y] x [0, z]; floor and lid where asked for.
    void walls(const Vec3& size, bool floor, bool lid)
    {
        for (int axis = 0; axis < 3; ++axis) {
            if (axis < 2 || floor) plane(Vec3::Unit(axis), Vec3::Zero());
            if (axis < 2 || lid) plane(-Vec3::Unit(axis), size);
        }
    }

    void sphere(double radius, const Vec3& position, const Vec3& velocity, double mass)
    {
        add_sphere(scene, radius, position, velocity, mass);
        scene.spheres.back().material = any_material();
    }

    bool is_free(double radius, const Vec3& position) const
    {
        for (const Sphere& s : scene.spheres)
            if ((s.position - position).norm() < 1.0001 * (s.radius + radius)) return false;
        for (const Plane& p : scene.planes)
            if (p.normal.dot(position) - p.offset < 1.0001 * radius) return false;
        return true;
    }

    /// Up to `count` spheres at free places of [0, size], at speeds up to `speed`.
    void scatter(int count, const Vec3& size, double r_min, double r_max, double speed,
                 const std::function<double(double)>& mass)
    {
        for (int tries = 0; count > 0 && tries < 4000; ++tries) {
            const double r = random.log_uniform(r_min, r_max);
            const double x = random.uniform(0, size.x()), y = random.uniform(0, size.y());
            const Vec3 p(x, y, random.uniform(0, size.z()));
            if (!is_free(r, p)) continue;
            const Vec3 v = random.in_cube(speed);
            sphere(r, p, v, mass(r));
            --count;
        }
    }

    /// Some of a cubic lattice, `gap` between surfaces, its lowest layer `gap` above the floor z = 0.
    void lattice(int across, int up, double radius, const std::function<double()>& gap, double share)
    {
        const double mass = radius * radius * radius;
        std::array<std::vector<double>, 3> at;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double x = axis < 2 ? 0.5 : radius + gap();
            for (int k = 0; k < (axis < 2 ? across : up); ++k) {
                at[axis].push_back(x);
                x += 2 * radius + gap();
            }
        }
        for (const double z : at[2])
            for (const double y : at[1])
                for (const double x : at[0]) {
                    const Vec3 v = random.integer(0, 4) == 0 ? random.in_cube(1) : Vec3::Zero();
                    if (random.uniform(0, 1) < share || scene.spheres.empty()) sphere(radius, {x, y, z}, v, mass);
                }
    }

    Random random;
    Scene scene;
};

double volume(double r)
{
    return 1000 * r * r * r;
}

void dense(Builder& b)
{
    b.gravity();
    b.materials(1, 0.95);
    const Vec3 size(0.5, 0.5, 0.6);
    b.walls(size, true, false);
    const int count = b.random.integer(15, 40);
    b.scatter(count, size, 0.05, 0.08, 1, volume);
}

void inelastic(Builder& b)
{
    b.materials(2, 0.4);
    const Vec3 size = Vec3::Constant(b.random.uniform(0.5, 1));
    b.walls(size, true, true);
    const int count = b.random.integer(5, 40);
    b.scatter(count, size, 0.03, 0.06, 2, volume);
}

void inclined(Builder& b)
{
    b.gravity();
    b.materials(2, 0.9);
    const Vec3 size(1, 1, 1);
    b.walls(size, false, false);
    const double tilt = b.random.uniform(0.05, 1.2), turn = b.random.uniform(0, 6.28);
    b.plane({std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt)}, {0.5, 0.5, 0});
    const int count = b.random.integer(2, 30);
    b.scatter(count, {1, 1, 1.5}, 0.03, 0.08, 1, volume);
}

/// A bowl of 3 to 6 slopes, from flat to narrow.
void cornered(Builder& b)
{
    b.gravity();
    b.materials(2, 0.9);
    const int slopes = b.random.integer(3, 6);
    const double steep = b.random.uniform(0.2, 1.35), first = b.random.uniform(0, 6.28);
    for (int k = 0; k < slopes; ++k) {
        const double turn = first + 6.283185307179586 * k / slopes + b.random.uniform(-0.2, 0.2);
        b.plane({std::sin(steep) * std::cos(turn), std::sin(steep) * std::sin(turn), std::cos(steep)}, {0.5, 0.5, 0});
    }
    const int count = b.random.integer(1, 25);
    b.scatter(count, {1, 1, 2}, 0.03, 0.08, 1, volume);
    for (int tries = 0; b.scene.spheres.empty() && tries < 10; ++tries) b.sphere(0.05, {0.5, 0.5, 2}, {0, 0, -1}, 1);
}

void touching(Builder& b)
{
    b.gravity();
    b.materials(1, 0.9);
    b.walls({2, 2, 2}, true, false);
    const int across = b.random.integer(1, 4), up = b.random.integer(2, across > 2 ? 3 : 8);
    b.lattice(
        across, up, 0.0625, [] { return 0.0; }, b.random.coin() ? 1 : 0.7);
}

void tiny_gaps(Builder& b)
{
    b.gravity();
    b.materials(1, 0.9);
    b.walls({2, 2, 2}, true, false);
    const int across = b.random.integer(1, 4), up = b.random.integer(2, across > 2 ? 3 : 8);
    b.lattice(
        across, up, 0.06, [&] { return 0.06 * b.random.log_uniform(1e-12, 1e-3); }, b.random.coin() ? 1 : 0.7);
}

void mass_ratios(Builder& b)
{
    if (b.random.integer(0, 3) > 0) b.gravity();
    b.materials(2, 0.95);
    const Vec3 size = Vec3::Constant(b.random.uniform(0.6, 1));
    b.walls(size, true, true);
    const int count = b.random.integer(2, 30);
    b.scatter(count, size, 0.02, 0.1, 2, [&](double) { return b.random.log_uniform(3e-5, 3e4); });
}

/// Fixed spheres to fall on, many materials, some elastic contacts, rules for two materials.
void mixed(Builder& b)
{
    b.gravity();
    b.materials(4, 1);
    b.scene.materials[1].restitution = 1;
    const Vec3 size(0.8, 0.8, 0.8);
    b.walls(size, true, false);
    b.scatter(b.random.integer(1, 8), size, 0.05, 0.15, 0, volume);
    for (Sphere& s : b.scene.spheres) s.fixed = true;
    const int count = b.random.integer(3, 25);
    b.scatter(count, size, 0.03, 0.08, 1.5, volume);
    if (b.random.coin()) b.scene.contacts.push_back({0, 2, b.random.uniform(0, 1), b.random.uniform(0.5, 1), {}});
    b.scene.materials[0].restitution = b.random.uniform(0, 0.5);
}

/// The same scene of smaller grains. The kinds are drawn with radii of centimetres: pebbles, which roll for seconds.
/// What people simulate is powder to gravel. Under gravity times shrink by sqrt(factor), so that most of them come to
/// rest.
void resize(Scene& scene, double factor)
{
    const double speeds = scene.gravity.isZero(0) ? factor : std::sqrt(factor);
    for (Sphere& s : scene.spheres) {
        s.radius *= factor;
        s.position *= factor;
        s.velocity *= speeds;
        s.mass *= factor * factor * factor;
    }
    for (Plane& p : scene.planes) p.offset *= factor;
}

struct Kind {
    const char* name;
    void (*build)(Builder&);
};
constexpr std::array<Kind, 8> kinds{{{"dense", dense},
                                     {"inelastic", inelastic},
                                     {"inclined", inclined},
                                     {"cornered", cornered},
                                     {"touching", touching},
                                     {"tiny_gaps", tiny_gaps},
                                     {"mass_ratios", mass_ratios},
                                     {"mixed", mixed}}};

}  // namespace

GeneratedScene generate_scene(std::uint64_t seed, std::uint64_t index)
{
    constexpr std::uint64_t spread = 0x9e3779b97f4a7c15;  // 2^64 / golden ratio: neighbours get seeds far apart
    const Kind& kind = kinds[index % kinds.size()];
    for (std::uint64_t attempt = 0;; ++attempt) {
        Builder builder((seed * spread + index) * spread + attempt);
        kind.build(builder);
        resize(builder.scene, builder.random.log_uniform(0.0005, 0.05));
        builder.scene.name = std::string(kind.name) + " " + std::to_string(seed) + "/" + std::to_string(index);
        bool moves = false;
        for (const Sphere& s : builder.scene.spheres) moves = moves || !s.fixed;
        constexpr std::uint64_t most_attempts = 100;  // a scene that is not valid is a bug of this file: it is shown
        if ((moves && validate(builder.scene).empty()) || attempt == most_attempts)
            return {kind.name, std::move(builder.scene)};
    }
}

}  // namespace carom::test
