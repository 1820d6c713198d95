#include "heap/resting_part.hpp"

#include "gather/component.hpp"
#include "window/tolerances.hpp"

#include <algorithm>
#include <unordered_set>

namespace carom {

RestingPart::RestingPart(const State& state, Moment& moment, BodyId first, const ContactsAtRest& contacts_of)
    : fall_(state.gravity().norm())
{
    std::unordered_set<BodyId> known{first};
    bodies_.push_back(first);
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        const auto contacts = contacts_of(bodies_[k]);
        if (!contacts) {
            is_held_ = false;
            return;
        }
        for (const PersistentContact& c : *contacts)
            if (c.partner.is_sphere() && !state.is_fixed(c.partner.index) && known.insert(c.partner.index).second)
                bodies_.push_back(c.partner.index);
    }
    std::sort(bodies_.begin(), bodies_.end());
    std::vector<HalfSpace> carrying;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        const BodyId body = bodies_[k];
        inverse_masses_.push_back(state.inverse_mass(body));
        stamps_.push_back(state.bodies.stamp(body));
        partners_.emplace_back();
        contacts_.emplace_back();
        const auto its_contacts = contacts_of(body);
        for (const PersistentContact& c : *its_contacts) {
            partners_[k].push_back(c.partner);
            if (c.partner.is_plane()) {
                contacts_[k].push_back(carrying.size());
                const Contact contact = plane_contact(state, body, moment.flight(body), c.partner.index);
                carrying.push_back({static_cast<int>(k), {}, contact.normal, 0});
                continue;
            }
            const BodyId other = c.partner.index;
            if (!state.is_fixed(other) && other < body) {
                const std::size_t its = number(other);
                const auto found = std::find(partners_[its].begin(), partners_[its].end(), Partner::sphere(body));
                if (found == partners_[its].end()) {
                    is_held_ = false;
                    return;
                }
                contacts_[k].push_back(contacts_[its][static_cast<std::size_t>(found - partners_[its].begin())]);
                continue;
            }
            contacts_[k].push_back(carrying.size());
            const Contact contact = sphere_contact(state, body, moment.flight(body), other, moment.flight(other));
            HalfSpace h{static_cast<int>(k), {}, contact.normal, 0};
            if (!state.is_fixed(other)) h.b = static_cast<int>(number(other));
            carrying.push_back(h);
        }
    }
    factor_ = std::make_unique<const CarryingContacts>(carrying, inverse_masses_);
}

std::size_t RestingPart::number(BodyId body) const
{
    return static_cast<std::size_t>(std::lower_bound(bodies_.begin(), bodies_.end(), body) - bodies_.begin());
}

bool RestingPart::has(BodyId body) const
{
    return std::binary_search(bodies_.begin(), bodies_.end(), body);
}

bool RestingPart::is_current(const State& state, const ContactsAtRest& contacts_of) const
{
    if (!is_held_) return false;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        const auto contacts = contacts_of(bodies_[k]);
        if (state.bodies.stamp(bodies_[k]) != stamps_[k]) return false;
        if (!contacts || !std::equal(contacts->begin(), contacts->end(), partners_[k].begin(), partners_[k].end(),
                                     [](const PersistentContact& c, Partner p) { return c.partner == p; }))
            return false;
    }
    return true;
}

std::optional<std::vector<ForceChange>> RestingPart::bear(const std::vector<Load>& further,
                                                          const ContactsAtRest& contacts_of) const
{
    std::vector<Vec3> accelerations(bodies_.size(), Vec3::Zero());
    for (const Load& load : further)
        if (has(load.body)) accelerations[number(load.body)] += inverse_masses_[number(load.body)] * load.force;
    double largest_acceleration = fall_;
    for (const Vec3& a : accelerations) largest_acceleration = std::max(largest_acceleration, a.norm());
    const std::optional<CarriedForces> carried = factor_->forces(accelerations);
    if (!carried || carried->residual > acceleration_at_rest * largest_acceleration) return {};
    std::vector<ForceChange> out;
    double largest = 0, least = 0;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        const auto found = contacts_of(bodies_[k]);
        const std::span<const PersistentContact> contacts = *found;
        out.push_back({bodies_[k], {contacts.begin(), contacts.end()}});
        for (std::size_t c = 0; c < contacts.size(); ++c) {
            double& force = out.back().contacts[c].force;
            force += carried->forces[contacts_[k][c]];
            largest = std::max(largest, force);
            least = std::min(least, force);
            force = std::max(force, 0.0);
        }
    }
    if (least < -least_force * largest) return {};
    return out;
}

}  // namespace carom
