#include <carom/error.hpp>
#include <carom/features.hpp>

#include "scene/tolerances.hpp"

#include <array>

namespace carom {

namespace {

constexpr std::array<Kernel, 3> list{{
    {"single", {.gravity = true, .pairs = false}, "broad phase, pair tests, stamps and queue"},
    {"uniform", {.gravity = false, .pairs = true}, "accelerations: every motion is uniform, every plane root linear"},
    {"general", {.gravity = true, .pairs = true}, "nothing"},
}};

std::string missing(const Features& kernel, const Features& needed)
{
    std::string text;
    if (needed.gravity && !kernel.gravity) text += "gravity";
    if (needed.pairs && !kernel.pairs) text += std::string(text.empty() ? "" : " and ") + "pairs of spheres";
    return text;
}

}  // namespace

BroadPhase automatic_broad_phase(std::size_t spheres)
{
    return spheres <= all_pairs_limit ? BroadPhase::all_pairs : BroadPhase::cell_grid;
}

Features needs(const Scene& scene)
{
    return {.gravity = !scene.gravity.isZero(0), .pairs = scene.spheres.size() > 1};
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
