/// \file
/// Evaluated checks as JSON, format carom-check/1.
#pragma once

#include "io/command_facts.hpp"

#include <carom/checks.hpp>

#include <string>
#include <vector>

namespace carom::io {

struct CheckedScene {
    std::string name, title;  ///< the file's stem; what the scene calls itself
    CheckReport report;
};

/// One JSON object, indented, with its last line end. What is not finite is null.
/// Stopped commands have passed nothing; `scenes` are those that began to run.
std::string check_json(const std::vector<CheckedScene>& scenes, const CommandFacts& command = {});

}  // namespace carom::io
