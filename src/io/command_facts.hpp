/// \file
/// Facts of a command as a whole, for its files.
#pragma once

#include <carom/simulate.hpp>

#include <optional>

namespace carom::io {

struct CommandFacts {
    double seconds = 0;             ///< on the clock, from its start until these were taken [s]
    double cpu_seconds = 0;         ///< of the process, in that time [s]
    std::optional<Status> stopped;  ///< interrupted or time_limit, if it ended early
};

/// Keys command_seconds and command_cpu_seconds.
template <class Json>
void put_seconds(Json& json, const CommandFacts& facts)
{
    json["command_seconds"] = facts.seconds;
    json["command_cpu_seconds"] = facts.cpu_seconds;
}

/// Key stopped: "interrupted", "time_limit", or null.
template <class Json>
void put_stopped(Json& json, const CommandFacts& facts)
{
    json["stopped"] = facts.stopped ? Json(name(*facts.stopped)) : Json(nullptr);
}

}  // namespace carom::io
