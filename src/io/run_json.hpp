/// \file
/// The result of one run as JSON, format carom-run/1 (CONTRACT section 4).
#pragma once

#include "io/limits.hpp"

#include <carom/study.hpp>

#include <string>

namespace carom::io {

struct RunJsonOptions {
    bool always_final = false;  ///< write `final` for more than `max_final_spheres` too
};

/// One JSON object, indented, with its last line end. What is not finite is null.
std::string run_json(const Scene& scene, const Method& method, const RunStudy& run, const RunJsonOptions& options = {});

}  // namespace carom::io
