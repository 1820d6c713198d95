/// \file
/// One line on the terminal that says how far a command is.
#pragma once

#include "cli/arguments.hpp"
#include "cli/console.hpp"

#include <carom/progress.hpp>

#include <chrono>
#include <string>

namespace carom::cli {

class ProgressLine {
public:
    /// Shows nothing unless stderr is a terminal and neither -q nor --no-progress was given.
    ProgressLine(const Console& console, const GlobalArguments& global);
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Rate and remaining time are those of the stage, which begins when it is first shown.
    void show(const Progress& now);
    /// Whether the next `show` would write.
    bool is_due() const { return enabled_ && is_due(Clock::now()); }
    /// Removes the line.
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    bool is_due(Clock::time_point now) const;

    const Console& console_;
    bool enabled_, visible_ = false;
    Clock::time_point start_, last_, stage_start_;
    std::string stage_;
};

/// "pbd dt 1/240: 43 %, 1.2 s/s, 7 s left".
std::string progress_text(const std::string& what, double fraction, double amount, const std::string& unit,
                          double seconds);

}  // namespace carom::cli
