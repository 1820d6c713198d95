/// \file
/// Who is in persistent contact with whom, where that is more than one sphere on one plane (Flight::support).
#pragma once

#include <carom/types.hpp>

#include <algorithm>
#include <span>
#include <unordered_map>
#include <vector>

namespace carom {

struct PersistentContact {
    BodyId partner = no_body;  ///< a sphere, or a plane as events name it
    double force = 0;          ///< along the normal, >= 0; the mean over a numeric piece [mass length/time^2]

    friend bool operator==(const PersistentContact&, const PersistentContact&) = default;
};

/// A list for each body that has one; contacts of two spheres stand in both lists.
class PersistentContacts {
public:
    bool empty() const { return lists_.empty(); }
    std::span<const PersistentContact> of(BodyId body) const
    {
        const auto found = lists_.find(body);
        return found == lists_.end() ? std::span<const PersistentContact>{} : found->second;
    }
    bool between(BodyId a, BodyId b) const
    {
        if (lists_.empty()) return false;
        const auto list = of(a);
        return std::any_of(list.begin(), list.end(), [b](const PersistentContact& c) { return c.partner == b; });
    }

    /// 0 for contacts that are none.
    double force(BodyId a, BodyId b) const
    {
        for (const PersistentContact& c : of(a))
            if (c.partner == b) return c.force;
        return 0;
    }

    /// The contacts of `body` are these and no others; its former and new partners among the first `spheres` bodies
    /// learn of it.
    void set(BodyId body, const std::vector<PersistentContact>& contacts, BodyId spheres)
    {
        clear(body, spheres);
        if (contacts.empty()) return;
        lists_[body] = contacts;
        for (const PersistentContact& c : contacts)
            if (c.partner < spheres && !between(c.partner, body)) lists_[c.partner].push_back({body, c.force});
    }
    /// The same contacts, other forces.
    void set_forces(BodyId body, const std::vector<PersistentContact>& contacts) { lists_[body] = contacts; }
    void clear(BodyId body, BodyId spheres)
    {
        const auto found = lists_.find(body);
        if (found == lists_.end()) return;
        for (const PersistentContact& c : found->second)
            if (c.partner < spheres) remove(c.partner, body);
        lists_.erase(body);
    }

private:
    void remove(BodyId from, BodyId partner)
    {
        const auto found = lists_.find(from);
        if (found == lists_.end()) return;
        std::erase_if(found->second, [partner](const PersistentContact& c) { return c.partner == partner; });
        if (found->second.empty()) lists_.erase(found);
    }

    std::unordered_map<BodyId, std::vector<PersistentContact>> lists_;
};

}  // namespace carom
