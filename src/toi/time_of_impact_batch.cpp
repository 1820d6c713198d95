/// \file
/// The public query for many pairs: level 0 in blocks, and what it leaves open one by one.
#include <carom/error.hpp>
#include <carom/time_of_impact.hpp>

#include "toi/certified_time.hpp"
#include "toi/enclosure.hpp"
#include "toi/level_0.hpp"
#include "toi/scaling.hpp"
#include "toi/sphere_sphere_batch.hpp"
#include "toi/tolerances.hpp"

#include <algorithm>

namespace carom {

namespace {

/// Whatever level 0 cannot tell, and lengths that are to be scaled.
ImpactTime slow_time_of_impact(const Vec3& r, const Vec3& v, double s)
{
    if (!(largest(r) <= largest_number && largest(v) <= largest_number && s > 0 && s <= largest_number) ||
        !r.allFinite() || !v.allFinite())
        return {};
    const CertifiedTime time = certified_time(exactly(r), exactly(v), DoubleDouble(s));
    return {time.status, time.t, time.t_lo, time.t_hi};
}

void expect_same_lengths(const RelativeMotions& p, const ImpactTimes& out, bool whole)
{
    const std::size_t n = p.rx.size();
    bool same = out.status.size() == n && out.t_lo.size() == n;
    for (const auto& each : {p.ry, p.rz, p.vx, p.vy, p.vz, p.contact_distance}) same = same && each.size() == n;
    if (whole) same = same && out.t.size() == n && out.t_hi.size() == n;
    if (!same) throw InputError({"time_of_impact_batch: the arrays are not of one length"});
}

/// \param solve level 0 of a block \param settle stores the answer of another level
template <class Solve, class Settle>
void in_blocks(const RelativeMotions& p, const ImpactTimes& out, Solve&& solve, Settle&& settle)
{
    for (std::size_t first = 0; first < p.rx.size(); first += batch_block) {
        const std::size_t count = std::min(batch_block, p.rx.size() - first);
        const BatchBlock block{&p.rx[first],
                               &p.ry[first],
                               &p.rz[first],
                               &p.vx[first],
                               &p.vy[first],
                               &p.vz[first],
                               &p.contact_distance[first],
                               out.t.empty() ? nullptr : &out.t[first],
                               &out.t_lo[first],
                               out.t_hi.empty() ? nullptr : &out.t_hi[first],
                               &out.status[first]};
        if (!solve(block, count)) continue;
        for (std::size_t i = first; i < first + count; ++i) {
            if (out.status[i] != ImpactStatus::touching) continue;
            const ImpactTime time =
                slow_time_of_impact({p.rx[i], p.ry[i], p.rz[i]}, {p.vx[i], p.vy[i], p.vz[i]}, p.contact_distance[i]);
            out.status[i] = time.status;
            settle(i, time);
        }
    }
}

}  // namespace

ImpactTime quick_time_of_impact(const Vec3& r, const Vec3& v, double contact_distance)
{
    const SphereQuadratic q = sphere_quadratic(r.x(), r.y(), r.z(), v.x(), v.y(), v.z(), contact_distance);
    if (is_moderate(q)) {
        if (certainly_none(q)) return {};
        if (certainly_impact(q)) {
            const TimeEnclosure time = time_enclosure(q);
            return {ImpactStatus::impact, time.t, time.lo, time.hi};
        }
    }
    return slow_time_of_impact(r, v, contact_distance);
}

void time_of_impact_batch(const RelativeMotions& pairs, const ImpactTimes& out)
{
    expect_same_lengths(pairs, out, true);
    in_blocks(pairs, out, solve_block, [&](std::size_t i, const ImpactTime& time) {
        out.t[i] = time.t;
        out.t_lo[i] = time.t_lo;
        out.t_hi[i] = time.t_hi;
    });
}

void lower_bound_batch(const RelativeMotions& pairs, const ImpactTimes& out)
{
    expect_same_lengths(pairs, out, false);
    in_blocks(pairs, out, solve_block_lower, [&](std::size_t i, const ImpactTime& time) { out.t_lo[i] = time.t_lo; });
}

}  // namespace carom
