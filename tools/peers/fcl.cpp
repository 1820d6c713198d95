/// \file
/// FCL's continuous collision detection (fcl::continuousCollide) as contestants.
///
/// The request's defaults are the first variant of each. Left out is what does not work in FCL 0.7: CCDC_RAY_SHOOTING
/// always reports free; CCDM_SCREW sees wrong contacts for pure translations; half-spaces and planes crash. CCDM_LINEAR
/// reads a reference point that its constructor leaves uninitialised, and misses what the memory happens to say: linear
/// motions are made here, with the constructor that is given one.
#include "tools/peers/steps.hpp"

#include "tunnel/peers.hpp"

#include <fcl/fcl.h>

#include <array>
#include <memory>

namespace carom::tunnel {

namespace {

static_assert(alignof(fcl::Transform3d) == 16, "FCL is built with Eigen's alignment (cmake/Peers.cmake sets it)");

enum class Path : std::uint8_t { translation, linear };

struct Setting {
    const char* variant;
    Path path;
    fcl::GJKSolverType solver;
};
constexpr std::array<Setting, 4> settings{{{"translation, libccd", Path::translation, fcl::GST_LIBCCD},
                                           {"translation, indep", Path::translation, fcl::GST_INDEP},
                                           {"linear, libccd", Path::linear, fcl::GST_LIBCCD},
                                           {"linear, indep", Path::linear, fcl::GST_INDEP}}};

std::shared_ptr<fcl::CollisionGeometryd> geometry(const PeerScene& scene)
{
    if (scene.target == Target::sphere) return std::make_shared<fcl::Sphered>(scene.thickness / 2);
    // Its normal is x, as that of every throw.
    return std::make_shared<fcl::Boxd>(scene.thickness, plate_edge(scene), plate_edge(scene));
}

/// Motion of a body that does not turn. (Shared, for the library's own delete frees what another new has made.)
std::shared_ptr<fcl::MotionBased> motion(Path path, const Vec3& from, const Vec3& to)
{
    const fcl::Matrix3d upright = fcl::Matrix3d::Identity();
    if (path == Path::linear)
        return std::make_shared<fcl::InterpMotion<double>>(upright, from, upright, to,
                                                           fcl::Vector3d(fcl::Vector3d::Zero()));
    return std::make_shared<fcl::TranslationMotion<double>>(upright, from, to);
}

Flown fly(const Throw& t, double dt, std::int64_t steps, const fcl::ContinuousCollisionRequestd& request, Path path)
{
    const PeerScene scene = peer_scene(t, dt);
    const fcl::Sphered ball(scene.radius);
    const std::shared_ptr<fcl::CollisionGeometryd> target = geometry(scene);
    const std::shared_ptr<fcl::MotionBased> still = motion(path, scene.middle, scene.middle);
    const auto query = [&](const Vec3& from, const Vec3& velocity, double length) -> std::optional<double> {
        const std::shared_ptr<fcl::MotionBased> moving = motion(path, from, from + length * velocity);
        fcl::ContinuousCollisionResultd result;
        fcl::continuousCollide(&ball, moving.get(), target.get(), still.get(), request, result);
        if (!result.is_collide) return {};
        return result.time_of_contact * length;
    };
    return fly_in_steps(t, dt, steps, scene, query);
}

void add(Peers& peers, const char* name, fcl::CCDSolverType solver, std::optional<double> chords)
{
    peers.names.emplace_back(name);
    for (const Setting& setting : settings) {
        fcl::ContinuousCollisionRequestd request;
        request.ccd_solver_type = solver;
        request.gjk_solver_type = setting.solver;
        Contestant who;
        who.method = name;
        who.variant = setting.variant;
        who.chords_seen = chords;
        who.fly = [request, path = setting.path](const Throw& t, double dt, std::int64_t steps) {
            return fly(t, dt, steps, request, path);
        };
        peers.contestants.push_back(std::move(who));
    }
}

}  // namespace

Peers fcl_peers()
{
    // Naive: the ball is looked at in num_max_iterations = 10 places, both ends among them, and seen on both sides of
    // the middle: two chords for each of nine parts of a step.
    constexpr double parts = 9;
    Peers peers;
    add(peers, "fcl_naive", fcl::CCDC_NAIVE, 2 * parts);
    add(peers, "fcl_advancement", fcl::CCDC_CONSERVATIVE_ADVANCEMENT, std::numeric_limits<double>::infinity());
    return peers;
}

}  // namespace carom::tunnel
