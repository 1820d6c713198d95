/// \file
/// More impacts of one body within one step h than any number of separate contacts explains, at a restitution below 1,
/// are a Zeno point that nobody sums. (The bound B n / h of the design; at restitution 1 only `max_events` bounds a
/// run.)
#pragma once

#include "event_driven/resolve.hpp"

namespace carom {

class ImpactRate {
public:
    explicit ImpactRate(const State& state) : recent_(state.flights.size()) {}

    /// Count an impact of `body`; true if it is one too many.
    bool accumulates(const State& state, const Key& impact, BodyId body)
    {
        if (is_elastic(state, impact)) return false;
        Recent& recent = recent_[static_cast<std::size_t>(body)];
        if (recent.count == 0 || state.frame.between(recent.since, impact.time) > state.rest.numeric_step)
            recent = {impact.time, 0};
        return ++recent.count > bound;
    }

private:
    static constexpr int bound = 100;

    static bool is_elastic(const State& state, const Key& key)
    {
        const int material = state.sphere(key.a).material;
        const ContactLaw& law = state.is_plane(key.b)
                                    ? state.laws.plane(material, state.plane(state.plane_index(key.b)).material)
                                    : state.laws.spheres(material, state.sphere(key.b).material);
        return law.restitution >= 1;
    }

    struct Recent {
        EpochTime since;
        int count = 0;
    };
    std::vector<Recent> recent_;  ///< by body: impacts in the current window
};

}  // namespace carom
