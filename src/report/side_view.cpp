#include "report/side_view.hpp"

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
};

Box seen_box(const Scene& scene, const Comparison& comparison)
{
    Box box;
    for (const Sphere& s : scene.spheres) box.add(s.position, s.radius);
    for (const auto& frame : comparison.reference.tracks)
        for (std::size_t i = 0; i < frame.size(); ++i)
            box.add(Vec3(frame[i][0], frame[i][1], frame[i][2]), scene.spheres[i].radius);
    if (scene.spheres.empty()) box.add(Vec3::Zero(), 1);
    return box;
}

/// Where the reference ends early, its tracks show little: then those of the first run say where things go.
void add_first_row(const Scene& scene, const Comparison& comparison, Box& box)
{
    if (comparison.reference.until >= comparison.until || comparison.rows.empty()) return;
    for (const auto& frame : comparison.rows.front().series.tracks)
        for (std::size_t i = 0; i < frame.size(); ++i) {
            const Vec3 x(frame[i][0], frame[i][1], frame[i][2]);
            if (x.allFinite()) box.add(x, scene.spheres[i].radius);
        }
}

int up_axis(const Scene& scene)
{
    int axis = 2;
    if (scene.gravity.squaredNorm() > 0) scene.gravity.cwiseAbs().maxCoeff(&axis);
    return axis;
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

SideView side_view(const Scene& scene, const Comparison& comparison)
{
    Box box = seen_box(scene, comparison);
    add_first_row(scene, comparison, box);
    const Vec3 size = box.max - box.min;
    include_planes(scene, size, box);
    SideView view;
    const int up = up_axis(scene);
    int across = up == 0 ? 1 : 0;
    for (int axis = 0; axis < 3; ++axis)
        if (axis != up && size[axis] > size[across] * longer_across) across = axis;
    view.axes = {across, up};
    for (std::size_t k = 0; k < 2; ++k) {
        const int axis = view.axes[k];
        const double pad = view_margin * (box.max[axis] - box.min[axis]);
        view.min[k] = box.min[axis] - pad;
        view.max[k] = box.max[axis] + pad;
    }
    return view;
}

std::string packed_tracks(const SideView& view, const Frames& frames, std::size_t stride)
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
