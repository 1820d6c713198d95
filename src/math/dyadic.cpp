#include "math/dyadic.hpp"

#include "math/tolerances.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace carom {

namespace {

constexpr int limb_bits = 32;
constexpr int mantissa_bits = 53;

/// floor(a / 32)
std::int64_t limb_of(std::int64_t bit)
{
    return (bit - (((bit % limb_bits) + limb_bits) % limb_bits)) / limb_bits;
}

std::vector<std::uint32_t> limbs_of(std::uint64_t integer, int shift)
{
    const std::uint64_t low = integer << shift;
    const std::uint64_t high = shift == 0 ? 0 : integer >> (64 - shift);
    return {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> limb_bits),
            static_cast<std::uint32_t>(high)};
}

}  // namespace

Dyadic::Dyadic(int sign, Limbs limbs, std::int64_t exponent)
    : sign_(sign), limbs_(std::move(limbs)), exponent_(exponent)
{
    while (!limbs_.empty() && limbs_.back() == 0) limbs_.pop_back();
    const auto first = std::find_if(limbs_.begin(), limbs_.end(), [](std::uint32_t limb) { return limb != 0; });
    exponent_ += first - limbs_.begin();
    limbs_.erase(limbs_.begin(), first);
    if (limbs_.empty()) {
        sign_ = 0;
        exponent_ = 0;
    }
}

Dyadic::Dyadic(double value)
{
    if (value == 0) return;
    int exponent = 0;
    const double mantissa = std::frexp(std::abs(value), &exponent);
    const auto integer = static_cast<std::uint64_t>(std::ldexp(mantissa, mantissa_bits));
    const std::int64_t bit = exponent - mantissa_bits, limb = limb_of(bit);
    *this = Dyadic(value < 0 ? -1 : 1, limbs_of(integer, static_cast<int>(bit - limb * limb_bits)), limb);
}

Dyadic::Dyadic(DoubleDouble value) : Dyadic(Dyadic(value.high) + Dyadic(value.low)) {}

Dyadic::Dyadic(std::int64_t value)
{
    const auto bits = static_cast<std::uint64_t>(value);
    *this = Dyadic(value < 0 ? -1 : 1, limbs_of(value < 0 ? ~bits + 1 : bits, 0), 0);
}

std::uint32_t Dyadic::limb_at(std::int64_t place) const
{
    const std::int64_t i = place - exponent_;
    return i < 0 || i >= static_cast<std::int64_t>(limbs_.size()) ? 0 : limbs_[static_cast<std::size_t>(i)];
}

DoubleDouble Dyadic::rounded(int shift) const
{
    DoubleDouble sum;
    for (int k = 1; k <= most_rounded_limbs; ++k) {
        const double part = limb_at(top() - k);
        sum = sum + DoubleDouble(std::ldexp(part, -limb_bits * k));
    }
    const auto exponent = static_cast<int>(std::clamp(top() * limb_bits + shift, -beyond_doubles, beyond_doubles));
    return {sign_ * std::ldexp(sum.high, exponent), sign_ * std::ldexp(sum.low, exponent)};
}

int Dyadic::exponent() const
{
    if (sign_ == 0) return 0;
    return static_cast<int>(top() * limb_bits) - std::countl_zero(limbs_.back());
}

Dyadic Dyadic::operator-() const
{
    Dyadic out = *this;
    out.sign_ = -sign_;
    return out;
}

int Dyadic::compare_magnitudes(const Dyadic& a, const Dyadic& b)
{
    if (a.top() != b.top()) return a.top() < b.top() ? -1 : 1;
    for (std::int64_t place = a.top() - 1; place >= std::min(a.exponent_, b.exponent_); --place) {
        const std::uint32_t x = a.limb_at(place), y = b.limb_at(place);
        if (x != y) return x < y ? -1 : 1;
    }
    return 0;
}

Dyadic::Limbs Dyadic::sum(const Dyadic& a, const Dyadic& b, std::int64_t exponent)
{
    const auto count = static_cast<std::size_t>(std::max(a.top(), b.top()) - exponent);
    Limbs out(count + 1);
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t place = exponent + static_cast<std::int64_t>(i);
        carry += std::uint64_t{a.limb_at(place)} + b.limb_at(place);
        out[i] = static_cast<std::uint32_t>(carry);
        carry >>= limb_bits;
    }
    out[count] = static_cast<std::uint32_t>(carry);
    return out;
}

Dyadic::Limbs Dyadic::difference(const Dyadic& larger, const Dyadic& smaller, std::int64_t exponent)
{
    Limbs out(static_cast<std::size_t>(larger.top() - exponent));
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const std::int64_t place = exponent + static_cast<std::int64_t>(i);
        const std::int64_t digit = std::int64_t{larger.limb_at(place)} - smaller.limb_at(place) - borrow;
        borrow = digit < 0;
        out[i] = static_cast<std::uint32_t>(digit + (borrow << limb_bits));
    }
    return out;
}

Dyadic operator+(const Dyadic& a, const Dyadic& b)
{
    if (a.sign_ == 0) return b;
    if (b.sign_ == 0) return a;
    const std::int64_t exponent = std::min(a.exponent_, b.exponent_);
    if (a.sign_ == b.sign_) return {a.sign_, Dyadic::sum(a, b, exponent), exponent};
    const int order = Dyadic::compare_magnitudes(a, b);
    if (order == 0) return {};
    const Dyadic &larger = order > 0 ? a : b, &smaller = order > 0 ? b : a;
    return {larger.sign_, Dyadic::difference(larger, smaller, exponent), exponent};
}

Dyadic operator*(const Dyadic& a, const Dyadic& b)
{
    if (a.sign_ == 0 || b.sign_ == 0) return {};
    Dyadic::Limbs out(a.limbs_.size() + b.limbs_.size());
    for (std::size_t i = 0; i < a.limbs_.size(); ++i) {
        std::uint64_t carry = 0;
        for (std::size_t j = 0; j < b.limbs_.size(); ++j) {
            carry += std::uint64_t{a.limbs_[i]} * b.limbs_[j] + out[i + j];
            out[i + j] = static_cast<std::uint32_t>(carry);
            carry >>= limb_bits;
        }
        out[i + b.limbs_.size()] = static_cast<std::uint32_t>(carry);
    }
    return {a.sign_ * b.sign_, std::move(out), a.exponent_ + b.exponent_};
}

}  // namespace carom
