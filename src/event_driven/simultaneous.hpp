/// \file
/// Several contacts at one instant: how they are noticed. What they do together is not resolved yet; a run that meets
/// them says so.
#pragma once

#include "event_driven/certified_motion.hpp"
#include "event_driven/resolve.hpp"

namespace carom {

/// The instant of one contact. Runs of doubles count as one what is closed within `tie_fraction`; certified runs only
/// what closes at the same time, so far as double-double can tell.
class Instant {
public:
    Instant(const State& state, const Key& contact) : state_(state), contact_(contact) {}
    bool is_that_of(BodyId body, BodyId other) const;

private:
    bool is_certifiable_contact(BodyId body, BodyId other) const;
    /// From the moment of the event to the contact itself.
    Enclosure<DoubleDouble> wait(BodyId body, BodyId other) const;

    const State& state_;
    const Key& contact_;
};

/// Another contact of `body` that is closed and closing at this very instant, next to the one with `partner`; no_body
/// if none. \param now the body's flight, advanced to this instant
BodyId other_closing(const State& state, const Instant& instant, const Flight& now, BodyId body, BodyId partner,
                     const Neighbourhood& neighbourhood);

/// Was the contact of this event already closed, and closing, when the later of its flights began at an impact? Then it
/// belonged to that impact.
bool belongs_to_previous_instant(const State& state, const Key& key);

/// "ball and floor"
std::string pair_name(const State& state, BodyId a, BodyId b);
/// What `Resolution::unresolved` says of two contacts.
std::string several_contacts(const std::string& one, const std::string& other);

}  // namespace carom
