/// \file
/// Events: the reports of a run while it goes.
#pragma once

#include <carom/types.hpp>

namespace carom {

/// Kinds of events. Values are part of `event_hash` (docs/recording.md): never renumber.
enum class EventKind : std::uint8_t {
    impact = 1,   ///< a contact got an impulse
    rest = 2,     ///< normal motion on a plane ended: the contact persists from here on
    release = 3,  ///< a persistent contact opened
    guard = 4,    ///< a jammed component was handed to a discrete method for one window
    settle = 5    ///< a contact that opened slower than v_c, or was about to, was held: its impulse pulls
};

inline constexpr std::size_t first_event_kind = 1;
inline constexpr std::array<std::string_view, 5> event_kind_names{"impact", "rest", "release", "guard", "settle"};
/// The word that results and files use for a kind.
const char* name(EventKind kind);

struct Event {
    EventKind kind = EventKind::impact;
    EpochTime at;                ///< exact moment, for event-driven runs
    double time = 0;             ///< the same, in seconds since the start, rounded to a double [time]
    BodyId a = no_body;          ///< the sphere; of two spheres the smaller id
    BodyId b = no_body;          ///< the other sphere, or Scene::plane_body(p)
    Vec3 normal = Vec3::Zero();  ///< unit, from b to a
    /// Impulse on a; -impulse acts on b [mass length/time]. A rest carries the summed impulse of its series.
    Vec3 impulse = Vec3::Zero();
};

}  // namespace carom
