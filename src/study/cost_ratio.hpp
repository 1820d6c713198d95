/// \file
/// Cost of a row beside the event run.
#pragma once

#include <carom/study.hpp>

#include <optional>
#include <string>

namespace carom::study {

struct Ratio {
    double value = 0, low = 0, high = 0;  ///< of the medians, and the interval that those of the two medians give
};

/// CPU time over that of the event run; none where that did not reach the end or is not among the rows.
std::optional<Ratio> cost_ratio(const Comparison& comparison, const CompareRow& row);

/// "140 (130-150)"; the interval only where two digits show it.
std::string ratio_text(const Ratio& ratio);

}  // namespace carom::study
