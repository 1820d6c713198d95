#include "study/words.hpp"

#include <carom/study.hpp>

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

using study::length_text;
using study::seconds_text;
using study::step_text;
using study::two_digits;

/// The error that the verdict is about: the largest at any sample. The one at the end would call a ball right that lies
/// where it should after every bounce went wrong.
std::optional<double> verdict_error(const CompareRow& row)
{
    return row.position_max;
}

/// Impacts that did not come at all, neither in time nor early or late.
std::int64_t lost_impacts(const CompareRow& row)
{
    return row.missed_impacts - row.mistimed_impacts;
}

std::string share(std::int64_t part, const CompareRow& row)
{
    return std::to_string(part) + " of " + std::to_string(row.reference_impacts) + " impacts";
}

bool reached(const CompareRow& row, double tolerance)
{
    const std::optional<double> error = verdict_error(row);
    return row.status == Status::reached_end && error && *error <= tolerance && lost_impacts(row) == 0;
}

std::string time_text(double time, const std::string& unit)
{
    return two_digits(time) + (unit.empty() ? "" : " " + unit);
}

class Writer {
public:
    Writer(const Scene& scene, const Comparison& comparison) : scene_(scene), comparison_(comparison)
    {
        for (const CompareRow& row : comparison.rows)
            if (!row.dt && event_ == nullptr) event_ = &row;
    }

    std::vector<std::string> sentences() const
    {
        std::vector<std::string> result;
        if (comparison_.rows.empty()) {
            result.push_back("No run was finished, so there is no verdict.");
            return result;
        }
        result.push_back(first_sentence());
        if (comparison_.reference.until < comparison_.until) result.push_back(reference_sentence());
        if (event_ != nullptr && event_->divergence_time) result.push_back(chaos_sentence());
        std::vector<std::string> seen;
        for (const CompareRow& row : comparison_.rows) {
            if (!row.dt || std::find(seen.begin(), seen.end(), row.method) != seen.end()) continue;
            seen.push_back(row.method);
            result.push_back(method_sentence(row.method));
        }
        if (comparison_.interrupted)
            result.push_back("The comparison was interrupted: the rows are those finished before.");
        return result;
    }

private:
    std::string length(double value) const { return length_text(value, scene_.units.length); }
    std::string tolerance() const { return length(comparison_.tolerance); }
    std::string time(double value) const { return time_text(value, scene_.units.time); }

    /// " up to t = 2 s" where reference or run end early.
    std::string when(const CompareRow& row) const
    {
        const double end = std::min(comparison_.reference.until, row.time);
        return end < comparison_.until ? " up to t = " + time(end) : "";
    }

    const CompareRow* best_discrete() const
    {
        const CompareRow* best = nullptr;
        for (const CompareRow& row : comparison_.rows) {
            const auto error = verdict_error(row);
            if (!row.dt || !error || !std::isfinite(*error)) continue;
            if (best == nullptr || *error < *verdict_error(*best)) best = &row;
        }
        return best;
    }

    std::string first_sentence() const
    {
        const CompareRow* best = best_discrete();
        if (event_ == nullptr) {
            if (best == nullptr) return "No method gave a finite answer.";
            return "Closest to the reference is " + best->method + " at dt = " + step_text(*best->dt) +
                   ", off by at most " + length(*verdict_error(*best)) + when(*best) +
                   "; the event method was not among those run.";
        }
        const std::optional<double> error = verdict_error(*event_);
        const std::string cost = seconds_text(event_->cpu_seconds) + " of CPU";
        if (event_->status != Status::reached_end)
            return "event stopped early, at t = " + time(event_->time) + " of " + time(comparison_.until) + " (" +
                   name(event_->status) + (event_->message.empty() ? "" : ": " + event_->message) + "), after " + cost +
                   ".";
        if (!error) return "event reached the end in " + cost + ", but there is no reference to measure it by.";
        std::string text = "event is off by at most " + length(*error) + when(*event_);
        if (*error <= comparison_.reference.bound)
            text += " (within what the reference knows, " + length(comparison_.reference.bound) + ")";
        text += " and takes " + cost;
        if (event_->missed_impacts > 0) text += ", but it misses " + share(event_->missed_impacts, *event_);
        if (*error > comparison_.tolerance)
            text = "The event method is not within " + tolerance() + ": " + text;
        else if (event_->missed_impacts == 0)
            text = "The event method is right: " + text;
        if (best != nullptr) text += "; " + steppers_in_short(*best, *error);
        return text + ".";
    }

