#include "verify/plane_gap.hpp"

#include <algorithm>

namespace carom::verification {

namespace {

constexpr std::int64_t origin[3] = {0, 0, 0};

/// Height above contact and its rate, with error bounds.
template <class N>
struct Height {
    N h, w;
    double h_error = 0, w_error = 0;
};

template <class N>
Height<N> height_at(const WallSegment& s, const Path& path, const Vec3& acceleration, const EpochTime& at)
{
    const Moving<N> m = moving<N>(path, acceleration, origin, at);
    const Vec3 normal = s.side * s.wall.normal;
    const Vector<N> n{N(normal.x()), N(normal.y()), N(normal.z())};
    Height<N> h;
    h.h = ((dot(n, m.place) - N(s.side * s.wall.offset)) - N(s.wall.half_thickness)) - N(s.radius);
    h.w = dot(n, m.speed);
    if constexpr (rounding < N >> 0) {
        const Vec3 size = normal.cwiseAbs();
        h.h_error =
            2 * rounding<N> * (size.dot(m.place_size) + std::abs(s.wall.offset) + s.wall.half_thickness + s.radius);
        h.w_error = 2 * rounding<N> * size.dot(m.speed_size);
    }
    return h;
}

template <class N>
Height<N> height_at(const WallSegment& s, const EpochTime& at)
{
    return height_at<N>(s, s.path, s.acceleration, at);
}

/// The height that must be kept: 0, or that of the start.
template <class N>
Height<N> needed(const WallSegment& s)
{
    if (s.initial == nullptr) return {N(0.0), N(0.0)};
    return height_at<N>(s, *s.initial, Vec3::Zero(), s.initial->start);
}

template <class N>
N pull(const WallSegment& s)
{
    const Vec3 n = s.side * s.wall.normal;
    return N(n.x()) * N(s.acceleration.x()) + N(n.y()) * N(s.acceleration.y()) + N(n.z()) * N(s.acceleration.z());
}

/// The second derivative of the height at the beginning, n.(a - k v), with an error bound. Drag shrinks it and never
/// turns its sign: a height is convex throughout, or concave.
template <class N>
struct Bend {
    N value;
    double error;
};

template <class N>
Bend<N> bend(const WallSegment& s, const Height<N>& start)
{
    const double error = rounding<N> * s.wall.normal.cwiseAbs().dot(s.acceleration.cwiseAbs());
    if (!(s.path.drag > 0)) return {pull<N>(s), error};
    return {pull<N>(s) - N(s.path.drag) * start.w, error + 2 * s.path.drag * start.w_error};
}

/// Lower bound of a convex damped height: the tangent at a time near its vertex, and that time need not be the right
/// one. \param g least second derivative at the beginning, > 0 \param duration of the segment, an upper bound
template <class N>
Least above_tangent(const WallSegment& s, const Height<N>& zero, double w, double g, double duration)
{
    const double k = s.path.drag, still = std::log1p(-k * w / rounded(pull<N>(s))) / k;  // where the speed is 0
    const double t = std::min(duration, still >= 0 ? still : duration), whole = std::floor(t);
    const EpochTime at{s.from.epoch + static_cast<std::int64_t>(whole), s.from.offset + (t - whole)};
    const Height<N> there = height_at<N>(s, at);
    const double slope = std::abs(rounded(there.w)) + there.w_error;
    const double reach = std::max(t, duration - t) * (1 + duration_rounding) + offsets_rounding;
    const double flattest = g * damped<double>(k, DoubleDouble(duration)).decay;
    // Quadratic in the slope where the height bends enough to the end.
    const double below = std::min(slope * reach, slope * slope / flattest);
    const double error = there.h_error + zero.h_error + (below >= 0 ? below : slope * reach);
    return {rounded(there.h - zero.h), error, false, false};
}

template <class N>
Least least(const WallSegment& s)
{
    Height<N> start = height_at<N>(s, s.from), end = height_at<N>(s, s.to);
    const Height<N> zero = needed<N>(s);
    const double h0 = rounded(start.h - zero.h), h1 = rounded(end.h - zero.h);
    const double e0 = start.h_error + zero.h_error, e1 = end.h_error + zero.h_error;
    const double w0 = rounded(start.w), w1 = rounded(end.w);
    const Least ends{std::min(h0, h1), std::max(e0, e1), h0 <= h1, false};
    const Bend<N> bent = bend(s, start);
    const double g = rounded(bent.value), g_error = bent.error;
    if (g <= -g_error) return ends;
    if (g >= g_error && w0 >= start.w_error) return {h0, e0, true, false};
    if (g >= g_error && w1 <= -end.w_error) return {h1, e1, false, false};
    // Convex, or as good as straight, and lowest in between: above its vertex, and above its chord but for the bulge.
    const double duration = between<double>(s.from, s.to) * (1 + duration_rounding) + offsets_rounding;
    const double bulge = (g + g_error) * duration * duration / 8;
    Least least = ends;
    least.error += bulge;
    if (g > 2 * g_error && s.path.drag > 0) {
        const Least vertex = above_tangent<N>(s, zero, w0, g - g_error, duration);
        if (vertex.value - vertex.error > least.value - least.error) least = vertex;
    } else if (g > 2 * g_error) {
        const N square = start.w * start.w;
        const double drop = rounded(square) / (2 * g);
        const double vertex = rounded((start.h - zero.h) - square / (pull<N>(s) * N(2.0)));
        const double error =
            e0 + std::abs(w0) * start.w_error / g + drop * (4 * g_error / g + drop_roundings * rounding<N>);
        if (vertex - error > least.value - least.error) least = {vertex, error, false, false};
    }
    return least;
}

/// Is the height kept throughout? 1 yes, -1 no, 0 cannot be told.
int exact_answer(const WallSegment& s)
{
    if (s.path.drag > 0 && s.to != s.path.start) return 0;
    const auto answer = [](const Exact& value) { return !value.sound() ? 0 : value.sign() < 0 ? -1 : 1; };
    const Height<Exact> start = height_at<Exact>(s, s.from), end = height_at<Exact>(s, s.to);
    const Exact zero = needed<Exact>(s).h, g = pull<Exact>(s);
    const Exact h0 = start.h - zero, h1 = end.h - zero;
    const int ends = std::min(answer(h0), answer(h1));
    if (!g.sound() || !start.w.sound() || !end.w.sound()) return 0;
    if (g.sign() <= 0 || start.w.sign() >= 0 || end.w.sign() <= 0) return ends;
    return std::min(ends, answer(Exact(2.0) * g * h0 - start.w * start.w));
}

}  // namespace

bool is_clear(const WallSegment& s, double smallest)
{
    const Least plain = least<double>(s);
    return plain.value - plain.error > std::max(0.0, smallest);
}

GapFound examine(const WallSegment& s, double bound)
{
    GapFound found;
    const Least finer = least<DoubleDouble>(s);
    found.level = Level::double_double;
    found.at_start = finer.at_start;
    found.gap = finer.value;
    found.measured = true;
    const double low = finer.value - finer.error;
    if (low >= 0) return found;
    if (finer.value + finer.error >= 0) {  // the sign is open
        found.level = Level::exact;
        const int answer = exact_answer(s);
        found.grade = answer > 0 ? Grade::exact : low >= -bound ? Grade::bounded : Grade::not_certified;
        return found;
    }
    found.grade = low >= -bound                        ? Grade::bounded
                  : finer.value + finer.error < -bound ? Grade::violated
                                                       : Grade::not_certified;
    return found;
}

double side_of(const Wall& wall, const Path& path)
{
    if (!wall.is_plate) return 1;
    const Moving<DoubleDouble> m = moving<DoubleDouble>(path, Vec3::Zero(), origin, path.start);
    const Vector<DoubleDouble> n{wall.normal.x(), wall.normal.y(), wall.normal.z()};
    return rounded(dot(n, m.place) - DoubleDouble(wall.offset)) < 0 ? -1 : 1;
}

double largest_distance(const WallSegment& s)
{
    const Height<DoubleDouble> start = height_at<DoubleDouble>(s, s.from), end = height_at<DoubleDouble>(s, s.to);
    const double duration = between<double>(s.from, s.to);
    const double g = std::abs(rounded(bend(s, start).value));
    return std::max(std::abs(rounded(start.h)) + start.h_error, std::abs(rounded(end.h)) + end.h_error) +
           arc_rounded_up * g * duration * duration / 8;
}

DoubleDouble height(const WallSegment& s, const EpochTime& at)
{
    return height_at<DoubleDouble>(s, at).h;
}

}  // namespace carom::verification
