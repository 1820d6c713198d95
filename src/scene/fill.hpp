/// \file
/// Fills: many spheres from a few numbers. A fill is plain data; `expand_fill` turns it into spheres, the same ones bit
/// for bit with every compiler.
#pragma once

#include <carom/scene.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace carom {

/// An axis-parallel box that bounds surfaces, not centres.
struct Region {
    Vec3 min = Vec3::Zero(), max = Vec3::Zero();  ///< min < max on each axis [length]
};

struct UniformRadius {
    double min = 0, max = 0;  ///< 0 < min <= max [length]
};
struct ChoiceRadius {
    std::vector<double> values;  ///< not empty, each > 0 and equally likely [length]
};
using RadiusSpec = std::variant<double, UniformRadius, ChoiceRadius>;

/// A row: centres from `origin` along `axis`, neighbours `gap` apart at their surfaces.
struct LinePattern {
    Vec3 origin = Vec3::Zero();  ///< first centre [length]
    Vec3 axis = Vec3::UnitX();   ///< unit
    double gap = 0;              ///< >= 0 [length]
};
/// Rows of 1, 2, 3 .. along `axis`, each centred across it (across = axis x z): the rack of billiards. One radius only.
struct TrianglePattern {
    Vec3 origin = Vec3::Zero();  ///< centre of the first sphere [length]
    Vec3 axis = Vec3::UnitX();   ///< unit, not along z
    double gap = 0;              ///< >= 0, between neighbours' surfaces [length]
};
/// The lattice with the widest spacing that has enough sites in the region, stretched to fit it; x runs fastest.
struct CubicPattern {
    Region region;
};
/// Random sequential insertion: uniform places in the region, one after the other, those that touch anything drawn
/// again.
struct RandomPattern {
    Region region;
};
using Pattern = std::variant<LinePattern, TrianglePattern, CubicPattern, RandomPattern>;

struct FillSpec {
    std::string id;  ///< prefix: sphere k is "ID/k"
    Pattern pattern;
    std::size_t count = 0;          ///< >= 1
    RadiusSpec radius = 1.0;        ///< [length]
    double mass = 1;                ///< > 0, of each sphere [mass]
    std::optional<double> density;  ///< in place of mass [mass/length^3]
    Vec3 velocity = Vec3::Zero();   ///< of all [length/time]
    double speed = 0;               ///< >= 0, added in a random direction of each sphere's own [length/time]
    int material = 0;               ///< index into Scene::materials
    std::string color;              ///< CSS colour; empty: that of the material
    bool fixed = false;             ///< never move; then velocity and speed are 0
    std::uint64_t stream = 0;       ///< which random numbers: the fill's index in its scene
};

struct Filled {
    std::vector<Sphere> spheres;
    std::string problem;  ///< "/key: what is wrong (the cure)", empty if all went well
};

/// \pre the numbers of `fill` are in range. Uses seed, spheres and planes of `scene`: random places avoid both.
Filled expand_fill(const FillSpec& fill, const Scene& scene);

/// Mass of a ball: density 4/3 pi r^3.
double sphere_mass(double density, double radius);

}  // namespace carom
