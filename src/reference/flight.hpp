/// \file
/// The path of a sphere between two of its events.
#pragma once

#include "reference/damping.hpp"
#include "reference/limits.hpp"
#include "reference/vector.hpp"

#include <vector>

namespace carom::reference {

/// What acts on every sphere that moves.
template <class Real>
struct Field {
    Vector<Real> gravity;  ///< [length/time^2]
    Real drag;             ///< k of dv/dt = gravity - k v [1/time]
};

/// A parabola, with drag a damped flight, or where contacts with turning normals carry the sphere a polynomial of
/// higher degree.
template <class Real>
struct Flight {
    Real t = 0;  ///< its start, since the start of the run [time]
    Vector<Real> x, v, a;
    std::vector<Vector<Real>> higher;  ///< coefficients of (at - t)^3 and up
    Real drag = 0;                     ///< k, 0 in a polynomial, whose coefficients have it

    Vector<Real> position(const Real& at) const
    {
        const Real s = at - t;
        if (drag > 0) {
            const Damped<Real> d = damped(drag, s);
            return x + v * d.s + a * d.q;
        }
        Vector<Real> sum = a * Real(0.5);
        if (!higher.empty()) sum = sum + tail(s, [](int) { return 1; });
        return x + (v + sum * s) * s;
    }
    Vector<Real> velocity(const Real& at) const
    {
        const Real s = at - t;
        if (drag > 0) return v + (a - v * drag) * damped(drag, s).s;
        return higher.empty() ? v + a * s : v + (a + tail(s, [](int k) { return k; })) * s;
    }
    /// Coefficients of its powers of (time - at), as many as it has; of a damped flight those that count for a time of
    /// 1 / drag.
    std::vector<Vector<Real>> coefficients(const Real& at) const
    {
        if (drag > 0) {
            std::vector<Vector<Real>> c{position(at), velocity(at)};
            for (Vector<Real> term = (a - c[1] * drag) * Real(0.5); c.size() < step_terms<Real>;
                 term = term * (-drag / static_cast<int>(c.size())))
                c.push_back(term);
            return c;
        }
        if (higher.empty()) return {position(at), velocity(at), a * Real(0.5)};
        std::vector<Vector<Real>> c{x, v, a * Real(0.5)};
        c.insert(c.end(), higher.begin(), higher.end());
        const Real s = at - t;
        if (s == 0) return c;
        for (std::size_t low = 0; low + 1 < c.size(); ++low)
            for (std::size_t k = c.size() - 1; k-- > low;) c[k] = c[k] + c[k + 1] * s;
        return c;
    }

private:
    /// Sum of factor(k) times coefficient k times s^(k-2), k >= 3.
    template <class Factor>
    Vector<Real> tail(const Real& s, Factor factor) const
    {
        Vector<Real> sum;
        for (std::size_t k = higher.size(); k-- > 0;)
            sum = (sum + higher[k] * Real(factor(static_cast<int>(k) + 3))) * s;
        return sum;
    }
};

}  // namespace carom::reference
