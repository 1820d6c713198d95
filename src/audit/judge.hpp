/// \file
/// The judge of intervals, one after the other: touches wait here for their answers.
#pragma once

#include "audit/answer.hpp"
#include "audit/overlap_watch.hpp"
#include "audit/report.hpp"

#include <map>
#include <vector>

namespace carom::audit {

class Judge {
public:
    /// The scene must outlive it.
    explicit Judge(const Scene& scene);

    /// The next interval of the trace, with the frames at both its ends.
    void judge(const Interval& interval, const SeenFrame& from, const SeenFrame& to);
    /// After the last one: touches that still wait are undecided, overlaps that go on are told.
    void finish();

    TraceAudit& report() { return report_; }

private:
    struct Waiting {
        Touch touch;
        std::size_t intervals = 0;  ///< without an answer
        Finding draft;              ///< with the scene that shows it
    };

    void open_touches(const Interval& interval);
    void hear_answers(const Interval& interval, const SeenFrame& from, const SeenFrame& to, const Around& around);
    /// Enters what was answered. \return whether the touch goes on waiting
    bool enter(Waiting& waiting, const Answer& answer, const Interval& interval, const SeenFrame& to);
    /// Whether a sphere that changes the side of a plate is told already, or will be.
    bool is_known_miss(const Pair& pair);
    void notice_sides(const Interval& interval, const SeenFrame& from, const SeenFrame& to);
    void count_bodies(const Interval& interval, const Around& around);
    /// Changes that no contact makes, whatever the body may touch.
    void notice_impossible(const Interval& interval, const Around& around);
    /// Whether a sphere has left its flight where nothing can have touched it.
    bool is_invention(const Interval& interval, std::size_t sphere, const Around& around) const;
    void tell_invented(const Interval& interval, std::size_t sphere);
    void keep(Finding finding);
    /// Whether the change of a sphere in this interval is one that was told in the last one, at their common frame.
    bool was_told(const Interval& interval, BodyId body) const;
    void note_turn(const Interval& interval, BodyId body);

    const Scene& scene_;
    TraceAudit report_;
    std::map<Pair, Waiting> waiting_;
    OverlapWatch overlaps_;
    Pairs inside_plates_;              ///< of plates: missed, told, and not yet out on either side
    std::vector<double> told_until_;   ///< by sphere: when the last change that was told has surely been [time]
    std::vector<std::size_t> uneasy_;  ///< by sphere: intervals for which a contact before may still explain a change
    std::vector<char> told_;           ///< by sphere: its change in this interval was told
    bool first_ = true;
};

}  // namespace carom::audit
