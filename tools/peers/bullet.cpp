/// \file
/// Bullet (bulletphysics.org), double precision, its sequential impulse solver.
///
/// Set for hard spheres: contacts from touch on (by default from 0.02 before it, and what is left of the gap is taken
/// from the bounce), no threshold on restitution (by default slow closings do not bounce), 50 iterations (10), overlap
/// left as it is (a ball that is lifted out of the floor at every bounce gains height), no damping, no sleep, no
/// friction, the smaller restitution of two bodies (Bullet multiplies them).
#include "peer.hpp"
#include "plates.hpp"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <sstream>

namespace carom::peers {

namespace {

constexpr int tuned_iterations = 50;
/// Margin of a box at most, as Bullet has it by default [length].
constexpr double usual_margin = 0.04;

btVector3 vector(const Vec3& v)
{
    return {v[0], v[1], v[2]};
}

Vec3 vector(const btVector3& v)
{
    return {v.x(), v.y(), v.z()};
}

btScalar smaller(const btCollisionObject* a, const btCollisionObject* b)
{
    return std::min(a->getRestitution(), b->getRestitution());
}

class Bullet final : public Engine {
public:
    Bullet(const Scene& scene, const Settings& settings)
        : settings_(settings),
          dispatcher_(&configuration_),
          world_(&dispatcher_, &broad_phase_, &solver_, &configuration_)
    {
        world_.setGravity(vector(scene.gravity));
        btContactSolverInfo& info = world_.getSolverInfo();
        if (!settings.defaults) {
            gCalculateCombinedRestitutionCallback = smaller;
            gContactBreakingThreshold = 0;
            info.m_erp2 = 0;
            info.m_restitutionVelocityThreshold = 0;
            info.m_numIterations = tuned_iterations;
        }
        if (settings.iterations) info.m_numIterations = *settings.iterations;
        if (settings.reduction) info.m_erp2 = *settings.reduction;
        for (const Sphere& sphere : scene.spheres) add(scene, sphere);
        for (const Plane& plane : scene.planes) add(scene, plane);
    }
    ~Bullet() override
    {
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }

    void step() override { world_.stepSimulation(settings_.dt, 0); }
    Vec3 place(std::size_t i) const override { return vector(bodies_[i]->getWorldTransform().getOrigin()); }
    Vec3 velocity(std::size_t i) const override { return vector(bodies_[i]->getLinearVelocity()); }
    std::string words() const override
    {
        // The world's own getter is not const.
        const btContactSolverInfo& info = const_cast<btDiscreteDynamicsWorld&>(world_).getSolverInfo();
        std::ostringstream text;
        text << "Bullet " << btGetVersion() / 100 << '.' << btGetVersion() % 100 << ", double precision, "
             << (settings_.defaults ? "defaults" : "tuned") << ": iterations " << info.m_numIterations
             << ", contacts from a gap of " << gContactBreakingThreshold << " (of a size) on, restitution threshold "
             << info.m_restitutionVelocityThreshold << ", split impulse " << (info.m_splitImpulse != 0 ? "on" : "off")
             << ", erp2 " << info.m_erp2 << ", restitution " << (settings_.defaults ? "multiplied" : "the smaller one")
             << ", friction " << (settings_.defaults ? "0.5" : "0") << ", damping 0, sleep "
             << (settings_.defaults ? "on" : "off") << ", CCD "
             << (settings_.ccd ? "beyond a radius a step, swept 0.9 r" : "off");
        return text.str();
    }

private:
    void add_body(double mass, std::unique_ptr<btCollisionShape> shape, const btTransform& at, double restitution)
    {
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shape->calculateLocalInertia(mass, inertia);
        auto body = std::make_unique<btRigidBody>(
            btRigidBody::btRigidBodyConstructionInfo(mass, nullptr, shape.get(), inertia));
        body->setWorldTransform(at);
        body->setInterpolationWorldTransform(at);
        body->setRestitution(restitution);
        if (!settings_.defaults) {
            body->setFriction(0);
            body->setActivationState(DISABLE_DEACTIVATION);
        }
        world_.addRigidBody(body.get());
        shapes_.push_back(std::move(shape));
        bodies_.push_back(std::move(body));
    }
    void add(const Scene& scene, const Sphere& sphere)
    {
        btTransform at = btTransform::getIdentity();
        at.setOrigin(vector(sphere.position));
        add_body(sphere.fixed ? 0 : sphere.mass, std::make_unique<btSphereShape>(sphere.radius), at,
                 restitution_of(scene, sphere.material));
        bodies_.back()->setLinearVelocity(vector(sphere.velocity));
        if (!settings_.ccd) return;
        bodies_.back()->setCcdMotionThreshold(sphere.radius);
        bodies_.back()->setCcdSweptSphereRadius(0.9 * sphere.radius);
    }
    void add(const Scene& scene, const Plane& plane)
    {
        const double e = restitution_of(scene, plane.material);
        if (!plane.thickness) {
            add_body(0, std::make_unique<btStaticPlaneShape>(vector(plane.normal), plane.offset),
                     btTransform::getIdentity(), e);
            bodies_.back()->getCollisionShape()->setMargin(0);
            return;
        }
        const PlateBox plate = plate_box(scene, plane);
        auto box = std::make_unique<btBoxShape>(btVector3(plate.edge, plate.edge, plate.half));
        // The margin lies inside the box and must be thinner than it.
        box->setMargin(std::min(plate.half / 2, usual_margin));
        const btTransform at(shortestArcQuat(btVector3(0, 0, 1), vector(plane.normal)), vector(plate.middle));
        add_body(0, std::move(box), at, e);
    }

    Settings settings_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broad_phase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace

std::unique_ptr<Engine> make_engine(const Scene& scene, const Settings& settings)
{
    return std::make_unique<Bullet>(scene, settings);
}

}  // namespace carom::peers
