#include "cli/session.hpp"

#include "cli/choices.hpp"
#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"

#include <fmt/format.h>

namespace carom::cli {

namespace {

std::optional<double> typed_limit(const GivenOptions& given)
{
    constexpr const char* key = "max_seconds";
    const CommandDefaults none;
    const Choices choices(given, none, "");
    return choices.has(key) ? std::optional(choices.number(key, 0)) : std::nullopt;
}

}  // namespace

Session::Session(const GivenOptions& given, const GlobalArguments& global, const Console& console)
    : watch(typed_limit(given)), progress(console, global), global_(global)
{
}

OnProgress Session::on_progress()
{
    return [this](const Progress& now) {
        progress.show(now);
        return watch.keep_going();
    };
}

std::function<bool(double)> Session::on_time(const std::string& stage, double until, const Scene& scene)
{
    Progress now{stage, stage, 0, 0, scene.units.time.empty() ? "time units" : scene.units.time};
    progress.show(now);
    return [this, now, until](double time) mutable {
        now.amount = time;
        now.fraction = until > 0 ? time / until : 1;
        if (progress.is_due()) now.what = fmt::format("{}: t = {:.4g} of {:.4g}", now.stage, time, until);
        progress.show(now);
        return watch.keep_going();
    };
}

Scene Session::read(const std::filesystem::path& file, bool allow_overlap, const std::vector<std::string>& set)
{
    try {
        Scene scene = read_with_options(file, allow_overlap, set, global_, on_progress());
        progress.clear();
        return scene;
    } catch (const Stopped&) {
        progress.clear();
        throw CommandEnded(*watch.ended(), fmt::format("{}: {}, while it was read", file.string(), watch.reason()));
    }
}

}  // namespace carom::cli
