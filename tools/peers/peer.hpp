/// \file
/// Another engine on a scene of carom: what all of them share.
#pragma once

#include <carom/scene.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace carom::peers {

struct Settings {
    double dt = 1.0 / 240;            ///< step [time]
    bool defaults = false;            ///< as the engine comes, instead of what suits hard spheres best
    bool ccd = false;                 ///< continuous detection for spheres that go further than their radius in a step
    std::optional<int> iterations;    ///< of the solver
    std::optional<double> reduction;  ///< part of an overlap that a step takes away
};

class Engine {
public:
    virtual ~Engine() = default;
    /// One step of Settings::dt.
    virtual void step() = 0;
    virtual Vec3 place(std::size_t sphere) const = 0;
    virtual Vec3 velocity(std::size_t sphere) const = 0;
    /// Name, version, precision, and every setting that matters, in words.
    virtual std::string words() const = 0;
};

/// \throws std::invalid_argument for a scene with drag, which none of the engines has as carom means it
void expect_no_drag(const Scene& scene);

/// Made by each engine's own file.
std::unique_ptr<Engine> make_engine(const Scene& scene, const Settings& settings);

/// Restitution of a material. Of two bodies in contact the smaller one holds, which engines must be told; overrides of
/// the scene for two materials, and tangential factors, have no counterpart in them and are left out.
double restitution_of(const Scene& scene, int material);

}  // namespace carom::peers
