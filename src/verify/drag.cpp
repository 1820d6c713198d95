#include "verify/drag.hpp"

#include "verify/tolerances.hpp"

#include <array>

namespace carom::verification {

namespace {

using Reciprocals = std::array<DoubleDouble, damped_terms + 1>;

/// 1/n, by n.
Reciprocals reciprocals()
{
    Reciprocals out;
    for (int n = 1; n <= damped_terms; ++n) out[static_cast<std::size_t>(n)] = DoubleDouble(1) / DoubleDouble(n);
    return out;
}

/// (z - 1 + e^-z) / z^2 = 1/2 - z/6 + z^2/24 - .., as 1/2 (1 - z/3 (1 - z/4 (1 - ..))): each step has room for the
/// error of the one inside, of which it takes z/n. Relative error 16 u^2 or less. \pre 0 <= z <= 1
DoubleDouble tail(const DoubleDouble& z)
{
    static const Reciprocals inverse = reciprocals();
    DoubleDouble sum = 1;
    for (int n = z.high < short_series_up_to ? short_damped_terms : damped_terms; n >= 3; --n)
        sum = DoubleDouble(1) - (z * inverse[static_cast<std::size_t>(n)]) * sum;
    return DoubleDouble(0.5) * sum;
}

/// e^-z by squaring: an error of d is 2 d after it, beside e^-z, which shrinks faster. \pre 1 < z <= longest_decay
DoubleDouble decay_of(const DoubleDouble& z)
{
    int squarings = 0;
    std::frexp(z.high, &squarings);
    const double part = std::ldexp(1.0, -squarings);
    const DoubleDouble small(z.high * part, z.low * part);
    DoubleDouble decay = DoubleDouble(1) - small * (DoubleDouble(1) - small * tail(small));
    for (; squarings > 0; --squarings) decay = decay * decay;
    return decay;
}

}  // namespace

template <>
Damped<DoubleDouble> damped(double k, const DoubleDouble& t)
{
    const DoubleDouble one(1.0);
    if (k * t.high <= 1) {
        const DoubleDouble z = DoubleDouble(k) * t, rest = tail(z), mean = one - z * rest;
        return {t * mean, t * t * rest, one - z * mean};
    }
    const DoubleDouble decay = k * t.high < longest_decay ? decay_of(DoubleDouble(k) * t) : DoubleDouble();
    const DoubleDouble way = (one - decay) / DoubleDouble(k);
    return {way, (t - way) / DoubleDouble(k), decay};
}

template <>
Damped<double> damped(double k, const DoubleDouble& t)
{
    const Damped<DoubleDouble> fine = damped<DoubleDouble>(k, t);
    return {fine.way.high, fine.fall.high, fine.decay.high};
}

}  // namespace carom::verification
