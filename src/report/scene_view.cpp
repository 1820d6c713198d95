#include "report/scene_view.hpp"

#include "report/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace carom::report {

namespace {

struct Box {
    Vec3 min = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 max = Vec3::Constant(-std::numeric_limits<double>::infinity());

    void add(const Vec3& x, double r)
    {
        min = min.cwiseMin(x - Vec3::Constant(r));
        max = max.cwiseMax(x + Vec3::Constant(r));
    }
    Vec3 size() const { return max - min; }
};

/// Boxes around all that is seen: the centres alone, and with the radii.
struct Seen {
    Box centres, spheres;

    void add(const Vec3& x, double r)
    {
        centres.add(x, 0);
        spheres.add(x, r);
    }
    void add(const Scene& scene, const Frames& frames)
    {
        for (const auto& frame : frames)
            for (std::size_t i = 0; i < frame.size(); ++i) {
                const Vec3 x(frame[i][0], frame[i][1], frame[i][2]);
                if (x.allFinite()) add(x, scene.spheres[i].radius);
            }
    }
};

/// The start, the reference and, where that ends early and shows little, the first run.
Seen seen(const Scene& scene, const Comparison& comparison)
{
    Seen all;
    for (const Sphere& s : scene.spheres) all.add(s.position, s.radius);
    all.add(scene, comparison.reference.tracks);
    if (comparison.reference.until < comparison.until && !comparison.rows.empty())
        all.add(scene, comparison.rows.front().series.tracks);
    if (scene.spheres.empty()) all.add(Vec3::Zero(), 1);
    return all;
}

int up_axis(const Scene& scene)
{
    int axis = 2;
    if (scene.gravity.squaredNorm() > 0) scene.gravity.cwiseAbs().maxCoeff(&axis);
    return axis;
}

/// The other axis than `without` along which `size` is the largest, the first of equals.
int longest(const Vec3& size, int without)
{
    int axis = without == 0 ? 1 : 0;
    for (int other = axis + 1; other < 3; ++other)
        if (other != without && size[other] > size[axis] * longer_across) axis = other;
    return axis;
}

/// Axes to the right and up on the page.
std::array<int, 2> view_axes(const Vec3& spread, int up)
{
    const int across = longest(spread, up), third = 3 - up - across;
    const bool from_above = spread[up] < flat_part * spread[third];
    if (from_above) return {std::min(across, third), std::max(across, third)};
    return {across, up};
}

/// A plane that faces an axis of the view, shown if it is no farther than the scene is wide.
void include_planes(const Scene& scene, const Vec3& size, Box& box)
{
    for (const Plane& plane : scene.planes)
        for (int axis = 0; axis < 3; ++axis) {
            if (std::abs(plane.normal[axis]) < facing) continue;
            const double at = plane.offset / plane.normal[axis];
            const double reach = size.maxCoeff();
            if (at < box.min[axis] - reach || at > box.max[axis] + reach) continue;
            box.min[axis] = std::min(box.min[axis], at);
            box.max[axis] = std::max(box.max[axis], at);
        }
}

std::string base64(const std::vector<std::uint8_t>& bytes)
{
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

}  // namespace

SceneView scene_view(const Scene& scene, const Comparison& comparison)
{
    Seen all = seen(scene, comparison);
    Box& box = all.spheres;
    include_planes(scene, box.size(), box);
    SceneView view;
    const int up = up_axis(scene);
    view.axes = view_axes(all.centres.size(), up);
    view.from_above = view.axes[1] != up;
    for (std::size_t k = 0; k < 2; ++k) {
        const int axis = view.axes[k];
        const double pad = view_margin * (box.max[axis] - box.min[axis]);
        view.min[k] = box.min[axis] - pad;
        view.max[k] = box.max[axis] + pad;
    }
    return view;
}

std::size_t frame_stride(std::size_t spheres, std::size_t frames, std::size_t tracks)
{
    const std::size_t points = std::max<std::size_t>(spheres * frames * tracks, 1);
    const std::size_t wanted = (points + most_points - 1) / most_points;
    const std::size_t longest_stride = frames > 1 ? frames - 1 : 1;
    return std::min(std::max<std::size_t>(wanted, 1), longest_stride);
}

std::string packed_tracks(const SceneView& view, const Frames& frames, std::size_t stride)
{
    std::vector<std::uint8_t> bytes;
    for (std::size_t k = 0; k < frames.size(); k += stride)
        for (const auto& x : frames[k])
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const double part =
                    (static_cast<double>(x[static_cast<std::size_t>(view.axes[axis])]) - view.min[axis]) /
                    (view.max[axis] - view.min[axis]);
                // A state that is not finite is drawn at the edge.
                const double clamped = part > 0 ? std::min(part, 1.0) : 0.0;
                const auto word = static_cast<std::uint16_t>(std::lround(track_steps * clamped));
                bytes.push_back(static_cast<std::uint8_t>(word & 0xffU));
                bytes.push_back(static_cast<std::uint8_t>(word >> 8U));
            }
    return base64(bytes);
}

}  // namespace carom::report
