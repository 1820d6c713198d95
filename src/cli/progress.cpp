#include "cli/progress.hpp"

#include "cli/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

namespace carom::cli {

namespace {
double seconds_between(std::chrono::steady_clock::time_point a, std::chrono::steady_clock::time_point b)
{
    return std::chrono::duration<double>(b - a).count();
}
}  // namespace

ProgressLine::ProgressLine(const Console& console, const GlobalArguments& global)
    : console_(console),
      enabled_(console.err_is_terminal && !global.quiet && !global.no_progress),
      start_(Clock::now()),
      last_(start_)
{
}

void ProgressLine::show(const std::string& what, double fraction, double amount, const std::string& unit)
{
    if (!enabled_) return;
    const Clock::time_point now = Clock::now();
    const double seconds = seconds_between(start_, now);
    if (seconds < progress_after || (visible_ && seconds_between(last_, now) < progress_every)) return;
    last_ = now;
    visible_ = true;
    console_.err << "\r\033[K" << progress_text(what, fraction, amount, unit, seconds) << std::flush;
}

void ProgressLine::clear()
{
    if (visible_) console_.err << "\r\033[K" << std::flush;
    visible_ = false;
}

std::string progress_text(const std::string& what, double fraction, double amount, const std::string& unit,
                          double seconds)
{
    const double done = std::clamp(fraction, 0.0, 1.0);
    std::string text = fmt::format("{}: {:.0f} %", what, 100 * done);
    if (!unit.empty() && seconds > 0) text += fmt::format(", {:.3g} {}/s", amount / seconds, unit);
    if (done > 0) text += fmt::format(", {:.0f} s left", seconds * (1 - done) / done);
    return text;
}

}  // namespace carom::cli
