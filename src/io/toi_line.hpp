/// \file
/// A time-of-impact query as a line of JSON, and its answer as another.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace carom::io {

/// {"a": {"p": [x,y,z], "v": [..], "acc": [..], "r": 1}, "b": {..} or "plane": {"n": [..], "offset": 0}, "until": 1e9}
/// in; {"status": "impact" | "none" | "touching" | "error", "t": .., "lo": .., "hi": .., "normal": [..],
/// "approach_speed": .., "level": 0} out, without a line break. Bodies that overlap at t = 0 have one key more,
/// "overlap", how deep [length]: where they do not approach they are in no impact, and the status is none or a later
/// impact. Numbers read back as the same doubles; what does not exist is null. A line that is no query is answered with
/// {"status": "error", "message": ".."}. Never throws but for want of memory. A normal is normalised unless it is of
/// unit length to rounding; an impact whose t is beyond "until" is none.
std::string answer_toi_line(std::string_view line);

}  // namespace carom::io
