/// \file
/// Signs that an instant has more contacts than the one of its event. All that belong to it are found by component.hpp.
#pragma once

#include "gather/heap.hpp"
#include "motion/kinematics.hpp"
#include "queue/key.hpp"

namespace carom {

enum class Closed : std::uint8_t { no, in_heaps, yes };

/// The instant of one contact. Runs of doubles count contacts that are closed within the tie (State::tie) as one
/// instant; certified runs only contacts that close at the same time, as far as double-double can tell.
class ContactInstant {
public:
    ContactInstant(const State& state, const Key& contact, const Neighbourhood& neighbourhood)
        : state_(state), contact_(contact), neighbourhood_(neighbourhood)
    {
    }
    bool is_that_of(BodyId body, Partner other) const;
    /// Whether the contact is one of a heap, see `is_in_heap`; asked once.
    bool is_in_heap() const;
    /// Whether another contact with this gap is closed: within the tie; if it closed less than tau_p ago in heaps
    /// within rebound_gap, elsewhere where rounding ends its bounces, for they have come one after the other.
    Closed closed(BodyId a, Partner b, double gap) const;
    bool ties(BodyId a, Partner b, double gap) const
    {
        const Closed which = closed(a, b, gap);
        return which == Closed::yes || (which == Closed::in_heaps && is_in_heap());
    }

private:
    /// The time from the moment of the event to the contact itself.
    Enclosure<DoubleDouble> wait_for(BodyId body, Partner other) const;

    const State& state_;
    const Key& contact_;
    const Neighbourhood& neighbourhood_;
    mutable std::optional<bool> heap_;
};

/// Whether another contact of `body` than the one with `partner` is closed at this very instant and not opening.
/// \param now the body's flight, advanced to this instant
bool other_closed(const State& state, const ContactInstant& instant, const Flight& now, BodyId body, Partner partner,
                  const Neighbourhood& neighbourhood);

/// Whether a sphere flies, or is fixed, and nothing but `partner` is near it. \param now as above
bool is_apart(const State& state, const Flight& now, BodyId body, Partner partner, const Neighbourhood& neighbourhood);

/// Whether the contact of this event was already closed, and closing, when the later of its flights began at an impact:
/// then it belonged to that impact.
bool belongs_to_previous_instant(const State& state, const Key& key);

}  // namespace carom
