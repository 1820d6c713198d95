#include "verify/pair_gap.hpp"

#include <algorithm>

namespace carom::verification {

namespace {

/// Values and error bounds of F = |r|^2 - S^2, half its rate B = r.v, and A = v.v.
template <class N>
struct Quadratic {
    N f, b, a;
    double f_error = 0, b_error = 0, a_error = 0;
};

template <class N>
Quadratic<N> quadratic(const Relative<N>& s, const Contact<N>& contact)
{
    Quadratic<N> q;
    const N rr = dot(s.r, s.r);
    q.f = rr - contact.square;
    q.b = dot(s.r, s.v);
    q.a = dot(s.v, s.v);
    if constexpr (rounding < N >> 0) {
        const Vec3 r = rounded(s.r).cwiseAbs(), v = rounded(s.v).cwiseAbs();
        q.f_error = 2 * r.dot(s.r_error) + s.r_error.squaredNorm() + rounding<N> * (rounded(rr) + contact.size);
        q.b_error = r.dot(s.v_error) + v.dot(s.r_error) + s.r_error.dot(s.v_error) + rounding<N> * r.dot(v);
        q.a_error = 2 * v.dot(s.v_error) + s.v_error.squaredNorm() + rounding<N> * rounded(q.a);
    }
    return q;
}

/// The square of the distance at which the two touch. The sum of radii is exact for double-double.
template <class N>
Contact<N> contact_of(const PairSegment& s)
{
    if (s.initial_a != nullptr) {
        const Vec3 none = Vec3::Zero();
        const Relative<N> initial = relative<N>(*s.initial_a, none, *s.initial_b, none, s.initial_a->start);
        Contact<N> contact{dot(initial.r, initial.r), 0};
        if constexpr (rounding < N >> 0) {
            const Vec3 sizes = initial.r_error / rounding<N>;
            contact.size = rounded(contact.square) + 2 * rounded(initial.r).cwiseAbs().dot(sizes) + sizes.squaredNorm();
        }
        return contact;
    }
    const N sum = joined<N>(s.radius_a + s.radius_b, 0) +
                  N(std::is_same_v<N, double> ? 0.0 : two_sum(s.radius_a, s.radius_b).low);
    const double size = s.radius_a + s.radius_b;
    return {sum * sum, size * size};
}

/// Smallest value of |r + v t|^2 - S^2, whose values at the ends and at all times are here.
template <class N>
Least least_of(const Quadratic<N>& start, const Quadratic<N>& end, double duration, const Relative<N>& s,
               const Contact<N>& contact)
{
    const double b0 = rounded(start.b), b1 = rounded(end.b);
    const double f0 = rounded(start.f), f1 = rounded(end.f);
    if (b0 >= start.b_error) return {f0, start.f_error, true, false};
    if (b1 <= -end.b_error) return {f1, end.f_error, false, false};
    // The tangents at the ends are below the parabola; so is its vertex.
    const double below0 = f0 - 2 * (std::max(0.0, -b0) + start.b_error) * duration;
    const double below1 = f1 - 2 * (std::max(0.0, b1) + end.b_error) * duration;
    const Least by_tangent = {std::min(f0, f1),
                              std::max(start.f_error, end.f_error) + std::min(f0, f1) - std::max(below0, below1),
                              f0 <= f1, false};
    const double a = rounded(start.a) - start.a_error;
    if (!(a > 0)) return by_tangent;
    const Vector<N> c = cross(s.r, s.v);
    const N k = dot(c, c);
    const N numerator = k - start.a * contact.square;
    const Vec3 r = rounded(s.r).cwiseAbs(), v = rounded(s.v).cwiseAbs();
    const auto part = [&](int i, int j) {
        return r[i] * s.v_error[j] + v[j] * s.r_error[i] + s.r_error[i] * s.v_error[j] + rounding<N> * r[i] * v[j];
    };
    const Vec3 c_error(part(1, 2) + part(2, 1), part(2, 0) + part(0, 2), part(0, 1) + part(1, 0));
    const double size = rounded(k) + rounded(start.a) * contact.size;
    const double error = 2 * rounded(c).cwiseAbs().dot(c_error) + c_error.squaredNorm() + rounding<N> * size +
                         start.a_error * contact.size;
    const Least vertex = {rounded(numerator) / a, error / a + vertex_rounding * std::abs(rounded(numerator) / a), false,
                          false};
    return vertex.value - vertex.error > by_tangent.value - by_tangent.error ? vertex : by_tangent;
}

template <class N>
Least least(const PairSegment& s)
{
    const Contact<N> contact = contact_of<N>(s);
    if (s.acceleration_a != s.acceleration_b) return least_accelerated<N>(s, contact);
    const Relative<N> start = relative<N>(s.a, s.acceleration_a, s.b, s.acceleration_b, s.from);
    const Quadratic<N> at_start = quadratic(start, contact);
    const double b0 = rounded(at_start.b);
    if (b0 >= at_start.b_error) return {rounded(at_start.f), at_start.f_error, true, false};
    const double duration = between<double>(s.from, s.to) * (1 + duration_rounding) + offsets_rounding;
    if constexpr (std::is_same_v<N, double>) {
        // F stays above its tangent: most pairs are done here.
        const double tangent = at_start.f - at_start.f_error + 2 * (b0 - at_start.b_error) * duration;
        if (tangent > 0) return {tangent * (1 - tangent_rounding), 0, false, false};
    }
    Relative<N> end = relative<N>(s.a, s.acceleration_a, s.b, s.acceleration_b, s.to);
    if (s.a.drag > 0) {
        // r(t) = r + v way(t): as straight as without drag, in a variable that grows as t does, and slower.
        end.v = start.v;
        end.v_error = start.v_error;
    }
    return least_of(at_start, quadratic(end, contact), duration, start, contact);
}

/// Is |r|^2 >= S^2 throughout? 1 yes, -1 no, 0 cannot be told.
int exact_answer(const PairSegment& s)
{
    if (s.acceleration_a != s.acceleration_b) return 0;
    if (s.a.drag > 0 && !(s.to == s.a.start && s.to == s.b.start)) return 0;
    const Exact contact = contact_of<Exact>(s).square;
    const auto answer = [](const Exact& value) { return !value.sound() ? 0 : value.sign() < 0 ? -1 : 1; };
    const Relative<Exact> start = relative<Exact>(s.a, s.acceleration_a, s.b, s.acceleration_b, s.from);
    const Exact b0 = dot(start.r, start.v);
    if (!b0.sound()) return 0;
    if (b0.sign() >= 0) return answer(dot(start.r, start.r) - contact);
    const Relative<Exact> end = relative<Exact>(s.a, s.acceleration_a, s.b, s.acceleration_b, s.to);
    const Exact b1 = dot(end.r, end.v);
    if (!b1.sound()) return 0;
    if (b1.sign() <= 0) return answer(dot(end.r, end.r) - contact);
    const Vector<Exact> c = cross(start.r, start.v);
    return answer(dot(c, c) - dot(start.v, start.v) * contact);
}

/// The gap that belongs to |r|^2 - S^2.
double gap_of(double f, double contact)
{
    return f / (std::sqrt(std::max(0.0, f + contact * contact)) + contact);
}

}  // namespace

bool is_clear(const PairSegment& s, double smallest)
{
    const Least plain = least<double>(s);
    const double needed = std::max(0.0, smallest * (smallest + 2 * (s.radius_a + s.radius_b)));
    return !plain.open && plain.value - plain.error > needed;
}

GapFound examine(const PairSegment& s, double bound)
{
    GapFound found;
    const double contact = s.radius_a + s.radius_b;
    const Least finer = least<DoubleDouble>(s);
    found.level = Level::double_double;
    found.at_start = finer.at_start;
    if (finer.open) {
        found.grade = Grade::not_certified;
        return found;
    }
    found.gap = gap_of(finer.value, contact);
    found.measured = true;
    const double low = finer.value - finer.error;
    if (low >= 0) return found;
    const double allowed = -2 * contact * bound;
    if (finer.value + finer.error >= 0) {  // the sign is open
        found.level = Level::exact;
        const int answer = exact_answer(s);
        found.grade = answer > 0 ? Grade::exact : low >= allowed ? Grade::bounded : Grade::not_certified;
        return found;
    }
    found.grade = low >= allowed                        ? Grade::bounded
                  : finer.value + finer.error < allowed ? Grade::violated
                                                        : Grade::not_certified;
    return found;
}

}  // namespace carom::verification
