/// \file
/// Data of the comparison page, as JSON (format carom-page/1, documented in report/page.hpp).
#pragma once

#include <carom/study.hpp>

#include <span>
#include <string>

namespace carom::report {

/// One comparison as a JSON object, compact. Tracks are views of at most `max_track_spheres` spheres.
std::string comparison_data(const Scene& scene, const Comparison& comparison);

/// The page's whole data: format, generator, and these comparisons.
std::string page_data(std::span<const std::string> comparisons, const std::string& generator);

}  // namespace carom::report
