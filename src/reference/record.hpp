/// \file
/// The events of a run as they are told.
#pragma once

#include "reference/contacts.hpp"
#include "reference/reference.hpp"

#include <set>

namespace carom::reference {

template <class Real>
struct Record {
    std::vector<ReferenceImpact> impacts;
    std::vector<ReferenceSeries> series;
    std::vector<ReferenceContact> contacts;  ///< those that persist at the end are in `since`
    std::vector<ReferenceConvention> conventions;
    std::int64_t root_solves = 0;
    std::map<Pair, Real> since;   ///< when contacts that persist began to
    std::map<Pair, double> last;  ///< impact listed of a pair

    /// An impact, with impulses x by link. Those of one pair that doubles do not tell apart are listed once.
    void impact(const Group<Real>& g, const Numbers<Real>& x, BodyId spheres, const Real& t)
    {
        const Real most = *std::max_element(x.begin(), x.end());
        for (std::size_t i = 0; i < x.size(); ++i) {
            const BodyId a = g.bodies[g.links[i].a], b = g.links[i].partner;
            if (x[i] <= noise * most) continue;
            const ReferenceImpact impact{static_cast<double>(t), b < spheres ? std::min(a, b) : a, std::max(a, b)};
            const auto [at, is_first] = last.try_emplace({impact.a, impact.b}, impact.time);
            if (!is_first && at->second == impact.time) continue;
            at->second = impact.time;
            impacts.push_back(impact);
        }
    }

    void begins(const Pair& pair, const Real& t) { since.try_emplace(pair, t); }
    void ends(const Pair& pair, const Real& t)
    {
        const auto at = since.find(pair);
        if (at == since.end()) return;
        if (t > at->second)
            contacts.push_back({static_cast<double>(at->second), static_cast<double>(t), pair.first, pair.second});
        since.erase(at);
    }
};

}  // namespace carom::reference
