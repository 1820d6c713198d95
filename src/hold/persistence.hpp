/// \file
/// Which contacts of a component persist once its impacts are over, what they carry, and what takes the speed that is
/// left in them.
#pragma once

#include "gather/component.hpp"

namespace carom {

class Persistence {
public:
    /// \param component its problem has the velocities after impacts
    Persistence(const State& state, ContactComponent component);

    const ContactComponent& component() const { return component_; }
    bool persists(std::size_t contact) const { return persists_[contact]; }
    /// Bodies that persistent contacts connect, and these contacts, as positions in the problem, ascending.
    struct Part {
        std::vector<std::size_t> bodies, contacts;
    };
    std::vector<Part> parts() const;

    /// Positions of a contact's spheres in `bodies`; `immovable` for b where it is none of them.
    int a(std::size_t contact) const { return problem().contacts[contact].a; }
    std::optional<int> b(std::size_t contact) const { return problem().contacts[contact].b; }
    double force(std::size_t contact) const { return force_[contact]; }               ///< [mass length/time^2]
    const Vec3& acceleration(std::size_t body) const { return acceleration_[body]; }  ///< [length/time^2]
    bool rests(std::size_t body) const;
    /// Does the normal turn? Then what the contact carries has no closed form.
    bool turns(std::size_t contact) const;
    double soft() const { return soft_; }  ///< with less nothing opens a contact [length/time^2]

    /// These persist no more, for good, and open from here on.
    void release(const std::vector<std::size_t>& contacts);

    /// By contact, along the normal on its `a`: what took the speed of slow contacts. Below 0 where one that opened
    /// slowly was held [mass length/time].
    const std::vector<double>& impulses() const { return impulses_; }
    double energy_taken() const { return energy_taken_; }  ///< [energy]

private:
    const ContactProblem& problem() const { return component_.problem; }
    std::size_t count() const { return problem().contacts.size(); }
    Vec3& velocity(std::size_t body) { return component_.problem.bodies[body].velocity; }
    BodyId id_of_a(const Contact& contact) const { return component_.id_of_a(contact); }
    Vec3 relative_velocity(std::size_t contact) const;
    double rate(std::size_t contact) const;
    bool is_closed(std::size_t contact) const;
    double turning(std::size_t contact) const;
    double lowest_rebound(std::size_t contact) const;
    double softest(std::size_t contact) const;

    void choose_candidates();
    void find_forces();
    bool project_velocities();
    bool take_nearest(std::vector<char>& left);
    void bring_to_rest();

    const State& state_;
    ContactComponent component_;
    const double slow_;  ///< contacts no faster than this neither open nor close [length/time]
    const double soft_;  ///< nothing opens a contact with less acceleration than this [length/time^2]
    /// Accelerations of bodies in contact are the same within this, and are 0. (One threshold for both: otherwise one
    /// body rests while the other leaves it.)
    const double same_ = 4 * soft_;
    std::vector<char> persists_;      ///< by contact
    std::vector<double> force_;       ///< by contact
    std::vector<Vec3> acceleration_;  ///< by body
    std::vector<char> released_;      ///< by contact: see release()
    std::vector<double> impulses_;
    double energy_taken_ = 0;
};

}  // namespace carom
