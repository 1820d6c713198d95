#include "cli/command_watch.hpp"

#include "cli/limits.hpp"
#include "study/clock.hpp"

#include <fmt/format.h>

#include <limits>

namespace carom::cli {

CommandWatch::CommandWatch(std::optional<double> max_seconds) : cpu_start_(study::process_cpu_seconds())
{
    limit(max_seconds.value_or(std::numeric_limits<double>::infinity()));
}

void CommandWatch::limit(double max_seconds)
{
    max_seconds_ = max_seconds;
    deadline_.reset();
    if (max_seconds < longest_limit)
        deadline_ = start_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(max_seconds));
}

bool CommandWatch::keep_going()
{
    if (ended_) return false;
    if (guard_.interrupted())
        ended_ = Status::interrupted;
    else if (deadline_ && Clock::now() > *deadline_)
        ended_ = Status::time_limit;
    return !ended_;
}

std::string CommandWatch::reason() const
{
    if (ended_ == Status::time_limit) return fmt::format("the limit of {:.6g} s for the whole command", max_seconds_);
    return "interrupted";
}

void CommandWatch::name_reason(Outcome& outcome) const
{
    if (outcome.status != Status::interrupted || !ended_) return;
    outcome.status = *ended_;
    outcome.message =
        fmt::format("{}, at t = {:.10g}", ended_ == Status::interrupted ? "on request" : reason(), outcome.time);
}

io::CommandFacts CommandWatch::facts() const
{
    const std::chrono::duration<double> seconds = Clock::now() - start_;
    return {seconds.count(), study::process_cpu_seconds() - cpu_start_, ended_};
}

}  // namespace carom::cli
