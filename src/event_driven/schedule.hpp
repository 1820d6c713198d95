/// \file
/// Prediction: who meets whom next. One queue slot a body for contacts, and one for leaving its grid cell.
#pragma once

#include "broad/all_pairs.hpp"
#include "broad/cell_grid.hpp"
#include "event_driven/state.hpp"
#include "queue/event_queue.hpp"

#include <span>
#include <variant>

namespace carom {

class Schedule {
public:
    /// \post every body has been examined
    Schedule(const State& state, BroadPhase broad_phase, Counts& counts);

    struct Next {
        std::size_t slot;
        Key key;
    };
    Next next() const { return {queue_.first(), queue_.key(queue_.first())}; }

    /// The flight of the partner has changed since the event was predicted.
    bool is_stale(const State& state, const Next& next) const;
    /// Predict a body's next contact, after its flight has changed or its event proved stale.
    void examine(const State& state, BodyId body, Counts& counts);
    /// Likewise its next cell; only if its flight has changed.
    void watch_cell(const State& state, BodyId body, const EpochTime& now, Counts& counts);
    /// Carry out a cell crossing.
    void cross(const State& state, const Key& crossing, Counts& counts);

    /// Every body that may touch this one before either of them crosses a cell wall; valid until the next call.
    std::span<const BodyId> neighbours(BodyId body)
    {
        found_.clear();
        std::visit([&](const auto& broad) { broad.neighbours(body, [&](BodyId other) { found_.push_back(other); }); },
                   broad_);
        return found_;
    }

private:
    void offer(const State& state, BodyId body, BodyId other, Key& best, std::uint32_t& stamp, Counts& counts) const;

    std::variant<AllPairs, CellGrid> broad_;
    EventQueue queue_;  ///< slot i: contact of body i; slot count + i: its cell crossing
    std::vector<BodyId> found_;
    std::vector<std::uint32_t> partner_stamp_;  ///< by body: of its contact's partner when it was predicted
};

}  // namespace carom
