#include "study/method_verdict.hpp"
#include "study/verdict_words.hpp"
#include "study/words.hpp"

#include <carom/study.hpp>

#include <algorithm>
#include <set>

namespace carom {

namespace {

using namespace study;

/// What the cheapest stepper within the tolerance costs, or how far the best one stays from it.
std::string steppers_in_short(const VerdictWords& words, const CompareRow& best, double event_error)
{
    const Comparison& comparison = words.comparison();
    const double error = *verdict_error(best);
    const std::string which = best.method + " at dt = " + VerdictWords::setting(best) + ", is off by ";
    if (error < event_error && event_error > comparison.reference.bound)
        return "the best stepper, " + which + "at most " + words.length(error) + ", which is less";
    const std::string within = " within " + words.length(comparison.tolerance);
    if (const CompareRow* cheapest = cheapest_stepper(comparison))
        return "the cheapest stepper" + within + ", " + cheapest->method +
               " at dt = " + VerdictWords::setting(*cheapest) + ", costs " + words.cost(*cheapest);
    if (error <= comparison.tolerance)
        return "no stepper tried stays" + within + " for good (the best, " + which + words.length(error) + ")";
    return "no stepper tried comes" + within + " (the best, " + which + words.length(error) + ")";
}

/// The event method's run that did not go to the end.
std::string stopped_sentence(const VerdictWords& words, const CompareRow& event)
{
    const Comparison& comparison = words.comparison();
    std::string text = "event stopped early, at t = " + words.time(event.time) + " of " + words.time(comparison.until) +
                       " (" + name(event.status) + (event.message.empty() ? "" : ": " + event.message) + "), after " +
                       seconds_text(event.cpu_seconds) + " of CPU";
    if (const std::optional<double> error = verdict_error(event))
        text += "; up to t = " + words.time(std::min(event.time, comparison.reference.until)) +
                " it is off by at most " + words.length(*error);
    return text + ".";
}

std::string event_sentence(const VerdictWords& words, const CompareRow& event)
{
    const Comparison& comparison = words.comparison();
    const std::optional<double> error = verdict_error(event);
    const std::string cost = seconds_text(event.cpu_seconds) + " of CPU";
    if (event.status != Status::reached_end) return stopped_sentence(words, event);
    if (!error) return "event reached the end in " + cost + ", but there is no reference to measure it by.";
    std::string text = "event is off by at most " + words.length(*error) + words.while_known();
    if (*error <= comparison.reference.bound)
        text += " (within what the reference knows, " + words.length(comparison.reference.bound) + ")";
    text += " and takes " + cost;
    if (event.missed_impacts > 0) text += ", but it misses " + VerdictWords::share(event.missed_impacts, event);
    if (*error > comparison.tolerance)
        text = "The event method is not within " + words.length(comparison.tolerance) + ": " + text;
    else if (event.missed_impacts == 0)
        text = "The event method is right: " + text;
    if (const CompareRow* best = best_stepper(comparison)) text += "; " + steppers_in_short(words, *best, *error);
    return text + ".";
}

std::string first_sentence(const VerdictWords& words)
{
    if (words.event() != nullptr) return event_sentence(words, *words.event());
    const CompareRow* best = best_stepper(words.comparison());
    if (best == nullptr) return "No method gave a finite answer.";
    return "Closest to the reference is " + best->method + " at dt = " + VerdictWords::setting(*best) +
           ", off by at most " + words.length(*verdict_error(*best)) + words.while_known() +
           "; the event method was not among those run.";
}

std::string reference_sentence(const VerdictWords& words)
{
    const ReferenceSummary& reference = words.comparison().reference;
    return "The reference holds up to t = " + words.time(reference.until) + " of " +
           words.time(words.comparison().until) + (reference.reason.empty() ? "" : " (" + reference.reason + ")") +
           ": errors and impacts are counted up to there.";
}

/// The reference ends before the first sample after the start.
bool measures_nothing(const Comparison& comparison)
{
    const ReferenceSummary& reference = comparison.reference;
    if (!(reference.until < comparison.until) || reference.sample_times.size() > 1) return false;
    return std::none_of(comparison.rows.begin(), comparison.rows.end(),
                        [](const CompareRow& row) { return verdict_error(row).has_value(); });
}

std::vector<std::string> verdict_without_reference(const Scene& scene, const VerdictWords& words)
{
    const ReferenceSummary& reference = words.comparison().reference;
    std::string text = "There is no verdict: the reference ends at t = " + words.time(reference.until) +
                       (reference.reason.empty() ? "" : " (" + reference.reason + ")") +
                       ", so that nothing here measures errors, only what a run costs.";
    return {text,
            "How much the thresholds of the event method matter shows when they change: compare the ends of carom run "
            "with and without --set /rest/numeric_step=" +
                two_digits(rest_thresholds(scene).numeric_step / 2) + ", half of what it is."};
}

std::string chaos_sentence(const VerdictWords& words)
{
    return "event itself leaves the reference by more than a hundredth of the smallest radius at t = " +
           words.time(*words.event()->divergence_time) + ": past that compare energy, not positions.";
}

}  // namespace

std::vector<std::string> verdict(const Scene& scene, const Comparison& comparison)
{
    if (comparison.rows.empty()) return {"No run was finished, so there is no verdict."};
    const VerdictWords words(scene, comparison);
    if (measures_nothing(comparison)) return verdict_without_reference(scene, words);
    std::vector<std::string> result{first_sentence(words)};
    if (comparison.reference.until < comparison.until) result.push_back(reference_sentence(words));
    if (words.event() != nullptr && words.event()->divergence_time) result.push_back(chaos_sentence(words));
    std::set<std::string> seen;
    for (const CompareRow& row : comparison.rows)
        if (row.dt && seen.insert(row.method).second) result.push_back(method_sentence(words, row.method));
    if (comparison.interrupted) result.push_back("The comparison was interrupted: the rows are those finished before.");
    return result;
}

}  // namespace carom
