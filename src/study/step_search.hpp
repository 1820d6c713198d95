/// \file
/// The largest step of a method that keeps within the tolerance, found by measured runs.
#pragma once

#include "study/measure_row.hpp"

#include <span>
#include <vector>

namespace carom::study {

/// Plans that differ in their step alone, the step being the largest asked for.
std::vector<RowPlan> families_of(const std::vector<RowPlan>& plans);

/// Searches for one family: down from the step of `plan` until a step holds, or up until one does not, then between
/// the two by bisection of the logarithm, then below the step found, because errors scatter. The row found is measured
/// in full. \param known rows measured before: a step above one of them that does not hold is no answer
StepSearch find_step(const RowMeasurer& measurer, const RowPlan& plan, double tolerance,
                     std::span<const CompareRow> known);

/// The largest step that a search may try: a truth for it is needed. \param longest asked for [time]
double longest_searched_step(double until, double longest);

}  // namespace carom::study
