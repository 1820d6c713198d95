/// \file
/// Spheres and planes as the integrator knows them, and the change of velocity in one contact.
#pragma once

#include <carom/scene.hpp>

#include "reference/flight.hpp"
#include "reference/prefilter.hpp"

#include <optional>

namespace carom::reference {

template <class Real>
struct Ball {
    Real radius, mass;
    Flight<Real> flight;
    Shadow shadow;
    Real fastest = 0;              ///< largest of its speeds so far (as `size` takes it)
    Real next = 0;                 ///< its earliest event, not later than the end
    BodyId partner = no_body;      ///< with whom; itself: its step ends; no_body: none
    std::ptrdiff_t series = -1;    ///< index of the Zeno series it is in; -1: none
    std::optional<Real> step_end;  ///< until when its flight holds, if it is a step of constrained motion
    bool supported = false;        ///< it has a persistent contact
    bool fixed;
    Real drag;  ///< of the field [1/time]

    Ball(const Sphere& s, const Field<Real>& field) : radius(s.radius), mass(s.mass), fixed(s.fixed), drag(field.drag)
    {
        shadow.radius = s.radius;
        const Vector<Real> a = fixed ? Vector<Real>() : field.gravity;
        follow({0, Vector<Real>(s.position), Vector<Real>(s.velocity), a, {}, drag}, std::nullopt);
    }

    /// New velocity and acceleration at time t.
    void fly(const Real& t, const Vector<Real>& v, const Vector<Real>& a)
    {
        follow({t, flight.position(t), v, a, {}, drag}, std::nullopt);
    }

    void follow(Flight<Real> path, const std::optional<Real>& end)
    {
        flight = std::move(path);
        step_end = end;
        fastest = std::max<Real>(fastest, size(flight.v));
        Real wander = 0, power = 1;
        if (end) {
            for (int k = 0; k < 3; ++k) power *= *end - flight.t;
            for (const Vector<Real>& c : flight.higher) wander += size(c) * power, power *= *end - flight.t;
        }
        shadow = {static_cast<double>(flight.t),
                  shadow.radius,
                  flight.x.rounded(),
                  flight.v.rounded(),
                  flight.a.rounded(),
                  static_cast<double>(wander),
                  static_cast<double>(flight.drag)};
    }
};

/// The side of a plane that a sphere sees: gap = n.x - offset. A stored normal is used as it is, not normalised.
template <class Real>
struct Face {
    Vector<Real> n;
    Real offset;

    Face(const Plane& p, const Ball<Real>& ball) : n(p.normal), offset(p.offset)
    {
        if (p.thickness && dot(n, ball.flight.x) < offset) {
            n = n * Real(-1);
            offset = -offset;
        }
        offset += Real(p.thickness.value_or(0)) / 2 + ball.radius;
    }
    Real gap(const Vector<Real>& x) const { return dot(n, x) - offset; }
};

/// The part of v along r. Dividing by r.r keeps energy exactly, whatever the length of r.
template <class Real>
Vector<Real> along(const Vector<Real>& v, const Vector<Real>& r)
{
    return r * (dot(v, r) / dot(r, r));
}

/// The coefficients between a sphere and another body.
inline ContactLaw contact_law(const Scene& scene, BodyId a, BodyId b)
{
    const auto spheres = static_cast<BodyId>(scene.spheres.size());
    const int material = scene.spheres[a].material;
    return b < spheres ? sphere_contact_law(scene, material, scene.spheres[b].material)
                       : plane_contact_law(scene, material, scene.planes[b - spheres].material);
}

/// Change of the relative velocity v, negative, in a contact with normal r: (1+e) of v_n and (1-alpha) of v_t.
template <class Real>
Vector<Real> velocity_change(const Vector<Real>& v, const Vector<Real>& r, const ContactLaw& law)
{
    const Vector<Real> v_n = along(v, r);
    return v_n * (1 + Real(law.restitution)) + (v - v_n) * (1 - Real(law.tangential));
}

}  // namespace carom::reference
