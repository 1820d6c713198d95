/// \file
/// Everything an event-driven run knows at a moment: one flight a body, and the constants of the scene in the form the
/// run needs.
#pragma once

#include "contact/numeric_cluster.hpp"
#include "contact/persistent_contacts.hpp"
#include "contact/recent_impacts.hpp"
#include "contact/series.hpp"
#include "flight/flight.hpp"
#include "impact/contact_laws.hpp"

#include <carom/features.hpp>
#include <carom/simulate.hpp>

#include <memory>
#include <unordered_map>
#include <vector>

namespace carom {

/// A flight of mode numeric: one step of a numeric cluster, or a window of the guard.
struct Piece {
    EpochTime end;
    Vec3 end_velocity = Vec3::Zero();  ///< in a window of the guard: that at its end [length/time]
    /// Of which the body is one, as the step began, and the step; null in a window of the guard.
    std::shared_ptr<const NumericCluster> cluster;
    std::shared_ptr<const NumericStep> step;
    int index = 0;  ///< of the body in the cluster
    Place centre;   ///< to which the cluster's positions are relative
};

/// Two contacts whose gaps close within this fraction of the radius belong to one instant, unless the scene says
/// otherwise.
inline constexpr double default_tie = 1e-12;

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
    std::unordered_map<BodyId, Piece> pieces;   ///< of the bodies whose mode is numeric, nobody else
    PersistentContacts contacts;                ///< of the bodies whose support is several_supports
    RecentImpacts recent;                       ///< of contacts with e < 1
    bool loses_energy;                          ///< some e < 1
    /// v_c tau_p / 4, the height of a rebound of v_c that lasts tau_p: smaller gaps are closed as far as impacts are
    /// concerned where a contact closed less than tau_p ago (this project; without it they close one after the other,
    /// ever again, as Gauss and Seidel would have it). 0 where all e = 1 or policy contact does not hold, and in
    /// certified runs [length].
    double rebound_gap;

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
    /// The law of a contact of sphere `a` with `b`, a sphere or a plane.
    const ContactLaw& law(BodyId a, BodyId b) const
    {
        const int material = sphere(a).material;
        return is_plane(b) ? laws.plane(material, plane(plane_index(b)).material)
                           : laws.spheres(material, sphere(b).material);
    }
    /// Contacts with gaps up to this belong to the instant of another [length]. \param radius the smaller one
    double tie(double radius) const { return scene.impact.tie.value_or(default_tie) * radius; }
    /// Does a contact with this gap belong to the instant `now` of another? If it closed less than tau_p ago it does up
    /// to rebound_gap. \param a a sphere \param b another one, or a plane
    bool ties(BodyId a, BodyId b, double gap, const EpochTime& now) const
    {
        if (gap <= tie(is_plane(b) ? radius(a) : std::min(radius(a), radius(b)))) return true;
        return gap <= rebound_gap && recent.has(a, b, now);
    }
};

}  // namespace carom
