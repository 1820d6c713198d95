/// \file
/// A trace: frames in the order of time, each with the place of every sphere of a scene.
#pragma once

#include "audit/rounding.hpp"

#include <carom/types.hpp>

#include <cstddef>
#include <vector>

namespace carom::audit {

struct Frame {
    double time = 0;           ///< since the start of the run [time]
    std::vector<Vec3> places;  ///< centres by sphere, relative to Scene::origin [length]
};

/// Frames one after the other, so that a long trace needs no memory.
class FrameSource {
public:
    virtual ~FrameSource() = default;
    virtual const TraceRounding& rounding() const = 0;
    virtual std::size_t count() const = 0;  ///< of all frames
    /// Puts the next frame into `frame`; false after the last one. \post times ascend, every place is finite
    virtual bool next(Frame& frame) = 0;
};

}  // namespace carom::audit
