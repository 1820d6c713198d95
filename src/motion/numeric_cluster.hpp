/// \file
/// Bodies in contacts that carry force while their normals turn: no closed form, integrated in small steps.
#pragma once

#include "contact/contact.hpp"

#include <limits>
#include <span>
#include <variant>
#include <vector>

namespace carom {

/// A body of a cluster. Its position is relative to a point near the cluster.
struct NumericBody {
    Vec3 position = Vec3::Zero();  ///< [length]
    Vec3 velocity = Vec3::Zero();  ///< [length/time]
    double inverse_mass = 1;       ///< > 0 [1/mass]
};

/// Partner of a body of the cluster in a contact: another one, or what does not move.
struct ClusterBody {
    int body = 0;
};
struct FixedSphere {
    Vec3 centre = Vec3::Zero();  ///< [length]
};
struct FixedPlane {
    Vec3 normal = Vec3::Zero();  ///< unit to rounding
};

/// A persistent contact.
struct NumericContact {
    int a = 0;
    std::variant<ClusterBody, FixedSphere, FixedPlane> partner;
    double reach = 0;  ///< r_a + r_b, or the height of the centre along the normal of a plane, when closed [length]
    double force = 0;  ///< a guess of what it carries, which saves time [mass length/time^2]

    std::optional<int> b() const
    {
        const auto* moving = std::get_if<ClusterBody>(&partner);
        return moving ? std::optional(moving->body) : immovable;
    }
    double gap(std::span<const NumericBody> bodies) const;  ///< [length]
};

struct NumericCluster {
    std::vector<NumericBody> bodies;
    std::vector<NumericContact> contacts;
    Vec3 gravity = Vec3::Zero();  ///< [length/time^2]
    double drag = 0;              ///< k of linear drag [1/time]
    double opening = 0;           ///< a contact opens at gap rates (d2 gap/dt2) above this, > 0 [length/time^2]
    /// Steps are halved, some times, until places would differ by no more than this if the accelerations of one middle
    /// stage were those of the other [length]
    double agreement = std::numeric_limits<double>::infinity();
};

/// One step of the classical Runge-Kutta method of order 4 with the complementarity problem of the contact forces at
/// each stage, then gaps and closing rates of contacts that carry force put back to 0 (both: this project; the
/// formulation is that of Baraff 1989 without friction). The error of a step is of order h^5 while no contact opens.
struct NumericStep {
    double duration = 0;                    ///< up to `h`, or less: until a contact that carried force opens [time]
    std::vector<NumericBody> bodies;        ///< at its end
    std::vector<NumericBody> integrated;    ///< before gaps and rates were put back: where the motion leads smoothly
    std::vector<Vec3> start_accelerations;  ///< by body, without drag [length/time^2]
    std::vector<Vec3> end_accelerations;    ///< by body, without drag [length/time^2]
    std::vector<double> forces;             ///< by contact, mean over the step [mass length/time^2]
    double correction = 0;                  ///< energy that putting back took [energy]
    /// Contacts that carry and open within a millionth of h. A step from here would find them again and again: they are
    /// to be left out, and the step to be made anew.
    std::vector<std::size_t> opened;
};
/// The step that the cluster makes. The first moment at which a contact opens is found by false position. \param h > 0,
/// its length at most [time]
NumericStep numeric_step(const NumericCluster& cluster, double h);

/// The cluster within its step: velocities by Hermite's cubic through velocities and accelerations at both ends, exact
/// to h^4, places by its integral, exact to h^5 (dense output: Hairer, Norsett and Wanner, Solving Ordinary
/// Differential Equations I, section II.6; places at both ends would be divided by h, which may be as short as
/// rounding); contacts that carry put back as at the end. \param t from 0 to the duration [time]
std::vector<NumericBody> within_step(const NumericCluster& cluster, const NumericStep& step, double t);
/// One body within the step, before gaps and rates are put back.
NumericBody within_step(const NumericCluster& cluster, const NumericStep& step, std::size_t body, double t);

}  // namespace carom
