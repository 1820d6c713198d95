/// \file
/// Everything an event-driven run knows at a moment: the motions of its bodies, which contacts closed lately, and the
/// constants of the scene in the form the run needs.
#pragma once

#include "contact/contact_laws.hpp"
#include "contact/recent_impacts.hpp"
#include "motion/bodies.hpp"
#include "motion/run_tolerances.hpp"

#include <carom/simulate.hpp>

namespace carom {

struct State {
    State(const Scene& scene, Precision precision);

    const Scene& scene;
    const Precision precision;
    const Frame frame;
    const ContactLaws laws;
    const RestThresholds rest;
    const double drag;  ///< k of the scene; above 0 every motion is damped, pieces included [1/time]
    const Tolerances tolerances;
    const bool loses_energy;  ///< some e < 1
    /// Gap up to which a contact that closed less than tau_p ago counts as closed when another one closes [length]: v_c
    /// tau_p / 4, the height of a rebound of v_c (this project; without it the contacts of a cluster close one after
    /// the other without end). 0 where all e = 1, under other policies than contact, and in certified runs.
    const double rebound_gap;

    Bodies bodies;
    RecentImpacts recent;  ///< of contacts with e < 1

    bool certified() const { return precision == Precision::certified; }
    BodyId count() const { return bodies.count(); }
    const Sphere& sphere(BodyId body) const { return scene.spheres[static_cast<std::size_t>(body)]; }
    const Plane& plane(int p) const { return scene.planes[static_cast<std::size_t>(p)]; }
    int planes() const { return static_cast<int>(scene.planes.size()); }
    double radius(BodyId body) const { return bodies.radius(body); }
    const Flight& flight(BodyId body) const { return bodies.flight(body); }
    const Vec3& acceleration(const Flight& flight) const { return bodies.acceleration(flight); }
    /// Gravity of the scene [length/time^2].
    const Vec3& gravity() const { return bodies.accelerations()[bodies.accelerations().free()]; }

    bool is_fixed(BodyId body) const { return bodies.kind(body) == MotionKind::fixed; }
    bool is_fixed(Partner partner) const { return partner.is_sphere() && is_fixed(partner.index); }
    bool is_movable(Partner partner) const { return partner.is_sphere() && !is_fixed(partner.index); }
    /// Inverse mass; 0 for bodies that do not move [1/mass].
    double inverse_mass(BodyId body) const { return is_fixed(body) ? 0 : 1 / sphere(body).mass; }
    double inverse_mass(Partner partner) const { return partner.is_sphere() ? inverse_mass(partner.index) : 0; }
    /// The smaller radius of a contact [length].
    double smaller_radius(BodyId a, Partner b) const
    {
        return b.is_sphere() ? std::min(radius(a), radius(b.index)) : radius(a);
    }
    const ContactLaw& law(BodyId a, Partner b) const
    {
        const int material = sphere(a).material;
        return b.is_sphere() ? laws.spheres(material, sphere(b.index).material)
                             : laws.plane(material, plane(b.index).material);
    }

    /// The number of a partner in events, and the partner with a number.
    BodyId body_of(Partner partner) const { return partner.is_sphere() ? partner.index : count() + partner.index; }
    Partner partner_of(BodyId body) const
    {
        return body < count() ? Partner::sphere(body) : Partner::plane(body - count());
    }

    /// Largest gap at which a contact belongs to the instant of another [length]. \param radius the smaller one
    double tie(double radius) const { return tolerances.tie * radius; }
    /// Height of a bounce that rounding of its place ends [length]. \param radius the smaller one
    double lowest_bounce(double radius) const { return rest_height * (radius + frame.cell_size); }
    /// Largest gap at which any contact of the body belongs to the instant of another one [length].
    double widest_tie(BodyId body) const { return std::max(rebound_gap, tie(radius(body))); }
};

}  // namespace carom
