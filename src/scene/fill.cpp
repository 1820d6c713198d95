#include "scene/fill.hpp"

#include "core/expect.hpp"
#include "core/random.hpp"
#include "scene/fill_patterns.hpp"

namespace carom {

namespace {

// Each purpose draws from a stream of its own: other radii do not move the directions.
enum class Purpose : std::uint64_t { radius, position, direction, count };

std::uint64_t stream_of(const FillSpec& fill, Purpose purpose)
{
    return fill.stream * static_cast<std::uint64_t>(Purpose::count) + static_cast<std::uint64_t>(purpose);
}

struct DrawRadius {
    Random& random;
    double operator()(double radius) const { return radius; }
    double operator()(const UniformRadius& range) const { return random.uniform(range.min, range.max); }
    double operator()(const ChoiceRadius& choice) const { return choice.values[random.below(choice.values.size())]; }
};

std::vector<double> draw_radii(const FillSpec& fill, std::uint64_t seed)
{
    Random random(seed, stream_of(fill, Purpose::radius));
    std::vector<double> radii(fill.count);
    for (double& r : radii) r = std::visit(DrawRadius{random}, fill.radius);
    return radii;
}

struct PlaceAll {
    const FillSpec& fill;
    const std::vector<double>& radii;
    const Scene& scene;
    Patience& patience;
    template <class SomePattern>
    Places operator()(const SomePattern& pattern) const
    {
        return place(pattern, radii);
    }
    Places operator()(const RandomPattern& pattern) const
    {
        return place(pattern, radii, scene, stream_of(fill, Purpose::position), patience);
    }
};

}  // namespace

double sphere_mass(double density, double radius)
{
    constexpr double four_thirds_pi = 4.1887902047863909846;
    return density * four_thirds_pi * radius * radius * radius;
}

Filled expand_fill(const FillSpec& fill, const Scene& scene)
{
    Patience endless;
    return expand_fill(fill, scene, endless);
}

Filled expand_fill(const FillSpec& fill, const Scene& scene, Patience& patience)
{
    CAROM_EXPECT(fill.count >= 1);
    const std::vector<double> radii = draw_radii(fill, scene.seed);
    const Places places = std::visit(PlaceAll{fill, radii, scene, patience}, fill.pattern);
    Filled filled;
    filled.problem = places.problem;
    if (!filled.problem.empty() || patience.ended()) return filled;
    Random random(scene.seed, stream_of(fill, Purpose::direction));
    filled.spheres.reserve(fill.count);
    for (std::size_t k = 0; k < fill.count && patience.lasts_for(1); ++k) {
        Sphere s;
        s.id = fill.id + "/" + std::to_string(k);
        s.radius = radii[k];
        s.mass = fill.density ? sphere_mass(*fill.density, s.radius) : fill.mass;
        s.position = places.centres[k];
        s.velocity = fill.velocity;
        if (fill.speed > 0) s.velocity += fill.speed * random.direction();
        s.material = fill.material;
        s.color = fill.color;
        s.fixed = fill.fixed;
        filled.spheres.push_back(std::move(s));
    }
    return filled;
}

}  // namespace carom
