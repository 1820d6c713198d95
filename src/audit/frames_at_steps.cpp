#include "audit/frames_at_steps.hpp"

#include "audit/tolerances.hpp"

#include <cmath>

namespace carom::audit {

bool FramesAtSteps::next(Frame& frame)
{
    while (trace_.next(frame)) {
        const double nearest = std::round(frame.time / step_) * step_;
        const double error = trace_.rounding().time + spacing_roundings * double_rounding * std::abs(frame.time);
        if (std::abs(frame.time - nearest) <= error) return true;
    }
    return false;
}

}  // namespace carom::audit
