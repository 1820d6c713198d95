/// \file
/// Data of the page of `carom stress`, "carom-stress-page/1" (JSON, UTF-8), for the same page as comparisons: those of
/// stress.json (`io::stress_json`), with `generator` and
///
/// - `verdict`: sentences, the first of them about who claims to be exact.
#pragma once

#include "study/stress.hpp"

#include <string>
#include <vector>

namespace carom::report {

/// How many of the cases each passes, and what is not required yet.
std::vector<std::string> stress_verdict(const stress::Report& report);

/// \param json of the report (format carom-stress/1) \param generator program and version
std::string stress_page_data(const stress::Report& report, const std::string& json, const std::string& generator);

}  // namespace carom::report
