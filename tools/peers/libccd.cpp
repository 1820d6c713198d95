/// \file
/// Conservative advancement (Mirtich, Impulse-based dynamic simulation of rigid body systems, 1996) by libccd.
///
/// libccd 2.1 gives no distance of bodies that are apart. A ball blown up until it overlaps gives one: MPR's direction
/// of least penetration is a direction that separates, the gap along it a lower bound of the distance, and gap over
/// closing speed a time until which nothing touches.
#include "tools/peers/steps.hpp"

#include "tunnel/peers.hpp"

#include <ccd/ccd.h>

#include <limits>

namespace carom::tunnel {

namespace {

/// Rounds [1] of advancement at most: central hits take two, grazing ones some ten.
constexpr int most_rounds = 200;
/// Gap [ball's radius] that is a contact: a thousand times MPR's tolerance would be no better.
constexpr double closed = 1e-9;
/// Tolerance of MPR [ball's radius].
constexpr double mpr_tolerance = 1e-9;
/// Iterations of MPR at most: balls and boxes take some twenty.
constexpr int mpr_iterations = 1000;

struct Ball {
    Vec3 centre = Vec3::Zero();
    double radius = 0;
};
/// About the origin.
struct Box {
    Vec3 half = Vec3::Zero();
};

Vec3 farthest(const Ball& ball, const Vec3& direction)
{
    return ball.centre + (ball.radius / direction.norm()) * direction;
}
Vec3 farthest(const Box& box, const Vec3& direction)
{
    return {direction.x() < 0 ? -box.half.x() : box.half.x(), direction.y() < 0 ? -box.half.y() : box.half.y(),
            direction.z() < 0 ? -box.half.z() : box.half.z()};
}
Vec3 middle(const Ball& ball)
{
    return ball.centre;
}
Vec3 middle(const Box&)
{
    return Vec3::Zero();
}

template <class Body>
void support(const void* body, const ccd_vec3_t* direction, ccd_vec3_t* out)
{
    const Vec3 p = farthest(*static_cast<const Body*>(body), {direction->v[0], direction->v[1], direction->v[2]});
    ccdVec3Set(out, p.x(), p.y(), p.z());
}
template <class Body>
void centre(const void* body, ccd_vec3_t* out)
{
    const Vec3 p = middle(*static_cast<const Body*>(body));
    ccdVec3Set(out, p.x(), p.y(), p.z());
}

/// Time at which the ball touches the target, if it does within [0, length].
template <class Body>
std::optional<double> first_contact(Ball ball, const Vec3& velocity, double length, const Body& target)
{
    ccd_t ccd;
    CCD_INIT(&ccd);
    ccd.support1 = support<Ball>;
    ccd.center1 = centre<Ball>;
    ccd.support2 = support<Body>;
    ccd.center2 = centre<Body>;
    ccd.max_iterations = mpr_iterations;
    ccd.mpr_tolerance = mpr_tolerance * ball.radius;
    const Vec3 from = ball.centre;
    double time = 0, more = velocity.norm() * length;
    for (int round = 0; round < most_rounds; ++round) {
        ball.centre = from + time * velocity;
        const Ball blown{ball.centre, ball.radius + more};
        ccd_real_t depth = 0;
        ccd_vec3_t direction, place;
        if (ccdMPRPenetration(&blown, &target, &ccd, &depth, &direction, &place) != 0) return {};  // out of reach
        // The direction in which the target moves away from the ball [1].
        Vec3 apart(direction.v[0], direction.v[1], direction.v[2]);
        apart.normalize();
        if (apart.dot(middle(target) - ball.centre) < 0) apart = -apart;
        const double gap = apart.dot(farthest(target, -apart) - farthest(ball, apart));
        if (gap <= closed * ball.radius) return time;
        const double closing = velocity.dot(apart);
        if (!(closing > 0)) return {};
        time += gap / closing;
        if (time > length) return {};
        more = std::min(2 * gap + closed * ball.radius, velocity.norm() * (length - time) + closed * ball.radius);
        more = std::max(more, 2 * gap);
    }
    return time;
}

Flown fly(const Throw& t, double dt, std::int64_t steps)
{
    const PeerScene scene = peer_scene(t, dt);
    const Box box{{scene.thickness / 2, plate_edge(scene) / 2, plate_edge(scene) / 2}};
    const Ball still{Vec3::Zero(), scene.thickness / 2};
    return fly_in_steps(t, dt, steps, scene, [&](const Vec3& from, const Vec3& velocity, double length) {
        const Ball ball{from - scene.middle, scene.radius};
        return scene.target == Target::sphere ? first_contact(ball, velocity, length, still)
                                              : first_contact(ball, velocity, length, box);
    });
}

}  // namespace

Peers libccd_peers()
{
    Contestant who;
    who.method = "libccd_advancement";
    who.variant = "MPR";
    who.chords_seen = std::numeric_limits<double>::infinity();
    who.fly = fly;
    return {{who.method}, {who}, ""};
}

}  // namespace carom::tunnel
