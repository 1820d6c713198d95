/// \file
/// Features that a scene needs of an engine, and those that each compiled kernel has. A scene runs on the first kernel
/// of the list that covers its needs, so it pays for nothing that it does not use. All kernels give the same events,
/// bit for bit.
#pragma once

#include <carom/method.hpp>
#include <carom/scene.hpp>

#include <span>
#include <string_view>

namespace carom {

struct Features {
    bool gravity = false;  ///< accelerations, series, quartics
    bool pairs = false;    ///< more than one sphere: broad phase, pair tests, stamps, queue
    bool drag = false;     ///< linear drag: flights that are damped

    friend constexpr bool operator==(const Features&, const Features&) = default;
};

/// The features that a scene needs: a pure function of the data.
Features needs(const Scene& scene);

/// Whether a kernel with features `kernel` runs a scene that needs `needed`.
constexpr bool covers(const Features& kernel, const Features& needed)
{
    return (kernel.gravity || !needed.gravity) && (kernel.pairs || !needed.pairs) && (kernel.drag || !needed.drag);
}

struct Kernel {
    std::string_view name;
    Features features;
    std::string_view leaves_out;  ///< for people
};

/// The kernels, cheapest first; the last one covers everything.
std::span<const Kernel> kernels();

/// The kernel called `forced`, or the first that covers the scene if `forced` is empty.
/// \throws InputError if there is no kernel of that name or it lacks what the scene needs
const Kernel& choose_kernel(const Scene& scene, std::string_view forced = {});

/// The choice of `BroadPhase::automatic` for discrete methods: all pairs for few spheres, a cell grid for many. \param
/// spheres their number
BroadPhase automatic_broad_phase(std::size_t spheres);

/// The choice for event-driven runs, from number, radii and density: all pairs for few spheres; lists of neighbours for
/// many of like size that are close to each other; else a cell grid.
BroadPhase event_broad_phase(const Scene& scene);

/// Part of the box around all spheres that they fill [1].
double packing_fraction(const Scene& scene);

}  // namespace carom
