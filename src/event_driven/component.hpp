/// \file
/// Bodies connected by contacts that are closed at one instant.
#pragma once

#include "contact/contact.hpp"
#include "event_driven/resolve.hpp"

namespace carom {

/// Of sphere `a`, which can move, and `b`: a sphere or a plane. Of two that can move a < b.
struct Touch {
    BodyId a = no_body, b = no_body;
    Vec3 normal = Vec3::Zero();  ///< unit to rounding, from b to a
    double gap = 0;              ///< [length]
    bool persistent = false;     ///< it was closed before this instant
};

/// A component of the graph whose nodes are bodies that can move and whose edges are contacts: those in persistent
/// contact, and those that close at this instant. Fixed spheres and planes link nothing.
struct ContactComponent {
    std::vector<BodyId> bodies;   ///< ascending
    std::vector<Flight> flights;  ///< of `bodies`, as if they began at this instant
    std::vector<Touch> contacts;  ///< ascending by a, then b
    std::vector<Touch> opened;    ///< persistent ones that have opened on the way, by more than the gap tolerance

    /// Position in `bodies`, or `immovable` for what is none of them.
    std::optional<int> index_of(BodyId body) const;
    const Flight& flight_of(BodyId body) const { return flights[static_cast<std::size_t>(*index_of(body))]; }
};

/// The component of the bodies of an event. \param contact its key: a contact of its own, closed at this instant, if it
/// is one of an impact
ContactComponent gather(const State& state, const Key& contact, const Neighbourhood& neighbourhood);

/// Components of the contacts that a scene declares, gap within 1e-9 r: those that are more than one sphere on one
/// plane.
std::vector<ContactComponent> declared_components(const State& state);

/// Contacts and velocities in the form that operators take, every restitution as the materials have it.
ContactProblem cluster_of(const State& state, const ContactComponent& component);

/// Contact of two bodies, of which `a` can move, at these flights of one instant. \param fb null for a plane
Touch touch(const State& state, BodyId a, const Flight& fa, BodyId b, const Flight* fb);

/// An event of a contact; of two spheres the smaller id is the event's a. \param impulse on the touch's a
Event event_between(EventKind kind, const Touch& touch, const Vec3& impulse);

/// Gaps up to this count as closed where a contact persists [length].
double persistence_gap(const State& state, BodyId a, BodyId b);

}  // namespace carom
