#include "toi/quartic_gap.hpp"

#include "toi/scaling.hpp"
#include "toi/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

Dyadic power_of_two(int exponent)
{
    return Dyadic(std::ldexp(1, exponent / 2)) * Dyadic(std::ldexp(1, exponent - exponent / 2));
}

}  // namespace

int natural_time(const ExactMotion& m)
{
    const double length = std::max(largest(m.r), m.contact_distance.high);
    return (exponent_of(length) - exponent_of(largest(m.a))) / 2;
}

QuarticGap quartic_gap(const ExactMotion& m, int time)
{
    const Dyadic3 r = exact(m.r), v = exact(m.v), a = exact(m.a);
    const Dyadic s = m.contact_distance;
    QuarticGap gap;
    gap.time = time;

    const Dyadic unit = power_of_two(time);
    Dyadic power(1.0);
    std::vector<Dyadic> c{dot(r, r) - s * s, Dyadic(2.0) * dot(r, v), dot(v, v) + dot(r, a), dot(v, a),
                          Dyadic(0.25) * dot(a, a)};
    for (Dyadic& each : c) {
        each = each * power;
        power = power * unit;
    }
    gap.f = ExactPolynomial(c);
    gap.h = gap.f.derivative() * ExactPolynomial({Dyadic(0.5)});
    gap.h_rate = gap.h.derivative();
    return gap;
}

double root_bound(const ExactPolynomial& p)
{
    // Twice the largest |c_i / c_n|^(1/(n-i)) (Fujiwara), its exponent rounded up.
    const auto& c = p.coefficients();
    const int n = p.degree();
    int exponent = -horizon_exponent;
    for (int i = 0; i < n; ++i) {
        const Dyadic& each = c[static_cast<std::size_t>(i)];
        if (each.sign() == 0) continue;
        const int ratio = each.exponent() - c.back().exponent() + 1;
        exponent = std::max(exponent, static_cast<int>(std::ceil(static_cast<double>(ratio) / (n - i))));
    }
    return std::ldexp(1, std::min(exponent + 2, horizon_exponent));
}

}  // namespace carom
