/// \file
/// Everything an event-driven run knows at a moment: one flight a body, and the constants of the scene in the form the
/// run needs.
#pragma once

#include "contact/series.hpp"
#include "flight/flight.hpp"
#include "impact/contact_laws.hpp"

#include <carom/features.hpp>
#include <carom/simulate.hpp>

#include <unordered_map>
#include <vector>

namespace carom {

struct State {
    /// \param certified keep the low parts of places
    explicit State(const Scene& scene, bool certified = false);

    const Scene& scene;
    Frame frame;
    Accelerations accelerations;
    ContactLaws laws;
    RestThresholds rest;

    std::vector<double> radii;    ///< by body [length]
    std::vector<Flight> flights;  ///< by body
    /// By body: its flight's place is Place plus this, exactly. Empty unless the run is certified; 0 for whoever does
    /// not fly freely [length].
    std::vector<Vec3> low;
    std::vector<std::uint32_t> stamps;  ///< by body: grows with each change of its flight; 0 = as the scene began
    std::unordered_map<BodyId, Series> series;  ///< of the bodies whose mode says so, nobody else

    const Sphere& sphere(BodyId body) const { return scene.spheres[static_cast<std::size_t>(body)]; }
    const Plane& plane(int p) const { return scene.planes[static_cast<std::size_t>(p)]; }
    const Flight& flight(BodyId body) const { return flights[static_cast<std::size_t>(body)]; }
    /// 0 for a fixed sphere [1/mass]
    double inverse_mass(BodyId body) const { return is_fixed(body) ? 0 : 1 / sphere(body).mass; }
    bool is_fixed(BodyId body) const { return flight(body).mode == Mode::fixed; }
    double radius(BodyId body) const { return radii[static_cast<std::size_t>(body)]; }
    BodyId count() const { return static_cast<BodyId>(flights.size()); }
    bool certified() const { return !low.empty(); }
    bool is_plane(BodyId body) const { return body >= count(); }
    int plane_index(BodyId body) const { return body - count(); }
};

/// Two contacts whose gaps close within this fraction of the radius belong to one instant.
inline constexpr double tie_fraction = 1e-12;

}  // namespace carom
