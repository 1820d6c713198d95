/// \file
/// The largest step of a method that keeps within the tolerance, found by measured runs.
#pragma once

#include "study/measure_row.hpp"

#include <span>
#include <vector>

namespace carom::study {

/// Plans that differ in their step alone, the step being the largest asked for.
std::vector<RowPlan> families_of(const std::vector<RowPlan>& plans);

/// Searches for one family, in the order of `StepScan`, until all its steps are known, errors stall, or `search_budget`
/// is over. The row found is measured in full. \param known rows measured before: those of the family are tries
StepSearch find_step(const RowMeasurer& measurer, const RowPlan& plan, double tolerance,
                     std::span<const CompareRow> known);

/// The largest step that a search may try, 16 times `longest` but no more than an eighth of the run: a truth for it is
/// needed. \param longest asked for [time]
double longest_searched_step(double until, double longest);

}  // namespace carom::study
