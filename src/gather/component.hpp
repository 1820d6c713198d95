/// \file
/// Bodies connected by contacts that are closed at one instant.
#pragma once

#include "contact/contact.hpp"
#include "gather/may_touch.hpp"
#include "queue/key.hpp"

namespace carom {

/// A component of the graph whose nodes are bodies that can move and whose edges are contacts: those in persistent
/// contact, and those that close at this instant. Fixed spheres and planes link nothing.
struct ContactComponent {
    /// Bodies ascending, with the velocities of now; contacts ascending by a, then by partner, with the laws of their
    /// materials.
    ContactProblem problem;
    std::vector<Flight> flights;  ///< by body, as if they began at this instant
    std::vector<Contact> opened;  ///< persistent ones that have opened on the way, by more than the gap tolerance
    bool is_heap = false;         ///< thresholds of rest hold, see gather/heap.hpp

    BodyId id(std::size_t body) const { return problem.bodies[body].id; }
    BodyId id_of_a(const Contact& contact) const { return id(static_cast<std::size_t>(contact.a)); }
};

/// The component of the bodies of an event. \param contact its key: a contact of its own, closed at this instant, if it
/// is one of an impact
ContactComponent gather(const State& state, const Key& contact, const Neighbourhood& neighbourhood);

/// Components of the contacts that a scene declares, gap within 1e-9 r: those that are more than one sphere on one
/// plane.
std::vector<ContactComponent> declared_components(const State& state);

/// Normal, gap and law of two bodies, of which `a` can move, at flights of one instant. The contact's indices of bodies
/// in a problem are left open.
Contact sphere_contact(const State& state, BodyId a, const Flight& fa, BodyId b, const Flight& fb);
Contact plane_contact(const State& state, BodyId a, const Flight& fa, int plane);

/// A contact as it was found, by the bodies' ids.
struct FoundContact {
    BodyId a = no_body;
    Contact contact{};
};
/// Makes a problem of bodies and contacts that were found: bodies in the order given, ascending, contacts in theirs.
void number_bodies(const State& state, const std::vector<std::pair<BodyId, Flight>>& bodies,
                   std::vector<FoundContact> contacts, ContactComponent& out);

/// Largest gap that counts as closed for a persistent contact [length].
double persistence_gap(const State& state, BodyId a, Partner b);

}  // namespace carom
