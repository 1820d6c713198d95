/// \file
/// One line on the terminal that says how far a run is.
#pragma once

#include "cli/arguments.hpp"
#include "cli/console.hpp"

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

    /// \param fraction done, in [0, 1]
    /// \param amount done so far, in `unit`, for the rate; shown only if `unit` is not empty
    void show(const std::string& what, double fraction, double amount = 0, const std::string& unit = "");
    /// Removes the line.
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    const Console& console_;
    bool enabled_, visible_ = false;
    Clock::time_point start_, last_;
};

/// "pbd dt 1/240: 43 %, 1.2 s/s, 7 s left".
std::string progress_text(const std::string& what, double fraction, double amount, const std::string& unit,
                          double seconds);

}  // namespace carom::cli
