/// \file
/// First instants of contact of flights with drag and of those whose accelerations differ, by the rule of roots.hpp.
#pragma once

#include "reference/damping.hpp"
#include "reference/roots.hpp"

namespace carom::reference {

/// First t in [0, end] at which the gap h + w s + g q of a sphere and a plane closes: it turns once at most.
template <class Real>
std::optional<Real> damped_plane_contact(const Real& h, const Real& w, const Real& g, const Real& k, const Real& end,
                                         std::int64_t& roots)
{
    if (h <= 0 && (w < 0 || (w == 0 && g < 0))) return Real(0);
    if (w >= 0 && g >= 0) return std::nullopt;
    const auto gap = [&](const Real& t) {
        const Damped<Real> d = damped(k, t);
        return std::pair<Real, Real>(h + w * d.s + g * d.q, w + (g - k * w) * d.s);
    };
    const Real turn = w * g < 0 ? time_of<Real>(k, w / (k * w - g)).value_or(end) : Real(0);
    if (h < 0 && turn < end && gap(turn).first <= 0) return turn;  // turns while still inside
    const Real low = w > 0 ? turn : Real(0);
    Real high = w < 0 && g > 0 ? std::min<Real>(end, turn) : end;
    if (h == 0)
        high = std::min<Real>(end, 4 * w / -g);  // far below: without drag it closes at half of that, with it before
    if (low >= high || gap(high).first > 0) return std::nullopt;
    ++roots;
    return bracketed_root<Real>(gap, low, high);
}

/// Half of |r + w s + a q|^2 - sum^2 of two spheres: no polynomial where there is drag, so pieces are sought in which
/// it is monotone.
template <class Real>
class DistanceGap {
public:
    DistanceGap(const Vector<Real>& r, const Vector<Real>& w, const Vector<Real>& a, const Real& k, const Real& sum)
        : r_(r), w_(w), a_(a), change_(a - w * k), k_(k)
    {
        const Vector<Real> second = change_ * Real(0.5), third = second * (-k / 3);
        terms_ = gap_of_squares<Real>({r, w, second, third, third * (-k / 4)}, {}, sum);
        terms_.resize(5);  // those of the next order are not all there
        if (abs(terms_[2]) <= sign_change * sum * size(a)) terms_[2] = 0;
        along_ = terms_[1] / 2;
        pull_ = terms_[2] - dot(w, w) + k * along_;
    }

    /// First t in [0, end] at which it falls through 0.
    std::optional<Real> first_fall(const Real& end, std::int64_t& roots) const
    {
        if (falls_at_once(terms_)) return Real(0);
        return first_fall(Real(0), end, most_damped_halvings, roots);
    }

private:
    /// Its value and rate.
    std::pair<Real, Real> at(const Real& t) const
    {
        const Damped<Real> d = damped(k_, t);
        const Vector<Real> way = w_ * d.s + a_ * d.q;
        return {terms_[0] / 2 + along_ * d.s + pull_ * d.q + dot(way, way) / 2,
                along_ + (pull_ - k_ * along_) * d.s + dot(way, w_ + change_ * d.s)};
    }

    /// Taylor's formula around the middle tells pieces without a root, and those that are monotone; others are halved.
    std::optional<Real> first_fall(const Real& low, const Real& high, int halvings, std::int64_t& roots) const
    {
        const Real half = (high - low) / 2, middle = low + half;
        const Damped<Real> d = damped(k_, middle);
        const Vector<Real> x = r_ + w_ * d.s + a_ * d.q, v = w_ + change_ * d.s, a = a_ - v * k_;
        const Real most_a = size(change_ * (1 - k_ * damped(k_, low).s)), most_v = size(v) + half * most_a;
        const Real third = most_a * (3 * most_v + k_ * (size(x) + half * most_v));
        const Real bend = abs(dot(v, v) + dot(x, a)) + third * half;
        const auto [value, slope] = at(middle);
        if (abs(value) > (abs(slope) + bend * half / 2) * half) return std::nullopt;
        if (abs(slope) > bend * half) {
            if (slope > 0 || at(low).first < 0 || at(high).first > 0) return std::nullopt;
            ++roots;
            return bracketed_root<Real>([this](const Real& t) { return at(t); }, low, high);
        }
        if (halvings == 0) return std::nullopt;  // a double root: a graze, not a contact
        const std::optional<Real> t = first_fall(low, middle, halvings - 1, roots);
        return t ? t : first_fall(middle, high, halvings - 1, roots);
    }

    Vector<Real> r_, w_, a_, change_;
    Real k_, along_, pull_;  ///< drag, r.w, r.a
    Polynomial<Real> terms_;
};

}  // namespace carom::reference
