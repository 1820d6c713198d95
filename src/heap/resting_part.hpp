/// \file
/// Bodies at rest under the load of others: whether they bear it, and with which forces.
#pragma once

#include "hold/outcome.hpp"
#include "motion/moment.hpp"
#include "motion/window_piece.hpp"
#include "window/statics.hpp"

#include <functional>
#include <span>

namespace carom {

/// Persistent contacts of a body at rest, nothing of one that moves.
using ContactsAtRest = std::function<std::optional<std::span<const PersistentContact>>(BodyId)>;

/// All bodies at rest that persistent contacts connect. Where as many contacts carry as there are directions their
/// forces follow from the load alone: the part stays at rest if all push.
class RestingPart {
public:
    RestingPart(const State& state, Moment& moment, BodyId first, const ContactsAtRest& contacts_of);

    bool has(BodyId body) const;
    /// Whether the same contacts hold the same bodies where they were.
    bool is_current(const State& state, const ContactsAtRest& contacts_of) const;
    /// Forces under loads beyond those that its contacts bear now, body by body; nothing where the part would move.
    /// \pre is_current
    std::optional<std::vector<ForceChange>> bear(const std::vector<Load>& further,
                                                 const ContactsAtRest& contacts_of) const;

private:
    std::size_t number(BodyId body) const;

    std::vector<std::uint32_t> stamps_;               ///< by body: of its motion
    std::vector<BodyId> bodies_;                      ///< ascending
    std::vector<std::vector<Partner>> partners_;      ///< by body
    std::vector<std::vector<std::size_t>> contacts_;  ///< by body and partner: number of the contact
    std::vector<double> inverse_masses_;              ///< by body
    double fall_ = 0;                                 ///< acceleration of what nothing carries
    bool is_held_ = true;                             ///< by bodies at rest alone
    std::unique_ptr<const CarryingContacts> factor_;
};

}  // namespace carom
