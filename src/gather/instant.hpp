/// \file
/// Several contacts at one instant: how they are noticed. See component.hpp for what belongs to it, all in all.
#pragma once

#include "gather/may_touch.hpp"
#include "motion/kinematics.hpp"
#include "queue/key.hpp"

namespace carom {

/// The instant of one contact. Runs of doubles count as one what is closed within the tie (State::tie); certified runs
/// only what closes at the same time, so far as double-double can tell.
class ContactInstant {
public:
    ContactInstant(const State& state, const Key& contact) : state_(state), contact_(contact) {}
    bool is_that_of(BodyId body, Partner other) const;

private:
    /// From the moment of the event to the contact itself.
    Enclosure<DoubleDouble> wait_for(BodyId body, Partner other) const;

    const State& state_;
    const Key& contact_;
};

/// Is another contact of `body` closed at this very instant and not opening, next to the one with `partner`?
/// \param now the body's flight, advanced to this instant
bool other_closed(const State& state, const ContactInstant& instant, const Flight& now, BodyId body, Partner partner,
                  const Neighbourhood& neighbourhood);

/// Was the contact of this event already closed, and closing, when the later of its flights began at an impact? Then it
/// belonged to that impact.
bool belongs_to_previous_instant(const State& state, const Key& key);

}  // namespace carom
