/// \file
/// ODE, the Open Dynamics Engine (ode.org), double precision, its direct solver (dWorldStep, Lemke's method).
///
/// Set for hard spheres: no error reduction (ERP 0: what overlaps is left; with ERP the correction becomes velocity,
/// and a cradle gains energy), CFM 0, no threshold on bounces, no friction, no damping, no sleep. By default ERP is 0.2
/// and CFM 1e-10.
#include "peer.hpp"
#include "plates.hpp"

#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace carom::peers {

namespace {

/// Contacts of two geometries: a sphere has one with anything convex.
constexpr int most_contacts = 4;

class Ode final : public Engine {
public:
    Ode(const Scene& scene, const Settings& settings) : scene_(scene), settings_(settings)
    {
        dInitODE();
        world_ = dWorldCreate();
        space_ = dHashSpaceCreate(nullptr);
        contacts_ = dJointGroupCreate(0);
        dWorldSetGravity(world_, scene.gravity[0], scene.gravity[1], scene.gravity[2]);
        if (!settings.defaults) {
            dWorldSetERP(world_, 0);
            dWorldSetCFM(world_, 0);
        }
        if (settings.reduction) dWorldSetERP(world_, *settings.reduction);
        if (settings.iterations) dWorldSetQuickStepNumIterations(world_, *settings.iterations);
        for (const Sphere& sphere : scene.spheres) add(sphere);
        for (const Plane& plane : scene.planes) add(plane);
    }
    ~Ode() override
    {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
        dCloseODE();
    }

    void step() override
    {
        dSpaceCollide(space_, this, [](void* self, dGeomID a, dGeomID b) { static_cast<Ode*>(self)->meet(a, b); });
        if (settings_.iterations)
            dWorldQuickStep(world_, settings_.dt);
        else
            dWorldStep(world_, settings_.dt);
        dJointGroupEmpty(contacts_);
    }
    Vec3 place(std::size_t i) const override { return vector(dGeomGetPosition(spheres_[i])); }
    Vec3 velocity(std::size_t i) const override
    {
        const dBodyID body = dGeomGetBody(spheres_[i]);
        return body != nullptr ? vector(dBodyGetLinearVel(body)) : Vec3(Vec3::Zero());
    }
    std::string words() const override
    {
        std::ostringstream text;
        text << "ODE, double precision, " << (settings_.defaults ? "defaults" : "tuned") << ": ";
        if (settings_.iterations)
            text << "quick step, iterations " << *settings_.iterations;
        else
            text << "direct solver";
        text << ", ERP " << dWorldGetERP(world_) << ", CFM " << dWorldGetCFM(world_)
             << ", bounce threshold 0, friction 0, damping 0, sleep off, restitution the smaller one, CCD none";
        return text.str();
    }

private:
    static Vec3 vector(const dReal* v) { return {v[0], v[1], v[2]}; }

    void add(const Sphere& sphere)
    {
        const dGeomID geom = dCreateSphere(space_, sphere.radius);
        if (!sphere.fixed) {
            const dBodyID body = dBodyCreate(world_);
            dMass mass;
            dMassSetSphereTotal(&mass, sphere.mass, sphere.radius);
            dBodySetMass(body, &mass);
            dBodySetLinearVel(body, sphere.velocity[0], sphere.velocity[1], sphere.velocity[2]);
            dGeomSetBody(geom, body);
        }
        dGeomSetPosition(geom, sphere.position[0], sphere.position[1], sphere.position[2]);
        keep(geom, sphere.material);
        spheres_.push_back(geom);
    }
    void add(const Plane& plane)
    {
        if (!plane.thickness) {
            keep(dCreatePlane(space_, plane.normal[0], plane.normal[1], plane.normal[2], plane.offset), plane.material);
            return;
        }
        const PlateBox plate = plate_box(scene_, plane);
        const dGeomID box = dCreateBox(space_, 2 * plate.edge, 2 * plate.edge, 2 * plate.half);
        dMatrix3 rotation;
        dRFromZAxis(rotation, plane.normal[0], plane.normal[1], plane.normal[2]);
        dGeomSetRotation(box, rotation);
        dGeomSetPosition(box, plate.middle[0], plate.middle[1], plate.middle[2]);
        keep(box, plane.material);
    }
    void keep(dGeomID geom, int material)
    {
        restitution_.push_back(restitution_of(scene_, material));
        dGeomSetData(geom, reinterpret_cast<void*>(restitution_.size() - 1));
    }
    double restitution(dGeomID geom) const { return restitution_[reinterpret_cast<std::size_t>(dGeomGetData(geom))]; }

    void meet(dGeomID a, dGeomID b)
    {
        if (dGeomGetBody(a) == nullptr && dGeomGetBody(b) == nullptr) return;
        std::array<dContact, most_contacts> contacts{};
        const int count = dCollide(a, b, most_contacts, &contacts[0].geom, sizeof(dContact));
        for (int k = 0; k < count; ++k) {
            dContact& contact = contacts[static_cast<std::size_t>(k)];
            contact.surface.mode = dContactBounce;
            contact.surface.mu = 0;
            contact.surface.bounce = std::min(restitution(a), restitution(b));
            contact.surface.bounce_vel = 0;
            dJointAttach(dJointCreateContact(world_, contacts_, &contact), dGeomGetBody(a), dGeomGetBody(b));
        }
    }

    const Scene& scene_;
    Settings settings_;
    dWorldID world_;
    dSpaceID space_;
    dJointGroupID contacts_;
    std::vector<dGeomID> spheres_;
    std::vector<double> restitution_;  ///< by geometry
};

}  // namespace

std::unique_ptr<Engine> make_engine(const Scene& scene, const Settings& settings)
{
    return std::make_unique<Ode>(scene, settings);
}

}  // namespace carom::peers
