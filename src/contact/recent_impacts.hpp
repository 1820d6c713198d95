/// \file
/// Times at which contacts closed last: one that closed less than tau_p ago and closes again is inelastic.
#pragma once

#include "contact/tolerances.hpp"
#include "flight/frame.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>

namespace carom {

class RecentImpacts {
public:
    /// \param window tau_p >= 0 [time] \param bodies spheres of the run: the memory is a small multiple of them
    RecentImpacts(const Frame& frame, double window, std::size_t bodies)
        : frame_(frame), window_(window), most_(remembered + remembered_each * bodies)
    {
    }

    /// The time since the contact closed last, if that is less than the window [time].
    std::optional<double> since(BodyId a, BodyId b, const EpochTime& now) const
    {
        const auto found = last_.find(pair(a, b));
        if (found == last_.end()) return {};
        const double time = frame_.between(found->second, now);
        return time < window_ ? std::optional(time) : std::nullopt;
    }
    bool has(BodyId a, BodyId b, const EpochTime& now) const { return since(a, b, now).has_value(); }
    void add(BodyId a, BodyId b, const EpochTime& now)
    {
        if (last_.size() >= most_) forget(now);
        last_[pair(a, b)] = now;
    }

private:
    static std::uint64_t pair(BodyId a, BodyId b)
    {
        const auto low = static_cast<std::uint32_t>(a < b ? a : b), high = static_cast<std::uint32_t>(a < b ? b : a);
        return (std::uint64_t{high} << 32) | low;
    }
    /// Drops contacts that closed longer ago than the window. If all are younger, there are more closings within it
    /// than the guard lets pass, and the memory grows.
    void forget(const EpochTime& now)
    {
        std::erase_if(last_, [&](const auto& entry) { return !(frame_.between(entry.second, now) < window_); });
        if (2 * last_.size() > most_) most_ *= 2;
    }

    Frame frame_;
    double window_;
    std::size_t most_;
    std::unordered_map<std::uint64_t, EpochTime> last_;
};

}  // namespace carom
