/// \file
/// Periods of steps, many at once: the part of ExactSteps that knows them.
#include "impact/exact_matrix.hpp"
#include "impact/exact_steps.hpp"
#include "impact/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

/// How far a margin strays from the line between its values before 2^j periods and after them, by the orders p of which
/// `bounds` limit its differences, from 2 on: the least, for high ones are rounding where N is large.
double strays(const std::vector<Numbers>& differences, std::size_t margin, double length,
              std::span<const double> bounds, std::size_t j)
{
    if (j == 0) return 0;
    const double periods = std::ldexp(1.0, static_cast<int>(j));
    double ways = 1, known = 0;  // ways: binomial coefficient, from above
    double second = std::numeric_limits<double>::infinity();
    for (std::size_t p = 2; p < differences.size() + 1; ++p) {
        second = std::min(second, known + ways * length * bounds[p - 2]);
        if (p < differences.size()) known += ways * std::abs(static_cast<double>(differences[p][margin]));
        ways *= periods / static_cast<double>(p - 1);
    }
    return second_difference_strays * periods * periods * second;
}

bool same(const Step& a, const Step& b)
{
    return a.contacts == b.contacts && a.gain == b.gain && a.always == b.always;
}

}  // namespace

/// A period as a map of the rates of its own contacts, and its powers.
struct ExactSteps::Period {
    /// 2^j times the period: the rates after it, and its impulses, from the rates before.
    struct Power {
        Matrix rates, impulses;
    };

    std::span<const Step> steps;
    std::vector<int> contacts;
    std::vector<double> lengths;  ///< by margin: of its linear function, in the metric
    Matrix products;
    std::vector<Power> powers;

    const Power& power(std::size_t j)
    {
        while (powers.size() <= j) {
            const Power& half = powers.back();
            Matrix sum = half.rates;
            for (std::size_t i = 0; i < sum.size; ++i) sum(i, i) = sum(i, i) + DoubleDouble(1);
            powers.push_back({half.rates * half.rates, half.impulses * sum});
        }
        return powers[j];
    }
    Numbers own(const Numbers& rates) const
    {
        Numbers out;
        for (const int i : contacts) out.push_back(rates[static_cast<std::size_t>(i)]);
        return out;
    }
};

bool ExactSteps::take_and_repeat(const Step& step)
{
    take(step);
    if (pace_ == Pace::one_by_one) return true;
    if (history_.size() == 2 * longest_period) history_.erase(history_.begin());
    history_.push_back(step);
    if (--wait_ > 0) return true;
    const std::span<const Step> steps = last_period();
    if (steps.empty()) return true;
    const Repeats repeats = repeat(steps);
    if (repeats.jumps == most_jumps)
        next_wait_ = longest_wait;
    else
        next_wait_ = repeats.periods < fewest_repeats ? std::min(2 * next_wait_, longest_wait) : 1;
    wait_ = next_wait_;
    return repeats.periods < endless_repeats;
}

/// The steps that have come twice, one after the other, or none.
std::span<const Step> ExactSteps::last_period() const
{
    const std::span<const Step> all = history_;
    for (std::size_t n = 1; 2 * n <= all.size(); ++n) {
        const auto last = all.last(n), before = all.subspan(all.size() - 2 * n, n);
        if (std::equal(last.begin(), last.end(), before.begin(), same)) return last;
    }
    return {};
}

/// Margins, by step, that must be positive for the period to be what comes: of contacts that are open and of those
/// that close how far they are, impulses, how far idle ones are open at gain 1. \param rates before it, after it on
/// return
Numbers ExactSteps::margins(const Period& period, Numbers& rates) const
{
    Numbers out;
    const auto value = [&](int i) { return rates[static_cast<std::size_t>(i)]; };
    for (const Step& step : period.steps) {
        for (const int i : step.open) out.push_back(value(i) + DoubleDouble(closing_));
        for (const int i : step.contacts)
            out.push_back(step.always ? DoubleDouble(1) : -(value(i) + DoubleDouble(closing_)));
        const Numbers impulses = impulses_of(step, rates);
        out.insert(out.end(), impulses.begin(), impulses.end());
        Numbers idle;
        for (const int i : step.idle) idle.push_back(value(i));
        for (std::size_t k = 0; k < impulses.size(); ++k) spread(step.contacts[k], impulses[k], rates);
        for (std::size_t k = 0; k < idle.size(); ++k)
            out.push_back(idle[k] + (value(step.idle[k]) - idle[k]) / DoubleDouble(step.gain) + DoubleDouble(closing_));
    }
    return out;
}

Numbers ExactSteps::after(const Period& period, const Numbers& impulses) const
{
    Numbers out = rates_;
    for (std::size_t k = 0; k < impulses.size(); ++k) spread(period.contacts[k], impulses[k], out);
    return out;
}

