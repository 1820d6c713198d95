/// \file
/// Findings of the audit of a trace.
#pragma once

#include <carom/progress.hpp>
#include <carom/types.hpp>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace carom::audit {

enum class FindingKind : std::uint8_t {
    missed,    ///< two bodies touch, and fly on as if they had not
    late,      ///< they answer, but after they have touched
    early,     ///< they answer before they touch
    invented,  ///< a body changes its velocity where nothing touches it
    overlap    ///< bodies overlap in frames
};
inline constexpr std::array<std::string_view, 5> finding_kind_names{"missed", "late", "early", "invented", "overlap"};

/// A body as a scene begins with it.
struct Begin {
    BodyId body = no_body;
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();
};

struct Finding {
    FindingKind kind = FindingKind::missed;
    double time = 0;  ///< of the touch; invented: of the change; overlap: of the first frame that shows it [time]
    BodyId a = no_body, b = no_body;  ///< as in Event; b is none for `invented`
    /// Overlap at its deepest while the touch has no answer; 0 for `early` and `invented` [length].
    double depth = 0;
    double by = 0;               ///< late, early: >= 0, so much [time]
    bool at_least = false;       ///< late: it is later than that, the frames do not say how much
    double change = 0;           ///< invented: of the velocity, if frames say it [length/time]
    double begin = 0, span = 0;  ///< of the scene that shows it [time]
    double time_error = 0;       ///< of `time` [time]
    std::vector<Begin> bodies;   ///< of that scene: the spheres concerned
    std::int64_t number = 0;     ///< among those of its kind, from 0
};

/// Spheres that can move, once for each interval.
struct BodyIntervals {
    std::int64_t all = 0;
    std::int64_t decided = 0;         ///< its flight before is known, and what happened is a contact or a finding
    std::int64_t without_flight = 0;  ///< no flight before: in contact, or contacts within few frames of each other
    /// On a straight line where flights bend: between the steps of a method that moves straight within them, or carried
    /// by a plane. Undecided.
    std::int64_t straight = 0;
    std::int64_t coarse = 0;   ///< digits or frames leave the flight unknown to more than 0.01 radii
    std::int64_t several = 0;  ///< a change that more than one contact, or one that may have been, can explain
};

/// Touches that flights have for certain.
struct TouchCounts {
    std::int64_t all = 0, found = 0, missed = 0, late = 0, early = 0;
    std::int64_t several = 0;    ///< undecided: other contacts of the bodies are within the same interval
    std::int64_t unsettled = 0;  ///< undecided: a body has no flight while the answer is awaited, or the trace ends
};

struct TraceAudit {
    std::int64_t frames = 0;
    double begin = 0, end = 0;  ///< of the trace [time]
    double place_error = 0;     ///< the largest of a place, from its printed digits [length]
    BodyIntervals bodies;
    TouchCounts touches;
    std::int64_t grazing = 0;  ///< undecided: whether two bodies touch is within the errors of their flights
    std::int64_t invented = 0, overlaps = 0;
    double deepest = 0;             ///< of all overlaps [length]
    bool whole = true;              ///< false: stopped before the end of the trace
    std::vector<Finding> findings;  ///< in the order in which they were decided, the first 200 of each kind

    std::int64_t count(FindingKind kind) const;
    std::int64_t found_wrong() const;  ///< findings of all kinds
    /// Touches that were not decided, and those that may have been.
    std::int64_t undecided() const { return touches.several + touches.unsettled + grazing; }
    /// Some interval of a body could be judged, or none had to be.
    bool says_something() const { return bodies.all == 0 || bodies.decided > 0; }
};

}  // namespace carom::audit
