#include "study/convention_words.hpp"
#include "study/cost_ratio.hpp"
#include "study/method_verdict.hpp"
#include "study/search/search_words.hpp"
#include "study/verdict_words.hpp"
#include "study/words.hpp"

#include <carom/study.hpp>

#include <algorithm>
#include <cctype>
#include <set>

namespace carom {

namespace {

using namespace study;

/// Cost of the cheapest stepper within the tolerance, or how far the best one stays from it.
std::string steppers_in_short(const VerdictWords& words, const CompareRow& best, double event_error)
{
    const Comparison& comparison = words.comparison();
    const double error = *verdict_error(best);
    const std::string which = best.method + " at dt = " + VerdictWords::setting(best) + ", is off by ";
    if (error < event_error && event_error > comparison.tolerance)
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

/// "Use event", or the same up to where the reference ends: nothing is claimed beyond.
std::string within_scope(const VerdictWords& words, std::string text)
{
    const Comparison& comparison = words.comparison();
    if (!(comparison.reference.until < comparison.until)) return text;
    text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
    return "Up to t = " + words.time(comparison.reference.until) + " of " + words.time(comparison.until) +
           ", where the reference ends, " + text;
}

/// The cheapest stepper within the tolerance, if it costs less than the event run with all of its interval.
const CompareRow* rival(const Comparison& comparison)
{
    const CompareRow* cheapest = cheapest_stepper(comparison);
    if (cheapest == nullptr) return nullptr;
    const std::optional<Ratio> ratio = cost_ratio(comparison, *cheapest);
    return ratio && ratio->high < 1 ? cheapest : nullptr;
}

std::string event_sentence(const VerdictWords& words, const CompareRow& event)
{
    const Comparison& comparison = words.comparison();
    const std::optional<double> error = verdict_error(event);
    if (event.status != Status::reached_end) return stopped_sentence(words, event);
    if (!error)
        return "event reached the end in " + seconds_text(event.cpu_seconds) +
               " of CPU, but there is no reference to measure it by.";
    std::string text = "is off by at most " + words.length(*error);
    if (*error <= comparison.reference.bound)
        text += " (within what the reference knows, " + words.length(comparison.reference.bound) + ")";
    text += " and takes " + seconds_text(event.cpu_seconds) + " of CPU";
    const std::int64_t lost = lost_impacts(event);
    if (lost > 0) text += ", but it misses " + VerdictWords::share(lost, event);
    if (*error > comparison.tolerance)
        text = within_scope(words,
                            "The event method is not within " + words.length(comparison.tolerance) + ": it " + text);
    else if (const CompareRow* wins = rival(comparison); wins != nullptr)
        return within_scope(words, "A stepper wins: " + wins->method + " at dt = " + VerdictWords::setting(*wins) +
                                       " keeps within " + words.length(comparison.tolerance) + " and costs " +
                                       words.cost(*wins) + "; event " + text + ".");
    else
        text = within_scope(words, lost > 0 ? "The event method " + text : "Use event: it " + text);
    if (const CompareRow* best = best_stepper(comparison)) text += "; " + steppers_in_short(words, *best, *error);
    return text + ".";
}

/// Sentence on what the event method itself missed, met late or took for rest, as for anybody; empty if nothing.
std::string own_faults_sentence(const VerdictWords& words)
{
    if (words.event() == nullptr || !words.event()->audit) return "";
    const CompareRow& event = *words.event();
    const Audit& audit = *event.audit;
    std::string text;
    const auto add = [&](std::int64_t count, const std::string& what) {
        if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
    };
    add(audit.missed, "missed");
    add(audit.late, "early or late by more than touching is");
    add(audit.invented, "invented");
    add(event.absorbed_impacts.value_or(0), "closing slower than v_c taken for rest");
    if (text.empty()) return "";
    return "event itself, of " + std::to_string(audit.audited + event.absorbed_impacts.value_or(0)) +
           " impacts of the reference" + words.while_known() + ": " + text + "; its error has that in it.";
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

void add_if_any(std::vector<std::string>& sentences, const std::string& sentence)
{
    if (!sentence.empty()) sentences.push_back(sentence);
}

/// A sentence for each engine that is none of carom's: what it is, and what its time means.
std::vector<std::string> peer_sentences(const Comparison& comparison)
{
    std::vector<std::string> sentences;
    std::set<std::string> told;
    for (const CompareRow& row : comparison.rows)
        if (!row.peer_settings.value_or("").empty() && told.insert(row.method).second)
            sentences.push_back(row.method + " is " + *row.peer_settings +
                                "; its time is that of its own steps, as it says itself, without reading and writing, "
                                "and its contacts are not seen.");
    return sentences;
}

/// Whether the steps of a method were searched for: then its sentence is that of the search.
bool is_searched(const Comparison& comparison, const std::string& method)
{
    return std::any_of(comparison.searches.begin(), comparison.searches.end(),
                       [&](const StepSearch& search) { return search.method == method; });
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
    add_if_any(result, convention_sentence(scene, words));
    add_if_any(result, own_faults_sentence(words));
    std::set<std::string> seen;
    for (const CompareRow& row : comparison.rows)
        if (row.dt && !is_searched(comparison, row.method) && seen.insert(row.method).second)
            result.push_back(method_sentence(words, row.method));
    for (const StepSearch& search : comparison.searches) result.push_back(search_sentence(words, search));
    add_if_any(result, convergence_sentence(words));
    for (const std::string& sentence : peer_sentences(comparison)) result.push_back(sentence);
    if (comparison.interrupted) result.push_back("The comparison was interrupted: the rows are those finished before.");
    return result;
}

}  // namespace carom