/// Takes periods, 2^j at once. A margin is a linear function f_k of the vectors u before the k-th period, and the map T
/// of a period lengthens nothing. So the p-th difference of f is at most |f| |(T - I)^p u| ever after, the second one
/// from f_0 to f_N at most that times C(N, p - 2) and the sum of C(N, n - 2) |n-th difference of f at 0|, n < p; f
/// strays from the line between f_0 and f_N by N^2/8 of it at most, and where both are larger than that all between are
/// positive. (This project's.)
ExactSteps::Repeats ExactSteps::repeat(std::span<const Step> steps)
{
    Period period{steps, {}, {}, {}, {}};
    for (const Step& step : steps)
        period.contacts.insert(period.contacts.end(), step.contacts.begin(), step.contacts.end());
    std::sort(period.contacts.begin(), period.contacts.end());
    period.contacts.erase(std::unique(period.contacts.begin(), period.contacts.end()), period.contacts.end());
    const std::size_t n = period.contacts.size();
    if (n > most_repeated) return {};
    const auto place = [&](int i) {
        return static_cast<std::size_t>(std::lower_bound(period.contacts.begin(), period.contacts.end(), i) -
                                        period.contacts.begin());
    };
    period.products = {n, products(period.contacts)};

    Matrix rates{n}, sums{n};
    for (std::size_t i = 0; i < n; ++i) rates(i, i) = 1;
    for (const Step& step : steps) {
        const std::size_t m = step.contacts.size();
        const Matrix inner{m, products(step.contacts)};
        Numbers impulses(m * n);
        for (std::size_t k = 0; k < m; ++k)
            for (std::size_t c = 0; c < n; ++c)
                impulses[k * n + c] = DoubleDouble(-step.gain) * rates(place(step.contacts[k]), c);
        solve(inner, impulses, n);
        for (std::size_t k = 0; k < m; ++k) {
            const std::size_t at = place(step.contacts[k]);
            for (std::size_t c = 0; c < n; ++c) {
                sums(at, c) = sums(at, c) + impulses[k * n + c];
                for (std::size_t i = 0; i < n; ++i)
                    rates(i, c) = rates(i, c) + period.products(i, at) * impulses[k * n + c];
            }
        }
        const auto length = [&](int i) {
            const bool is_met = std::any_of(period.contacts.begin(), period.contacts.end(),
                                            [&](int j) { return product(i, j).high != 0; });
            period.lengths.push_back(is_met ? std::sqrt(static_cast<double>(product(i, i))) : 0);
        };
        std::for_each(step.open.begin(), step.open.end(), length);
        std::for_each(step.contacts.begin(), step.contacts.end(), length);
        Numbers inverse(m * m);
        for (std::size_t k = 0; k < m; ++k) inverse[k * m + k] = 1;
        solve(inner, inverse, m);
        for (std::size_t k = 0; k < m; ++k)
            period.lengths.push_back(step.gain * std::sqrt(std::max(0.0, static_cast<double>(inverse[k * m + k]))));
        std::for_each(step.idle.begin(), step.idle.end(), length);
    }
    period.powers.push_back({std::move(rates), std::move(sums)});

    Repeats out;
    std::size_t doublings = 0;
    for (;; ++out.jumps) {
        if (out.jumps == most_jumps || out.periods >= endless_repeats) return out;
        const Numbers before = period.own(rates_);
        const std::vector<Numbers> differences = margin_differences(period);
        const std::vector<double> bounds = difference_bounds(period, before);
        const auto holds = [&](std::size_t j) {
            Numbers there = after(period, period.power(j).impulses * before);
            const Numbers margin = margins(period, there);
            for (std::size_t q = 0; q < margin.size(); ++q) {
                const double stray = strays(differences, q, period.lengths[q], bounds, j);
                if (!(static_cast<double>(differences[0][q]) > stray && static_cast<double>(margin[q]) > stray))
                    return false;
            }
            return true;
        };
        while (doublings > 0 && !holds(doublings)) --doublings;
        if (doublings == 0 && !holds(0)) return out;
        while (doublings + 1 < most_doublings && holds(doublings + 1)) ++doublings;
        const Numbers impulses = period.power(doublings).impulses * before;
        for (std::size_t k = 0; k < n; ++k) {
            DoubleDouble& sum = impulses_[static_cast<std::size_t>(period.contacts[k])];
            sum = sum + impulses[k];
            spread(period.contacts[k], impulses[k], rates_);
        }
        out.periods += std::int64_t{1} << doublings;
        if (doublings == 0) return out;
    }
}

/// The margins and their differences over periods from now on.
std::vector<Numbers> ExactSteps::margin_differences(const Period& period) const
{
    std::vector<Numbers> out;
    Numbers rates = rates_;
    for (int k = 0; k < known_differences; ++k) out.push_back(margins(period, rates));
    for (std::size_t order = 1; order < out.size(); ++order)
        for (std::size_t k = out.size(); k-- > order;)
            for (std::size_t q = 0; q < out[k].size(); ++q) out[k][q] = out[k][q] - out[k - 1][q];
    return out;
}

/// |(T - I)^p u| for p = 2, 3, ... up to the first difference that is not known [length in the metric].
std::vector<double> ExactSteps::difference_bounds(const Period& period, const Numbers& before) const
{
    const Period::Power& once = period.powers.front();
    std::vector<double> out;
    Numbers difference = before;
    for (int p = 2; p <= known_differences; ++p) {
        const Numbers turned = once.rates * difference;
        for (std::size_t i = 0; i < turned.size(); ++i) difference[i] = turned[i] - difference[i];
        const Numbers impulses = once.impulses * difference, rates = period.products * impulses;
        DoubleDouble square;
        for (std::size_t i = 0; i < rates.size(); ++i) square = square + impulses[i] * rates[i];
        out.push_back(std::sqrt(std::max(0.0, static_cast<double>(square))));
    }
    return out;
}

}  // namespace carom
