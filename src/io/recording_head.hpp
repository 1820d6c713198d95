/// \file
/// Head of a recording: what stands before its chunks, and what the end of a run added to it.
#pragma once

#include "io/recording_bodies.hpp"

namespace carom::io {

struct RecordingHead {
    RecordedRun run;
    Meta meta;
    std::string scene;           ///< document
    bool finished = false;       ///< the run came to an end, which is in `run`
    std::uint32_t checksum = 0;  ///< to be carried on
};

/// \throws InputError if this is no recording, or damaged
RecordingHead read_head(Database& database);
/// Id of a sphere or plane as events number them. \throws InputError
std::string read_body_name(Database& database, const RecordedRun& run, BodyId body);

/// A whole number among the words about the run. \throws InputError
std::int64_t whole_number(const Meta& meta, const char* key, const std::string& file);

[[noreturn]] void damaged(const std::string& file, const std::string& why);

}  // namespace carom::io
