#include "audit/audit_trace.hpp"

#include "audit/judge.hpp"
#include "audit/tolerances.hpp"
#include "core/patience.hpp"

#include <algorithm>
#include <vector>

namespace carom::audit {

namespace {

bool is_start_of(const Scene& scene, const SeenFrame& frame, double time_error)
{
    if (std::abs(frame.time) > time_error) return false;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        if ((frame.places[i] - scene.spheres[i].position).norm() > frame.errors[i]) return false;
    return true;
}

/// The frames of a trace as they come into view and leave it.
class Windows {
public:
    Windows(const Scene& scene, FrameSource& trace) : scene_(scene), trace_(trace), fastest_(scene.spheres.size())
    {
        while (frames_.size() < fitted_frames + 1 && take()) {
        }
        from_start_ = !frames_.empty() && is_start_of(scene, frames_.front(), trace.rounding().time);
    }

    bool has_interval() const { return begin_ + 1 < frames_.size(); }
    Window window() const { return {frames_, begin_, from_start_, trace_.rounding().time, fastest_}; }
    const SeenFrame& from() const { return frames_[begin_]; }
    const SeenFrame& to() const { return frames_[begin_ + 1]; }
    double largest_error() const { return largest_error_; }

    void advance()
    {
        take();
        ++begin_;
        if (begin_ < fitted_frames) return;
        frames_.erase(frames_.begin());
        --begin_;
        from_start_ = false;
    }

private:
    bool take()
    {
        Frame frame;
        if (!trace_.next(frame)) return false;
        SeenFrame seen{frame.time, std::move(frame.places), {}};
        seen.errors.reserve(seen.places.size());
        for (std::size_t i = 0; i < seen.places.size(); ++i)
            seen.errors.push_back(trace_.rounding().place_error(seen.places[i], scene_.spheres[i].radius));
        for (const double error : seen.errors) largest_error_ = std::max(largest_error_, error);
        if (!frames_.empty()) note_speeds(frames_.back(), seen);
        frames_.push_back(std::move(seen));
        return true;
    }

    void note_speeds(const SeenFrame& from, const SeenFrame& to)
    {
        for (std::size_t i = 0; i < fastest_.size(); ++i)
            fastest_[i] = std::max(fastest_[i], (to.places[i] - from.places[i]).norm() / (to.time - from.time));
    }

    const Scene& scene_;
    FrameSource& trace_;
    std::vector<double> fastest_;    ///< by sphere, as Window has it
    std::vector<SeenFrame> frames_;  ///< those of a window: some before the interval, as many behind it
    std::size_t begin_ = 0;
    bool from_start_ = false;
    double largest_error_ = 0;
};

}  // namespace

TraceAudit audit_trace(const Scene& scene, FrameSource& trace, const OnProgress& on_progress)
{
    Patience patience(on_progress);
    Windows windows(scene, trace);
    Judge judge(scene);
    TraceAudit& report = judge.report();
    report.begin = report.end = windows.has_interval() ? windows.from().time : 0;
    report.frames = windows.has_interval() ? 1 : 0;
    patience.begin("audit", static_cast<double>(trace.count()), "frames");
    for (; windows.has_interval(); windows.advance()) {
        if (!patience.lasts(static_cast<double>(report.frames))) {
            report.whole = false;
            break;
        }
        judge.judge(interval_of(scene, windows.window()), windows.from(), windows.to());
        report.end = windows.to().time;
        ++report.frames;
    }
    report.place_error = windows.largest_error();
    judge.finish();
    return std::move(report);
}

}  // namespace carom::audit
