/// \file
/// All parts of a heap that rest and bear loads.
#pragma once

#include "heap/resting_part.hpp"

namespace carom {

class Carriers {
public:
    using Parts = std::vector<std::shared_ptr<const RestingPart>>;

    Carriers(const State& state, Moment& moment) : state_(state), moment_(moment) {}

    /// Takes the parts over that a window knew.
    void add(const Parts& parts);
    /// Forces of all bodies at rest under further loads; nothing where some part of them would move.
    std::optional<std::vector<ForceChange>> bear(const std::vector<Load>& further, const ContactsAtRest& contacts_of);

    const Parts& parts() const { return parts_; }
    /// A body at rest of the last part that did not bear its loads.
    BodyId overloaded() const { return overloaded_; }

private:
    const RestingPart& part_of(BodyId body, const ContactsAtRest& contacts_of);

    const State& state_;
    Moment& moment_;
    Parts parts_;
    BodyId overloaded_ = no_body;
};

/// Enters forces in place of others of the same bodies.
void set_forces(std::vector<ForceChange> changes, EventOutcome& out);

}  // namespace carom
