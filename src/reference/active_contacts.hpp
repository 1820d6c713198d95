/// \file
/// The contacts that carry force during a step of constrained motion, and how long the same ones do.
#pragma once

#include "reference/constrained.hpp"

namespace carom::reference {

/// The state in which a step begins.
template <class Real>
struct Constrained {
    Group<Real> group;          ///< all its links are closed and still
    std::vector<bool> carries;  ///< by link, as far as the accelerations of the moment tell
    std::vector<Vector<Real>> x, v;
    Numbers<Real> radii;  ///< of the bodies
};

/// A step in which all links of `group` carry.
template <class Real>
struct ActiveStep {
    Group<Real> group;
    Step<Real> step;
    Real end;  ///< when a force vanishes, at the latest the step's length [time]
};

/// The sign of p just after 0: that of its first term that counts among all, up to `length`; 0 where none is above
/// `least`.
template <class Real>
int sign_after(const Polynomial<Real>& p, const Real& length, const Real& least)
{
    const Polynomial<Real> terms = scaled(p, length);
    Real most = 0;
    for (const Real& term : terms) most = std::max<Real>(most, abs(term));
    for (const Real& term : terms)
        if (abs(term) > least && abs(term) > sign_change * most) return term < 0 ? -1 : 1;
    return 0;
}

/// The gap of a link that does not carry, or something of its sign.
template <class Real>
Polynomial<Real> gap_after(const Link<Real>& l, const Step<Real>& step)
{
    const auto& a = step.paths[l.a];
    Polynomial<Real> gap;
    if (l.bend == 0) {
        for (const Vector<Real>& c : a) gap.push_back(dot(l.n, c));
    } else {
        const std::vector<Vector<Real>> b = l.b == immovable ? std::vector<Vector<Real>>{l.anchor} : step.paths[l.b];
        gap = gap_of_squares(a, b, Real(0));
    }
    gap[0] = gap[1] = 0;
    return gap;
}

/// The step with the contacts that carry: none of them pulls, and none of the others closes. Where forces and gaps
/// vanish together the first of their derivatives that does not decides. None where that does not end.
template <class Real>
std::optional<ActiveStep<Real>> active_step(const Constrained<Real>& start, const Field<Real>& field, const Real& most,
                                            std::int64_t& roots, Patience& patience)
{
    std::vector<bool> carries = start.carries;
    const std::size_t m = carries.size();
    const Real radius = *std::min_element(start.radii.begin(), start.radii.end());
    for (std::size_t change = 0; change <= most_changes * m && patience.lasts(); ++change) {
        Chosen active;
        ActiveStep<Real> out{start.group, {}, 0};
        out.group.links.clear();
        for (std::size_t i = 0; i < m; ++i)
            if (carries[i]) active.push_back(i), out.group.links.push_back(start.group.links[i]);
        std::vector<Vector<Real>> x = start.x, v = start.v;
        project(out.group, x, v);
        out.step = step(out.group, x, v, field, start.radii, most);
        if (out.step.dependent) return std::nullopt;

        const Real& length = out.step.length;
        Real largest_force = 0;
        for (const Polynomial<Real>& f : out.step.forces)
            for (const Real& term : scaled(f, length)) largest_force = std::max<Real>(largest_force, abs(term));
        const Real least = sign_change * largest_force;
        std::size_t changes = m;
        for (std::size_t k = 0; k < active.size() && changes == m; ++k)
            if (sign_after(out.step.forces[k], length, least) < 0) changes = active[k];
        for (std::size_t i = 0; i < m && changes == m; ++i)
            if (!carries[i] &&
                sign_after(gap_after(start.group.links[i], out.step), length, Real(rounding * radius * radius)) < 0)
                changes = i;
        if (changes < m) {
            carries[changes] = !carries[changes];
            continue;
        }
        out.end = length;
        for (Polynomial<Real> f : out.step.forces) {
            while (!f.empty() && abs(f.front()) <= least) f.erase(f.begin());
            if (f.size() < 2) continue;
            if (const std::optional<Real> t = first_fall(f, out.end, roots)) out.end = *t;
        }
        return out;
    }
    return std::nullopt;
}

}  // namespace carom::reference
