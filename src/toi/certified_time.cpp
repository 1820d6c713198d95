#include "toi/certified_time.hpp"

#include "toi/accelerated_enclosure.hpp"
#include "toi/plane_solver.hpp"
#include "toi/scene_plane.hpp"
#include "toi/tolerances.hpp"

#include <algorithm>
#include <limits>

namespace carom {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double rounded_down(double t)
{
    return t;
}
double rounded_up(double t)
{
    return t;
}
double rounded_down(DoubleDouble t)
{
    return t.low < 0 ? std::nextafter(t.high, -infinity) : t.high;
}
double rounded_up(DoubleDouble t)
{
    return t.low > 0 ? std::nextafter(t.high, infinity) : t.high;
}

template <class Number>
CertifiedTime as_time(const Enclosure<Number>& e)
{
    CertifiedTime out;
    out.level = e.level;
    const bool now = head(e.t_hi) == 0;
    if (e.decided == Decision::none || e.decided == Decision::ambiguous || !(head(e.t) < infinity)) return out;
    if (e.decided == Decision::pressed || now) {
        out.status = ImpactStatus::touching;
        return out;
    }
    out.status = ImpactStatus::impact;
    out.t_lo = std::max(rounded_down(e.t_lo), 0.0);
    out.t_hi = rounded_up(e.t_hi);
    out.t = std::max(head(e.t), std::numeric_limits<double>::denorm_min());
    out.sharp = out.t == head(e.t) ? DoubleDouble(e.t) : DoubleDouble(out.t);
    return out;
}

/// Did double arithmetic alone decide between now, later and never?
bool is_decided(const Enclosure<double>& e)
{
    return e.decided == Decision::none || e.decided == Decision::pressed ||
           (e.decided == Decision::impact && (e.t_lo > 0 || e.t_hi == 0));
}

Vec3 heads(const DoubleDouble3& a)
{
    return {a.x.high, a.y.high, a.z.high};
}

bool is_zero(const DoubleDouble3& a)
{
    return a.x.high == 0 && a.y.high == 0 && a.z.high == 0;
}

}  // namespace

CertifiedTime certified_time(const ExactMotion& m)
{
    if (!is_zero(m.a)) return as_time(enclose_accelerated(m));
    return certified_time(m.r, m.v, m.contact_distance);
}

CertifiedTime certified_time(const DoubleDouble3& r, const DoubleDouble3& v, DoubleDouble contact_distance)
{
    const Enclosure<double> quick = enclose(heads(r), heads(v), contact_distance.high);
    if (quick.decided == Decision::none) return as_time(quick);
    CertifiedTime out = as_time(enclose(r, v, contact_distance));
    if (is_decided(quick)) out.level = 0;
    return out;
}

CertifiedTime certified_time(const ScenePlane& plane)
{
    const Bounded h = plane.bounded_h(), w = plane.bounded_w(), g = plane.bounded_g();
    const auto error = [](const Bounded& x) { return x.error + low_part * std::abs(x.value.high); };
    const Enclosure<double> quick =
        enclose_plane(h.value.high, w.value.high, g.value.high, {error(h), error(w), error(g)});
    if (quick.decided == Decision::none) return as_time(quick);
    CertifiedTime out = as_time(PlaneSolver<DoubleDouble, ScenePlane>(h, w, g, plane).solve());
    if (is_decided(quick)) out.level = 0;
    return out;
}

}  // namespace carom
