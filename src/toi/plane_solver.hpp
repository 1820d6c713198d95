/// \file
/// The quadratic h + w t + g t^2/2 with certified bounds, in double or in double-double: one text for both.
/// Cases and bounds: src/toi/ERROR_BOUNDS.md, "Planes".
#pragma once

#include "toi/bounded.hpp"
#include "toi/enclosure.hpp"
#include "toi/plane_numbers.hpp"
#include "toi/tolerances.hpp"

#include <limits>
#include <type_traits>

namespace carom {

/// For callers that know h, w, g only to within an error. One that knows them exactly offers them as h(), w(), g().
struct NoExactPlane {
    static constexpr bool available = false;
    Dyadic h() const { return {}; }
    Dyadic w() const { return {}; }
    Dyadic g() const { return {}; }
};

template <class Number, class Exact>
class PlaneSolver {
public:
    using Value = BoundedNumber<Number>;

    PlaneSolver(Value h, Value w, Value g, const Exact& exact) : h_(h), w_(w), g_(g), exact_(exact)
    {
        out_.level = std::is_same_v<Number, double> ? 0 : 1;
    }

    Enclosure<Number> solve()
    {
        settle(w_, std::abs(head(w_.value)), [this] { return settled(exact_.w(), 0); });
        settle(g_, std::abs(head(g_.value)), [this] { return settled(exact_.g(), 0); });
        if (w_.at_least_zero() && g_.at_least_zero()) return decided(Decision::none);
        settle(h_, std::abs(head(h_.value)), [this] { return settled(exact_.h(), 0); });
        if (w_.is_negative()) return falling();
        if (w_.is_positive()) return g_.is_negative() ? rising() : open();
        if (!g_.is_negative() || h_.open) return open();
        if (h_.is_positive()) return arriving();
        return w_.is_zero() ? decided(Decision::pressed) : open();
    }

private:
    Enclosure<Number> falling()
    {
        if (h_.at_most_zero()) return decided(Decision::impact);  // now
        const auto n = plane_numbers(h_, w_, g_);
        const Value d = discriminant_of(n);
        const bool arrives = g_.at_most_zero() || d.is_positive();
        if (!arrives && d.at_most_zero() && h_.is_positive()) return decided(Decision::none);  // turns, or only grazes
        out_.decided = arrives ? Decision::impact : Decision::ambiguous;

        const Number root = root_of(d.value), denominator = root - n.w.value;
        const double relative = sum_error(n.w, d, head(denominator)) + n.h.error / std::abs(head(n.h.value));
        if (arrives && h_.is_positive() && relative < quotient_holds_within)
            return within(Number(2) * n.h.value / denominator, relative, n.time);
        const double w = std::abs(head(n.w.value)), h = head(n.h.value);
        return between(2 * std::max(h - n.h.error, 0.0) / (w + n.w.error + upper_root(d)),
                       2 * (h + n.h.error) / (w - n.w.error + lower_root(d)), n.time);
    }

    /// Leaves the plane, or is on its way out from inside, and comes back.
    Enclosure<Number> rising()
    {
        const auto n = plane_numbers(h_, w_, g_);
        const Value d = discriminant_of(n);
        out_.decided = Decision::impact;
        const double pull_relative = n.pull.error / head(n.pull.value);
        // Turns round while still inside: closing begins at the apex.
        if (d.at_most_zero())
            return within(n.w.value / n.pull.value, n.w.error / head(n.w.value) + pull_relative, n.pull_time);
        return coming_back(n, d, pull_relative);
    }

    /// From outside, pulled, its speed 0 or of unknown sign.
    Enclosure<Number> arriving()
    {
        const auto n = plane_numbers(h_, w_, g_);
        const Value d = discriminant_of(n);
        out_.decided = Decision::impact;
        if (head(n.w.value) > 0) return coming_back(n, d, n.pull.error / head(n.pull.value));
        const Number denominator = root_of(d.value) - n.w.value;
        const double relative = sum_error(n.w, d, head(denominator)) + n.h.error / head(n.h.value);
        if (relative < quotient_holds_within) return within(Number(2) * n.h.value / denominator, relative, n.time);
        return open();
    }

    Enclosure<Number> coming_back(const PlaneNumbers<Number>& n, const Value& d, double pull_relative)
    {
        const Number sum = n.w.value + root_of(d.value);
        const double relative = sum_error(n.w, d, head(sum)) + pull_relative;
        if (d.is_positive() && relative < quotient_holds_within)
            return within(sum / n.pull.value, relative, n.pull_time);
        const double w = head(n.w.value), pull = head(n.pull.value);
        return between(std::max(w - n.w.error, 0.0) / (pull + n.pull.error),
                       (w + n.w.error + upper_root(d)) / (pull - n.pull.error), n.pull_time);
    }

    Value discriminant_of(const PlaneNumbers<Number>& n)
    {
        Value d = plane_discriminant(n);
        const double root = std::sqrt(std::abs(head(d.value)));
        settle(d, root * (root + std::abs(head(n.w.value))), [&] {
            const Dyadic w = exact_.w();
            return settled(w * w - Dyadic(2.0) * exact_.g() * exact_.h(), 2 * n.speed_shift);
        });
        return d;
    }

    template <class Settle>
    void settle(Value& x, double scale, Settle&& exactly)
    {
        if constexpr (Exact::available) {
            if (!is_blunt(x, scale)) return;
            if (x.open) out_.level = 2;
            x = exactly();
        }
    }

    Enclosure<Number> decided(Decision decision)
    {
        out_.decided = decision;
        return out_;
    }
    Enclosure<Number> open()
    {
        out_.t_hi = Number(std::numeric_limits<double>::infinity());
        return decided(Decision::ambiguous);
    }
    Enclosure<Number> within(Number t, double relative, int unit)
    {
        const Number width = t * Number(padded(relative) + plane_time_operations * operation_error<Number>);
        out_.t = scaled(t, unit);
        out_.t_lo = scaled_down(t - width, unit);
        out_.t_hi = scaled_up(t + (width + width), unit);
        return in_range();
    }
    Enclosure<Number> between(double low, double high, int unit)
    {
        out_.t = Number(std::ldexp(low + (high - low) / 2, unit));
        out_.t_lo = Number(scaled_down(low * (1 - interval_slack), unit));
        out_.t_hi = Number(scaled_up(high * (1 + interval_slack), unit));
        return in_range();
    }
    /// A time beyond the range of doubles is none.
    Enclosure<Number> in_range()
    {
        if (head(out_.t_lo) < std::numeric_limits<double>::infinity()) return out_;
        out_ = Enclosure<Number>{Decision::none, {}, {}, {}, out_.level};
        return out_;
    }

    Value h_, w_, g_;
    const Exact& exact_;
    Enclosure<Number> out_;
};

}  // namespace carom
