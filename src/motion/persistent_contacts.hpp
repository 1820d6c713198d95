/// \file
/// The graph of persistent contacts, where these are more than one sphere on one plane.
#pragma once

#include "core/partner.hpp"

#include <algorithm>
#include <span>
#include <unordered_map>
#include <vector>

namespace carom {

struct PersistentContact {
    Partner partner{};
    double force = 0;  ///< along the normal, >= 0; the mean over a numeric piece [mass length/time^2]

    friend bool operator==(const PersistentContact&, const PersistentContact&) = default;
};

/// A list for each body that has one; contacts of two spheres stand in both lists.
class PersistentContacts {
public:
    std::span<const PersistentContact> of(BodyId body) const
    {
        const auto found = lists_.find(body);
        return found == lists_.end() ? std::span<const PersistentContact>{} : found->second;
    }
    bool between(BodyId a, Partner b) const { return !lists_.empty() && find(a, b) != nullptr; }
    /// 0 for contacts that are none.
    double force(BodyId a, Partner b) const
    {
        const PersistentContact* const found = find(a, b);
        return found ? found->force : 0;
    }

    /// The contacts of `body` are these and no others; spheres that are its former or new partners learn of it.
    void set(BodyId body, const std::vector<PersistentContact>& contacts)
    {
        clear(body);
        if (contacts.empty()) return;
        lists_[body] = contacts;
        const Partner self = Partner::sphere(body);
        for (const PersistentContact& c : contacts)
            if (c.partner.is_sphere() && !between(c.partner.index, self))
                lists_[c.partner.index].push_back({self, c.force});
    }
    /// The same contacts, other forces.
    void set_forces(BodyId body, const std::vector<PersistentContact>& contacts) { lists_[body] = contacts; }

private:
    const PersistentContact* find(BodyId a, Partner b) const
    {
        for (const PersistentContact& c : of(a))
            if (c.partner == b) return &c;
        return nullptr;
    }
    void clear(BodyId body)
    {
        const auto found = lists_.find(body);
        if (found == lists_.end()) return;
        for (const PersistentContact& c : found->second)
            if (c.partner.is_sphere()) remove(c.partner.index, Partner::sphere(body));
        lists_.erase(body);
    }
    void remove(BodyId from, Partner partner)
    {
        const auto found = lists_.find(from);
        if (found == lists_.end()) return;
        std::erase_if(found->second, [partner](const PersistentContact& c) { return c.partner == partner; });
        if (found->second.empty()) lists_.erase(found);
    }

    std::unordered_map<BodyId, std::vector<PersistentContact>> lists_;
};

}  // namespace carom
