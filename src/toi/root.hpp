/// \file
/// The answer of a time-of-impact query.
#pragma once

#include <cstdint>

namespace carom {

enum class RootKind : std::uint8_t {
    none,    ///< never, as these motions go on
    impact,  ///< at t >= 0 the gap is <= 0 and closing
    pressed  ///< the gap is closed, its speed is 0 and the accelerations press: a persistent contact, not an event
};

struct Root {
    RootKind kind = RootKind::none;
    double t = 0;            ///< from the common time of the query; meaningful for impact [time]
    std::uint8_t level = 0;  ///< arithmetic that decided: 0 double, 1 double-double, 2 exact
};

}  // namespace carom
