/// \file
/// Data of the page of `carom tunnel`, "carom-tunnel-page/1" (JSON, UTF-8), for the same page as comparisons.
///
///     {"format": "carom-tunnel-page/1", "generator": "carom 0.1.0", "title": .., "verdict": [sentence, ..],
///      "scene": "", "seed": 1, "absent": [{"name", "reason"}, ..],
///      "columns": [names of tunnel.csv], "rows": [[a value for each column], ..],
///      "critical_columns": [names of critical.csv], "critical": [[..], ..], "scenes": [scene, ..]}
///
/// - What is not known is null. `scene` is the name of the user's scene, "" for the matrix, whose rows say which throw
///   shows them (`example_phase`, `example_offset`), so that the page can offer it as a scene file. `scenes` has the
///   scene files of a user's scene by row, "" where no throw failed; empty for the matrix.
#pragma once

#include "tunnel/study.hpp"

#include <string>
#include <vector>

namespace carom::report {

/// Compact. \param generator program and version \param scenes as above
std::string tunnel_page_data(const tunnel::Report& report, const std::string& generator,
                             const std::vector<std::string>& scenes = {});

}  // namespace carom::report
