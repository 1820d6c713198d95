#include <carom/error.hpp>
#include <carom/features.hpp>

#include "scene/tolerances.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace carom {

namespace {

constexpr std::array<Kernel, 4> list{{
    {"single", {.gravity = true, .pairs = false}, "broad phase, pair tests, stamps and queue"},
    {"uniform", {.gravity = false, .pairs = true}, "accelerations: every motion is uniform, every plane root linear"},
    {"general", {.gravity = true, .pairs = true}, "drag: every flight is a parabola"},
    {"damped", {.gravity = true, .pairs = true, .drag = true}, "nothing"},
}};

std::string missing(const Features& kernel, const Features& needed)
{
    std::string text;
    const auto add = [&](bool is_missing, std::string_view what) {
        if (is_missing) text.append(text.empty() ? "" : " and ").append(what);
    };
    add(needed.gravity && !kernel.gravity, "gravity");
    add(needed.pairs && !kernel.pairs, "pairs of spheres");
    add(needed.drag && !kernel.drag, "drag");
    return text;
}

}  // namespace

BroadPhase automatic_broad_phase(std::size_t spheres)
{
    return spheres <= all_pairs_limit ? BroadPhase::all_pairs : BroadPhase::cell_grid;
}

double packing_fraction(const Scene& scene)
{
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    double volume = 0;
    for (const Sphere& s : scene.spheres) {
        low = low.cwiseMin(s.position - Vec3::Constant(s.radius));
        high = high.cwiseMax(s.position + Vec3::Constant(s.radius));
        volume += sphere_volume * s.radius * s.radius * s.radius;
    }
    return scene.spheres.empty() ? 0 : volume / (high - low).prod();
}

BroadPhase event_broad_phase(const Scene& scene)
{
    const BroadPhase plain = automatic_broad_phase(scene.spheres.size());
    if (plain == BroadPhase::all_pairs) return plain;
    const auto [smallest, largest] =
        std::minmax_element(scene.spheres.begin(), scene.spheres.end(),
                            [](const Sphere& a, const Sphere& b) { return a.radius < b.radius; });
    const bool alike = largest->radius <= alike_radii * smallest->radius;
    return alike && packing_fraction(scene) >= least_fraction_for_lists ? BroadPhase::neighbour_lists : plain;
}

Features needs(const Scene& scene)
{
    return {.gravity = !scene.gravity.isZero(0), .pairs = scene.spheres.size() > 1, .drag = scene.drag > 0};
}

std::span<const Kernel> kernels()
{
    return list;
}

const Kernel& choose_kernel(const Scene& scene, std::string_view forced)
{
    const Features needed = needs(scene);
    std::string names;
    for (const Kernel& kernel : list) {
        if (forced.empty() && covers(kernel.features, needed)) return kernel;
        if (forced == kernel.name) {
            if (covers(kernel.features, needed)) return kernel;
            throw InputError({"kernel \"" + std::string(forced) + "\" has no " + missing(kernel.features, needed) +
                              ", which this scene needs (leave the choice to carom)"});
        }
        names += (names.empty() ? "" : ", ") + std::string(kernel.name);
    }
    throw InputError({"unknown kernel \"" + std::string(forced) + "\" (there are: " + names + ")"});
}

}  // namespace carom
