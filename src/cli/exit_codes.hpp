/// \file
/// The exit codes of the process; README.md lists them.
#pragma once

#include <carom/simulate.hpp>

#include <stdexcept>

namespace carom::cli {

enum ExitCode : int {
    exit_ok = 0,
    exit_failed = 1,
    exit_usage = 2,
    exit_bad_input = 3,
    exit_check_failed = 4,
    exit_limit = 5,
    exit_interrupted = 130
};

int exit_code(Status status);

/// What the user typed cannot be understood: exit 2.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace carom::cli
