/// \file
/// The motion of spheres in a substep of length h, and where contacts come in: the one place that knows an integrator.
#pragma once

#include "stepping/bodies.hpp"
#include "stepping/damped_times.hpp"
#include "stepping/substep_track.hpp"

#include <carom/method.hpp>

#include <vector>

namespace carom::stepping {

/// A method whose contacts come after the motion calls `fly`. One whose contacts act on velocities first calls
/// `accelerate`, then changes velocities, then calls one of the two that move; which one says what the changes were.
/// With Integrator::euler the two are the same, p += h v, after v += h (g - k v).
///
/// With Integrator::parabola flight is p += h v + h^2 g / 2, which is h times the mean of the velocities at both ends.
/// With drag k it is p += s v + q g, v += s (g - k v) (damped_times.hpp), as exact, and the mean has weights 1 - w and
/// w = q / (s h), which are 1/2 each without drag. Contacts in between make the end v_end differ from that of flight:
/// - `move_pushed` takes the change for that of a force that lasts all the substep: p += h times the mean of v and
///   v_end. What rests (v = v_end = 0) stays, what slides on a plane slides on an exact parabola. A bounce must not be
///   among the changes: the mean of the velocities before and after it is none that the sphere ever had. It belongs
///   before `accelerate`.
/// - `move_struck` takes it for that of impulses at the beginning: p += h v_end for those that got one, so that a gap
///   that was to shrink at v_end shrinks by h v_end, and what rests stays. What slides loses the bend of its path,
///   h^2 g / 2 a substep.
/// (Neither is p += h v_end - h^2 g / 2 for all: that is exact in flight too, but lifts what rests by h^2 g / 2.)
class FreeMotion {
public:
    FreeMotion(const Vec3& gravity, double drag, Integrator integrator)
        : gravity_(gravity), drag_(drag), integrator_(integrator)
    {
    }

    void fly(Bodies& bodies, double h);
    void accelerate(Bodies& bodies, double h);
    void move_pushed(Bodies& bodies, double h);
    void move_struck(Bodies& bodies, double h);

    /// The form of a leapfrog, for contacts that act on the velocities with which a substep is made: kick_before,
    /// change velocities, drift, kick_after. With Integrator::euler all of gravity comes before; with
    /// Integrator::parabola half comes before and half after, so that the velocities in between are the mean ones and
    /// flight is exact.
    void kick_before(Bodies& bodies, double h);
    void drift(Bodies& bodies, double h);
    void kick_after(Bodies& bodies, double h);

    /// A kick in two parts, between which other forces may act for the time that gravity does: drag, which is that of
    /// the velocities so far, and gravity. \return that time, 0 if there is no kick
    double resist_before(Bodies& bodies, double h);
    double resist_after(Bodies& bodies, double h);
    void fall_before(Bodies& bodies, double time);
    void fall_after(Bodies& bodies, double time) const;

    Integrator integrator() const { return integrator_; }
    const Vec3& gravity() const { return gravity_; }  ///< [length/time^2]
    double drag() const { return drag_; }             ///< k >= 0 [1/time]
    SubstepTrack& track() { return track_; }

private:
    void resist(Bodies& bodies, double time);
    /// \param w weight of the velocity at the end of the substep, `weight_of_end`
    Vec3 mean_velocity(const Bodies& bodies, std::size_t i, double w) const;
    double weight_of_end(double h);  ///< 1/2 without drag
    /// Those of a substep: computed anew where its length is another than that of the one before.
    const DampedTimes& times_of(double h);
    /// Remember how the spheres, which are still where the substep began, are about to move.
    void remember(const Bodies& bodies, double h, bool struck);
    void remember_drift(const Bodies& bodies);

    Vec3 gravity_;
    double drag_;
    Integrator integrator_;
    double known_length_ = 0;  ///< of the substep that `known_times_` are of [time]
    DampedTimes known_times_;
    SubstepTrack track_;
    std::vector<Vec3> start_;  ///< velocities before gravity, for Integrator::parabola and the track
    std::vector<Vec3> free_;   ///< velocities after it, before contacts
    std::vector<Vec3> lost_;   ///< velocities lost to drag in the last `resist`; none without drag
};

}  // namespace carom::stepping
