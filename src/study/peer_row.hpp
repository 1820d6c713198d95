/// \file
/// The row of an engine that is none of carom's: the errors of any other row, and the time that its own steps took.
#pragma once

#include "study/measure_row.hpp"

namespace carom::study {

/// Its states are asked for at the same samples as those of all rows; contacts it shows none, so that nothing is
/// counted, and nothing asked impact by impact. None if it was interrupted.
std::optional<CompareRow> measure_peer(const RowMeasurer& measurer, const Peer& peer, double dt);

}  // namespace carom::study