    /// What the cheapest stepper within the tolerance costs, or how far the best one stays from it.
    std::string steppers_in_short(const CompareRow& best, double event_error) const
    {
        const double error = *verdict_error(best);
        if (error < event_error && event_error > comparison_.reference.bound)
            return "the best stepper, " + best.method + " at dt = " + setting(best) + ", is off by at most " +
                   length(error) + ", which is less";
        const CompareRow* cheapest = nullptr;
        for (const CompareRow& row : comparison_.rows)
            if (row.dt && reached(row, comparison_.tolerance) &&
                (cheapest == nullptr || row.cpu_seconds < cheapest->cpu_seconds))
                cheapest = &row;
        if (cheapest != nullptr)
            return "the cheapest stepper within " + tolerance() + ", " + cheapest->method +
                   " at dt = " + setting(*cheapest) + ", costs " + cost(*cheapest);
        return "no stepper tried comes within " + tolerance() + " (the best, " + best.method +
               " at dt = " + setting(best) + ", is off by " + length(error) + ")";
    }

    std::string reference_sentence() const
    {
        const std::string& reason = comparison_.reference.reason;
        return "The reference holds up to t = " + time(comparison_.reference.until) + " of " + time(comparison_.until) +
               (reason.empty() ? "" : " (" + reason + ")") + ": errors and missed impacts are counted up to there.";
    }

    std::string chaos_sentence() const
    {
        return "event itself leaves the reference by more than a hundredth of the smallest radius at t = " +
               time(*event_->divergence_time) + ": past that compare energy, not positions.";
    }

    /// " that costs 310 times the event run" or the time itself.
    std::string cost(const CompareRow& row) const
    {
        if (event_ == nullptr || event_->status != Status::reached_end || !(event_->cpu_seconds > 0))
            return seconds_text(row.cpu_seconds) + " of CPU";
        return two_digits(row.cpu_seconds / event_->cpu_seconds) + " times the event run";
    }

    static std::string setting(const CompareRow& row)
    {
        std::string text = step_text(*row.dt);
        if (row.substeps.value_or(1) > 1) text += " in " + std::to_string(*row.substeps) + " substeps";
        if (row.passes.value_or(1) > 1) text += " with " + std::to_string(*row.passes) + " passes";
        return text;
    }

    std::string method_sentence(const std::string& method) const;

    const Scene& scene_;
    const Comparison& comparison_;
    const CompareRow* event_ = nullptr;
};

std::string Writer::method_sentence(const std::string& method) const
{
    const CompareRow *enough = nullptr, *best = nullptr, *blind = nullptr, *blown = nullptr;
    for (const CompareRow& row : comparison_.rows) {
        if (row.method != method) continue;
        if (lost_impacts(row) > 0 && (blind == nullptr || lost_impacts(row) > lost_impacts(*blind))) blind = &row;
        const std::optional<double> error = verdict_error(row);
        if (row.status != Status::reached_end || (error && !std::isfinite(*error))) {
            if (blown == nullptr) blown = &row;
            continue;
        }
        if (!error) continue;
        if (best == nullptr || *error < *verdict_error(*best)) best = &row;
        if (!reached(row, comparison_.tolerance)) continue;
        const bool better = enough == nullptr || *row.dt > *enough->dt ||
                            (*row.dt == *enough->dt && row.cpu_seconds < enough->cpu_seconds);
        if (better) enough = &row;
    }
    std::string text = method;
    if (enough != nullptr) {
        text += " needs dt <= " + setting(*enough) + " for " + tolerance() + "; that costs " + cost(*enough);
        if (enough->mistimed_impacts > 0)
            text += ", and " + share(enough->mistimed_impacts, *enough) + " come more than 3 steps early or late";
        for (const CompareRow& row : comparison_.rows)
            if (row.method == method && *row.dt < *enough->dt && !reached(row, comparison_.tolerance)) {
                text += " (but it fails again at dt = " + setting(row) + ")";
                break;
            }
    } else if (best != nullptr && *verdict_error(*best) <= comparison_.tolerance) {
        text += ": no step tried reaches " + tolerance() + " without missing an impact (" +
                length(*verdict_error(*best)) + " at dt = " + setting(*best) + ", " + cost(*best) + ")";
    } else if (best != nullptr) {
        text += ": no step tried reaches " + tolerance() + " (best " + length(*verdict_error(*best)) +
                " at dt = " + setting(*best) + ", " + cost(*best) + ")";
    } else {
        text += ": no step tried gave a finite answer to the end";
    }
    if (blind != nullptr) text += "; it misses " + share(lost_impacts(*blind), *blind) + " at dt = " + setting(*blind);
    if (blown != nullptr && best != nullptr)
        text += "; at dt = " + setting(*blown) + " it " +
                (blown->status == Status::reached_end ? "blows up" : std::string("ends with ") + name(blown->status));
    return text + ".";
}

}  // namespace

std::vector<std::string> verdict(const Scene& scene, const Comparison& comparison)
{
    return Writer(scene, comparison).sentences();
}

}  // namespace carom
