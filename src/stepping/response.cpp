#include "stepping/response.hpp"

namespace carom::stepping {

namespace {

bool is_wall(const Bodies& bodies, const Contact& c)
{
    return c.b >= static_cast<BodyId>(bodies.size());
}
std::size_t index(BodyId body)
{
    return static_cast<std::size_t>(body);
}

Vec3 relative_velocity(const Bodies& bodies, const Contact& c)
{
    const Vec3& va = bodies.velocity[index(c.a)];
    return is_wall(bodies, c) ? va : Vec3(va - bodies.velocity[index(c.b)]);
}

Impulse respond_at_wall(Bodies& bodies, const Contact& c, const ContactLaw& law)
{
    Vec3& v = bodies.velocity[index(c.a)];
    const double mass = bodies.mass[index(c.a)];
    const double vn = v.dot(c.normal);
    const Vec3 before = v;
    if (law.tangential == 1) {
        v -= ((1 + law.restitution) * vn) * c.normal;
    } else {
        v = law.tangential * (v - vn * c.normal) - (law.restitution * vn) * c.normal;
    }
    return {mass * (v - before), -(1 + law.restitution) * mass * vn};
}

Impulse respond_between_spheres(Bodies& bodies, const Contact& c, const ContactLaw& law)
{
    const Vec3 v = relative_velocity(bodies, c);
    const double mass = effective_mass(bodies, c);
    const double vn = v.dot(c.normal);
    const double j = -(1 + law.restitution) * mass * vn;
    Vec3 impulse = j * c.normal;
    if (law.tangential < 1) impulse -= ((1 - law.tangential) * mass) * (v - vn * c.normal);
    apply(bodies, c, impulse);
    if (law.attenuation != 1) {
        bodies.velocity[index(c.a)] *= law.attenuation;
        bodies.velocity[index(c.b)] *= law.attenuation;
    }
    return {impulse, j};
}

}  // namespace

double effective_mass(const Bodies& bodies, const Contact& c)
{
    if (is_wall(bodies, c)) return bodies.mass[index(c.a)];
    return 1 / (bodies.inverse_mass[index(c.a)] + bodies.inverse_mass[index(c.b)]);
}

void apply(Bodies& bodies, const Contact& c, const Vec3& impulse)
{
    bodies.velocity[index(c.a)] += bodies.inverse_mass[index(c.a)] * impulse;
    if (!is_wall(bodies, c)) bodies.velocity[index(c.b)] -= bodies.inverse_mass[index(c.b)] * impulse;
}

Impulse damp(Bodies& bodies, const Contact& c, const ContactLaw& law)
{
    Impulse impulse;
    if (law.tangential < 1) {
        const Vec3 v = relative_velocity(bodies, c);
        impulse.on_a = ((law.tangential - 1) * effective_mass(bodies, c)) * (v - v.dot(c.normal) * c.normal);
        apply(bodies, c, impulse.on_a);
    }
    if (law.attenuation != 1 && !is_wall(bodies, c)) {
        bodies.velocity[index(c.a)] *= law.attenuation;
        bodies.velocity[index(c.b)] *= law.attenuation;
    }
    return impulse;
}

double normal_velocity(const Bodies& bodies, const Contact& contact)
{
    return relative_velocity(bodies, contact).dot(contact.normal);
}

const ContactLaw& law_of(const Bodies& bodies, const LawTable& laws, const Contact& contact)
{
    const int material = bodies.material[index(contact.a)];
    if (is_wall(bodies, contact)) return laws.plane(material, index(contact.b) - bodies.size());
    return laws.spheres(material, bodies.material[index(contact.b)]);
}

Impulse respond(Bodies& bodies, const LawTable& laws, const Contact& contact)
{
    const ContactLaw& law = law_of(bodies, laws, contact);
    return is_wall(bodies, contact) ? respond_at_wall(bodies, contact, law)
                                    : respond_between_spheres(bodies, contact, law);
}

Impulse cancel_normal(Bodies& bodies, const Contact& contact)
{
    const double j = -effective_mass(bodies, contact) * normal_velocity(bodies, contact);
    const Vec3 impulse = j * contact.normal;
    apply(bodies, contact, impulse);
    return {impulse, j};
}

}  // namespace carom::stepping
