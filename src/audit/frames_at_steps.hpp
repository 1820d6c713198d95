/// \file
/// The frames of a trace that fall on the steps of the engine. Between them a method that moves straight within its
/// steps shows lines with kinks, at them places of a parabola.
#pragma once

#include "audit/trace.hpp"

namespace carom::audit {

class FramesAtSteps final : public FrameSource {
public:
    /// \param trace must outlive it \param step > 0 [time]
    FramesAtSteps(FrameSource& trace, double step) : trace_(trace), step_(step) {}

    const TraceRounding& rounding() const override { return trace_.rounding(); }
    std::size_t count() const override { return trace_.count(); }  ///< of those between steps, too
    bool next(Frame& frame) override;

private:
    FrameSource& trace_;
    double step_;
};

}  // namespace carom::audit
