/// \file
/// Sensible changes of a recording.
#pragma once

#include "fuzz/fuzz.hpp"
#include "fuzz/recording_parts.hpp"

namespace carom::fuzz {

/// One change: a number of an event or flight, a row left out, doubled or exchanged, a chunk, a body, a word of meta.
void mutate_recording(RecordingParts& parts, Random& random);

}  // namespace carom::fuzz
