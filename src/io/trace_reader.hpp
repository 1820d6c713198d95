/// \file
/// A trace from a file, read twice: once for its digits and faults, once for its frames, so that no more than one of
/// them is in memory.
#pragma once

#include "io/trace_rows.hpp"

#include <carom/progress.hpp>

namespace carom::io {

class TraceReader final : public audit::FrameSource {
public:
    /// \param scene must outlive it
    /// \throws InputError with the first fault, "FILE:LINE: what is wrong (the cure)": no table, a body that the scene
    /// does not know, a frame that lacks one, times that do not ascend, a fixed sphere that moves, fewer than two
    /// frames; Stopped
    TraceReader(const std::filesystem::path& file, const Scene& scene, const OnProgress& on_progress = {});

    const audit::TraceRounding& rounding() const override { return examined_.rounding; }
    std::size_t count() const override { return examined_.frames; }
    bool next(audit::Frame& frame) override { return rows_.next(frame); }

private:
    struct Examined {
        audit::TraceRounding rounding;
        std::size_t frames = 0;
    };
    static Examined examined(const std::filesystem::path& file, const Scene& scene, const OnProgress& on_progress);

    Examined examined_;
    TraceRows rows_;
};

}  // namespace carom::io
