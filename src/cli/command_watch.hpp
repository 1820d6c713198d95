/// \file
/// Time and patience of one command: what it has taken so far, and whether it may go on.
#pragma once

#include "cli/interrupt.hpp"
#include "io/command_facts.hpp"

#include <carom/progress.hpp>
#include <carom/simulate.hpp>

#include <chrono>
#include <optional>
#include <string>

namespace carom::cli {

/// From its making on, SIGINT and SIGTERM are remembered and the clock runs.
class CommandWatch {
public:
    /// \param max_seconds for the whole command, on the clock; none: as long as it takes [s]
    explicit CommandWatch(std::optional<double> max_seconds);

    /// Another limit, counted from the start of the command all the same [s].
    void limit(double max_seconds);

    /// False once the command must end. The first reason stays.
    bool keep_going();
    /// Status::interrupted or Status::time_limit, if `keep_going` has said no.
    std::optional<Status> ended() const { return ended_; }
    /// Why, for people: "interrupted", "the limit of 5 s for the whole command". \pre ended
    std::string reason() const;

    /// An outcome that ended because `keep_going` said no, told by its reason.
    void name_reason(Outcome& outcome) const;

    io::CommandFacts facts() const;

private:
    using Clock = std::chrono::steady_clock;

    InterruptGuard guard_;
    Clock::time_point start_ = Clock::now();
    double cpu_start_;
    double max_seconds_;
    std::optional<Clock::time_point> deadline_;
    std::optional<Status> ended_;
};

}  // namespace carom::cli
