/// \file
/// The quartic that the kernel never expands in rounded arithmetic, expanded in 200 digits; every root of it and of its
/// derivatives is isolated.
#pragma once

#include "support/multiprecision.hpp"
#include "toi/sphere_sphere_accelerated.hpp"
#include "unit/toi/oracle.hpp"

#include <vector>

namespace carom::test {

using Polynomial = std::vector<Float200>;  ///< coefficients, constant first

inline Float200 value(const Polynomial& p, const Float200& x)
{
    Float200 y = 0;
    for (std::size_t i = p.size(); i-- > 0;) y = y * x + p[i];
    return y;
}

inline Polynomial derivative(const Polynomial& p)
{
    Polynomial d;
    for (std::size_t i = 1; i < p.size(); ++i) d.push_back(static_cast<int>(i) * p[i]);
    return d;
}

/// Real roots in (0, bound], ascending, found between the roots of the derivative.
inline std::vector<Float200> positive_roots(const Polynomial& p, const Float200& bound)
{
    if (p.size() < 2) return {};
    if (p.size() == 2) {
        if (p[1] == 0) return {};
        const Float200 x = -p[0] / p[1];
        return x > 0 && x <= bound ? std::vector<Float200>{x} : std::vector<Float200>{};
    }
    const Polynomial slope = derivative(p);
    std::vector<Float200> cuts = positive_roots(slope, bound), roots;
    cuts.push_back(bound);
    Float200 low = 0, at_low = p[0];
    for (const Float200& cut : cuts) {
        Float200 a = low, b = cut;
        const Float200 at_cut = value(p, cut);
        if ((at_low < 0) != (at_cut < 0)) {
            // Halve until the bracket is short, then Newton kept inside it.
            Float200 x = (a + b) / 2;
            for (int i = 0; i < 400; ++i) {
                const Float200 y = value(p, x);
                if (y == 0) break;
                if ((y < 0) == (at_low < 0))
                    a = x;
                else
                    b = x;
                Float200 next = x - y / value(slope, x);
                if (!(next > a && next < b) || b - a > b / 64) next = (a + b) / 2;
                if (abs(next - x) <= abs(x) * Float200("1e-60")) break;
                x = next;
            }
            roots.push_back(x);
        }
        low = cut;
        at_low = at_cut;
    }
    return roots;
}

struct AcceleratedTruth {
    RootKind kind = RootKind::none;
    bool open = false;       ///< double-double need not tell
    bool no_digits = false;  ///< nor 200 digits: an exact double root, most likely
    Float200 t = 0;
};

inline AcceleratedTruth exact_accelerated(const Real3<Float200>& r, const Real3<Float200>& v, const Real3<Float200>& a,
                                          const Float200& s)
{
    const Polynomial f{dot(r, r) - s * s, 2 * dot(r, v), dot(v, v) + dot(r, a), dot(v, a), dot(a, a) / 4};
    const Polynomial rate = derivative(f), bend = derivative(rate);
    AcceleratedTruth truth;
    if (f[0] <= 0) {
        // What comes first after the start: rate, its rate, and so on.
        const Float200& first = rate[0] != 0 ? rate[0] : bend[0] != 0 ? bend[0] : f[3] != 0 ? f[3] : f[4];
        if (first < 0) {
            truth.kind = rate[0] < 0 ? RootKind::impact : RootKind::pressed;
            return truth;
        }
    }
    Float200 bound = 0;
    for (int i = 0; i < 4; ++i) bound += abs(f[i] / f[4]);
    bound += 1;

    const auto turns = positive_roots(rate, bound);
    const auto zeros = positive_roots(f, bound);
    Float200 first = -1;
    const auto offer = [&](const Float200& t) {
        if (first < 0 || t < first) first = t;
    };
    for (const Float200& t : zeros)
        if (value(rate, t) < 0) offer(t);
    for (const Float200& t : turns) {
        const Float200 depth = value(f, t);
        Float200 scale = 0;
        for (int k = 0; k < 3; ++k) scale += abs(r[k]) + t * abs(v[k]) + t * t * abs(a[k]);
        if (abs(depth) <= 1000 * u2 * scale * scale) truth.open = true;
        if (abs(depth) <= Float200("1e-150") * scale * scale) truth.no_digits = true;
        if (depth <= 0 && value(bend, t) < 0) offer(t);
    }
    if (first >= 0) {
        truth.kind = RootKind::impact;
        truth.t = first;
    }
    return truth;
}

inline AcceleratedTruth exact_accelerated(const AcceleratedMotion& m)
{
    return exact_accelerated(lift<Float200>(m.r), lift<Float200>(m.v), lift<Float200>(m.a), m.contact_distance);
}

}  // namespace carom::test
