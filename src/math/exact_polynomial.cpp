#include "math/exact_polynomial.hpp"

#include "math/tolerances.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace carom {

bool operator==(const Point& a, const Point& b)
{
    if (a.is_double() && b.is_double()) return a.value == b.value;
    return (a.exact() - b.exact()).sign() == 0;
}

Point between(const Point& a, const Point& b)
{
    const Dyadic middle = (a.exact() + b.exact()) * Dyadic(0.5);
    const double value = middle.rounded().high;
    return {value, middle - Dyadic(value)};
}

ExactPolynomial::ExactPolynomial(std::vector<Dyadic> coefficients) : c_(std::move(coefficients))
{
    while (!c_.empty() && c_.back().sign() == 0) c_.pop_back();
    if (c_.empty()) return;
    unit_ = c_.back().exponent();
    for (const Dyadic& c : c_)
        if (c.sign() != 0) unit_ = std::max(unit_, c.exponent());
    for (const Dyadic& c : c_) rounded_.push_back(c.rounded(-unit_));
}

ExactPolynomial ExactPolynomial::derivative() const
{
    std::vector<Dyadic> out;
    for (std::size_t i = 1; i < c_.size(); ++i) out.push_back(c_[i] * Dyadic(static_cast<double>(i)));
    return ExactPolynomial(std::move(out));
}

DoubleDouble ExactPolynomial::value(double x) const
{
    DoubleDouble sum;
    for (std::size_t i = rounded_.size(); i-- > 0;) sum = sum * DoubleDouble(x) + rounded_[i];
    return sum;
}

int ExactPolynomial::sign(const Point& x) const
{
    if (!x.is_double()) return exact_sign(x.exact());
    double terms = 0;
    for (std::size_t i = rounded_.size(); i-- > 0;) terms = terms * x.value + std::abs(rounded_[i].high);
    const double error = horner_rounding * terms + horner_underflow;
    const double value = this->value(x.value).high;
    if (x.value <= largest_horner_point && std::abs(value) > error) return value < 0 ? -1 : 1;
    return exact_sign(Dyadic(x.value));
}

int ExactPolynomial::exact_sign(const Dyadic& x) const
{
    Dyadic sum;
    for (std::size_t i = c_.size(); i-- > 0;) sum = sum * x + c_[i];
    return sum.sign();
}

ExactPolynomial operator*(const ExactPolynomial& a, const ExactPolynomial& b)
{
    if (a.c_.empty() || b.c_.empty()) return {};
    std::vector<Dyadic> out(a.c_.size() + b.c_.size() - 1);
    for (std::size_t i = 0; i < a.c_.size(); ++i)
        for (std::size_t j = 0; j < b.c_.size(); ++j) out[i + j] = out[i + j] + a.c_[i] * b.c_[j];
    return ExactPolynomial(std::move(out));
}

ExactPolynomial negative_remainder(const ExactPolynomial& a, const ExactPolynomial& b)
{
    std::vector<Dyadic> rest = a.c_;
    const std::size_t size = b.c_.size();
    const Dyadic leading = b.c_.back(), positive = leading.sign() > 0 ? leading : -leading;
    while (rest.size() >= size) {
        // rest <- |leading| rest - (sign of leading) * (its own leading) x^k b
        const Dyadic factor = leading.sign() > 0 ? rest.back() : -rest.back();
        const std::size_t k = rest.size() - size;
        for (std::size_t i = 0; i + 1 < rest.size(); ++i) {
            rest[i] = rest[i] * positive;
            if (i >= k) rest[i] = rest[i] - factor * b.c_[i - k];
        }
        rest.pop_back();
        while (!rest.empty() && rest.back().sign() == 0) rest.pop_back();
    }
    for (Dyadic& c : rest) c = -c;
    return ExactPolynomial(std::move(rest));
}

namespace {

int variations(const std::vector<ExactPolynomial>& chain, const Point& x)
{
    int count = 0, last = 0;
    for (const ExactPolynomial& p : chain) {
        const int sign = p.sign(x);
        if (sign != 0 && last != 0 && sign != last) ++count;
        if (sign != 0) last = sign;
    }
    return count;
}

}  // namespace

int sign_at_root(const ExactPolynomial& g, const ExactPolynomial& q, const Isolated& where)
{
    if (where.is_point()) return q.sign(where.low);
    std::vector<ExactPolynomial> chain{g, g.derivative() * q};
    while (chain.back().degree() >= 0) {
        ExactPolynomial next = negative_remainder(chain[chain.size() - 2], chain.back());
        chain.push_back(std::move(next));
    }
    return variations(chain, where.low) - variations(chain, where.high);
}

void halve(const ExactPolynomial& g, Isolated& where)
{
    if (where.is_point()) return;
    const Point middle = between(where.low, where.high);
    const int sign = g.sign(middle);
    if (sign == 0)
        where.low = where.high = middle;
    else if (sign == g.sign(where.low))
        where.low = middle;
    else
        where.high = middle;
}

namespace {

/// Halfway through the bit patterns of two doubles >= 0: 64 halvings exhaust any bracket.
double middle_pattern(double low, double high)
{
    const auto a = std::bit_cast<std::int64_t>(low), b = std::bit_cast<std::int64_t>(high);
    return std::bit_cast<double>(a + (b - a) / 2);
}

}  // namespace

double root_guess(const ExactPolynomial& g, const Isolated& where)
{
    const ExactPolynomial rate = g.derivative();
    const double unit = std::ldexp(1, g.unit() - rate.unit());
    double low = where.low.value, high = where.high.value, t = high;
    const bool rises = g.sign(where.high) > 0;
    for (int i = 0; i < most_guess_steps; ++i) {
        const double value = g.value(t).high;
        const bool is_above = !std::isfinite(value) || (value > 0) == rises;
        (is_above ? high : low) = t;
        double next = t - value / rate.value(t).high * unit;
        if (!(next > low && next < high)) next = middle_pattern(low, high);
        if (std::abs(next - t) <= guess_is_found * t) return next;
        t = next;
    }
    return t;
}

Isolated neighbours(const ExactPolynomial& g, const Isolated& where, double guess)
{
    double low = where.low.value, high = where.high.value;
    const int sign_low = g.sign(where.low);
    const auto look_at = [&](double x) {
        if (!(x > low && x < high)) return;
        const int sign = g.sign({x, {}});
        if (sign == 0)
            low = high = x;
        else
            (sign == sign_low ? low : high) = x;
    };
    look_at(guess);
    // Around the guess, ever wider, until the root is caught.
    for (double width = first_catch; width < widest_catch && low < high; width *= catch_growth) {
        const double before_low = low, before_high = high;
        look_at(guess * (1 - width));
        look_at(guess * (1 + width));
        if (low != before_low && high != before_high && high <= guess * (1 + 2 * width)) break;
        if (low >= guess * (1 - 2 * width) && high <= guess * (1 + 2 * width)) break;
    }
    while (low < high) {
        const double middle = middle_pattern(low, high);
        if (!(middle > low && middle < high)) break;
        look_at(middle);
    }
    return {{low, {}}, {high, {}}};
}

}  // namespace carom
