/// \file
/// The rows of a comparison: every method with every choice that means something to it.
#pragma once

#include <carom/study.hpp>

#include <optional>
#include <string>
#include <vector>

namespace carom::study {

struct RowPlan {
    Method method;
    std::optional<ImpactOperator> impact;  ///< of the event method; none for discrete ones
};

/// In the order asked for; what would be the same run twice is one row.
std::vector<RowPlan> rows_to_run(const Scene& scene, const CompareOptions& options);

/// "pbd dt 1/60", for the progress line.
std::string label(const Method& method);

/// The longest step among the rows; 0 without a discrete one [time].
double longest_step(const std::vector<RowPlan>& rows);

/// Writes what was run into a row.
void describe(const RowPlan& plan, CompareRow& row);

}  // namespace carom::study
