#include "io/trace_reader.hpp"

#include "audit/tolerances.hpp"
#include "core/patience.hpp"
#include "core/text.hpp"
#include "io/limits.hpp"

#include <carom/error.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace carom::io {

namespace {

/// The largest distance of a fixed sphere from its place in the scene.
struct Shift {
    double distance = 0, time = 0;
};

void note_fixed(const audit::Frame& frame, const Scene& scene, std::vector<Shift>& shifts)
{
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        if (!scene.spheres[i].fixed) continue;
        const double distance = (frame.places[i] - scene.spheres[i].position).norm();
        if (distance > shifts[i].distance) shifts[i] = {distance, frame.time};
    }
}

void check_fixed(const std::vector<Shift>& shifts, const Scene& scene, const audit::TraceRounding& rounding,
                 const std::string& file)
{
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        if (shifts[i].distance > rounding.place_error(scene.spheres[i].position, scene.spheres[i].radius))
            throw InputError({file + ": sphere " + quoted(scene.spheres[i].id) + " is fixed, but " +
                              to_text(shifts[i].distance, shift_digits) + " from its place in the frame t = " +
                              to_text(shifts[i].time) + " (is it the trace of this scene?)"});
}

}  // namespace

TraceReader::Examined TraceReader::examined(const std::filesystem::path& file, const Scene& scene,
                                            const OnProgress& on_progress)
{
    TraceRows rows(file, scene);
    Patience patience(on_progress);
    patience.begin("reading", static_cast<double>(std::filesystem::file_size(file)), "bytes");
    std::vector<Shift> shifts(scene.spheres.size());
    audit::Frame frame;
    std::size_t frames = 0;
    double last = 0, spacing = 0, unevenness = 0;
    for (; rows.next(frame); ++frames) {
        if (!patience.lasts(static_cast<double>(rows.bytes_read()))) throw Stopped();
        note_fixed(frame, scene, shifts);
        if (frames > 1) unevenness = std::max(unevenness, std::abs(frame.time - last - spacing));
        spacing = frame.time - last;
        last = frame.time;
    }
    if (frames < 2)
        throw InputError(
            {file.string() + ": " + (frames == 0 ? "no frame" : "one frame") + " (two are needed at least)"});
    audit::TraceRounding rounding{rows.places(), audit::spacing_roundings * audit::double_rounding * std::abs(last)};
    // Frames at equal intervals are where they say, few digits or not; others may have been rounded to their digits.
    if (unevenness > rounding.time) rounding.time = std::max(rounding.time, rows.times().of(last));
    check_fixed(shifts, scene, rounding, file.string());
    return {rounding, frames};
}

TraceReader::TraceReader(const std::filesystem::path& file, const Scene& scene, const OnProgress& on_progress)
    : examined_(examined(file, scene, on_progress)), rows_(file, scene)
{
}

}  // namespace carom::io
