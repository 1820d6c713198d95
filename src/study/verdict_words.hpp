/// \file
/// Phrases of which the sentences of a verdict are made.
#pragma once

#include <carom/study.hpp>

#include <string>

namespace carom::study {

/// The error that the verdict is about: the largest at any sample. The one at the end would call a ball right that lies
/// where it should after every bounce went wrong.
std::optional<double> verdict_error(const CompareRow& row);

/// Impacts that did not come at all. Those that came early or late are the other part of `missed_impacts`.
std::int64_t lost_impacts(const CompareRow& row);

/// Went to the end, stayed within the tolerance, and lost no impact.
bool holds(const CompareRow& row, double tolerance);

/// Phrases with the units of one scene and the figures of one comparison. Both must outlive it.
class VerdictWords {
public:
    VerdictWords(const Scene& scene, const Comparison& comparison);

    const Comparison& comparison() const { return comparison_; }
    /// The event-driven run; null if there is none.
    const CompareRow* event() const { return event_; }

    std::string length(double value) const;
    std::string time(double value) const;
    /// "a position error of 1 mm"
    std::string tolerance() const;
    /// " up to t = 1.0468 s" where the reference ends before the runs do, else empty.
    std::string while_known() const;
    /// "310 times the event run", or the CPU time where that is no measure.
    std::string cost(const CompareRow& row) const;
    /// "1/240 in 4 substeps"
    static std::string setting(const CompareRow& row);
    /// "3 of 35 impacts"
    static std::string share(std::int64_t part, const CompareRow& row);
    /// Why a row does not hold: "is off by 1.1 mm", "misses 3 of 35 impacts", "blows up". \pre it does not
    std::string fault(const CompareRow& row) const;

private:
    const Scene& scene_;
    const Comparison& comparison_;
    const CompareRow* event_ = nullptr;
};

}  // namespace carom::study
