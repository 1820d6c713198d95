/// \file
/// Usage errors in words. Only for files that include CLI11 anyway.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace carom::cli {

/// "carom: run: unknown option --untill (did you mean \"--until\"?)" and the like, with its line end.
/// \param app as it is after `error` was thrown while it parsed `args`
std::string usage_error(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& args);

}  // namespace carom::cli
