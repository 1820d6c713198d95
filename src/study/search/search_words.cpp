#include "study/search/search_words.hpp"

#include "study/search/step_scan.hpp"
#include "study/share.hpp"
#include "study/tolerances.hpp"
#include "study/words.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace carom::study {

namespace {

std::string percent_with_interval(std::int64_t part, std::int64_t whole)
{
    const Share share = wilson_share(part, whole);
    return three_digits(per_cent * share.value) + " % (" + three_digits(per_cent * share.low) + "-" +
           three_digits(per_cent * share.high) + ")";
}

std::string order_text(const Convergence& fit)
{
    return fit.method + fit.variant + " as dt^" + two_digits(fit.order) + " +- " + two_digits(fit.uncertainty);
}

/// "9, from 1e-6 to 1/60"
std::string tried_text(const std::vector<StepSearch::Try>& tries)
{
    if (tries.empty()) return "none tried";
    if (tries.size() == 1) return "1 tried, " + step_text(tries.front().dt);
    return std::to_string(tries.size()) + " tried, from " + step_text(tries.front().dt) + " to " +
           step_text(tries.back().dt);
}

/// "dt = 6.8e-5 is enough: all 66 steps tried from 1.7e-5 up to it keep within a position error of 1 mm, ..."
std::string found_text(const VerdictWords& words, const StepSearch& search, const SearchFigures& figures)
{
    const double dt = *search.row->dt;
    std::string text = "dt = " + step_text(dt) + " is enough: ";
    if (figures.held > 1)
        text += "all " + std::to_string(figures.held) + " steps tried from " + step_text(search.tries.front().dt) +
                " up to it keep within " + words.tolerance() + ", the worst is off by " +
                words.length(figures.worst_error);
    else
        text += "it keeps within " + words.tolerance() + ", off by " + words.length(figures.worst_error);
    if (!search.is_complete)
        text += "; not all steps that a search tries were run, for its " + seconds_text(search_budget) + " were over";
    text += "; it costs " + words.cost(*search.row);
    if (figures.too_far) {
        text += "; at " + step_text(figures.too_far->dt) + " it ";
        text += !figures.too_far->error ? "blows up"
                : *figures.too_far->error > words.comparison().tolerance
                    ? "is off by " + words.length(*figures.too_far->error)
                    : "misses an impact";
    } else if (dt == search.largest) {
        text += "; larger steps are not tried (up to an eighth of the run and 16 times the largest asked for)";
    }
    return text;
}

}  // namespace

std::string audit_clause(const CompareRow& row)
{
    if (!row.audit || row.audit->audited == 0) return "";
    const Audit& audit = *row.audit;
    const std::array<std::pair<std::int64_t, const char*>, 3> faults{
        {{audit.missed, "misses "}, {audit.late, "answers late "}, {audit.wrong, "answers with a wrong velocity "}}};
    std::string text;
    for (const auto& [count, verb] : faults)
        if (count > 0) text += (text.empty() ? "" : ", ") + (verb + percent_with_interval(count, audit.audited));
    if (text.empty()) text = "finds all " + std::to_string(audit.audited) + " that could be asked about";
    if (audit.invented > 0)
        text += ", invents in " + percent_with_interval(audit.invented, audit.looked_at) + " of steps";
    return "; asked impact by impact, it " + text;
}

std::string search_sentence(const VerdictWords& words, const StepSearch& search)
{
    const std::string what = search.method + search.variant + words.while_known() + ": ";
    const SearchFigures figures = figures_of(search);
    if (search.end == StepSearch::End::found && search.row)
        return what + found_text(words, search, figures) + audit_clause(*search.row) + ".";
    if (!search.tries.empty() && search.tries.front().holds) return what + "the search was interrupted.";
    if (!figures.best) return what + "no step tried gave a finite answer (" + tried_text(search.tries) + ").";
    if (figures.lucky > 0)
        return what + "no step tried is safe: " + std::to_string(figures.lucky) + " of " + tried_text(search.tries) +
               ", keep within " + words.tolerance() + ", but not the smaller " + step_text(figures.fails->dt) + ".";
    return what + "no step tried keeps within " + words.tolerance() + " (" + tried_text(search.tries) + "; best " +
           words.length(*figures.best->error) + " at dt = " + step_text(figures.best->dt) +
           (search.end == StepSearch::End::stalls
                ? "), and errors no longer fall."
                : "); smaller ones would take more than " + seconds_text(search_budget) + " of runs.");
}

std::string convergence_sentence(const VerdictWords& words)
{
    std::string falls, stalls;
    for (const Convergence& fit : words.comparison().convergence) {
        if (fit.stalled)
            stalls += (stalls.empty() ? "" : ", ") + fit.method + fit.variant + " at " + words.length(fit.last_error);
        else
            falls += (falls.empty() ? "" : ", ") + order_text(fit);
    }
    std::string text;
    if (!falls.empty()) text = "Errors fall with the step: " + falls + ".";
    if (!stalls.empty())
        text += (text.empty() ? "" : " ") + ("Errors no longer fall with smaller steps: " + stalls + ".");
    return text;
}

}  // namespace carom::study
