/// \file
/// The first time at which a gap closes, for gap functions whose rate is known to be monotone between a few cuts.
#pragma once

#include "toi/bracketed_root.hpp"
#include "toi/root.hpp"

#include <limits>
#include <span>

namespace carom {

/// First t >= 0 at which F <= 0 and falls; where it is below 0 and grows, the next time that it falls.
/// \tparam Gap has f(t) = F, h(t), a positive multiple of F'/2, its rate h_rate(t), f_rate(t) = F', and
/// time_of_growth(from): a time after the last cut, from which on h only grows, at which h >= 0, or infinity
/// \param cuts ascending: at most one root of h lies between two of them
template <class Gap>
Root first_closing(const Gap& gap, std::span<const double> cuts)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto f = [&](double t) { return gap.f(t); };
    const auto h = [&](double t) { return gap.h(t); };
    const auto h_rate = [&](double t) { return gap.h_rate(t); };
    const auto f_rate = [&](double t) { return gap.f_rate(t); };

    const double f0 = gap.f(0), h0 = gap.h(0);
    if (f0 <= 0 && h0 < 0) return {RootKind::impact, 0, 0};
    if (f0 <= 0 && h0 == 0 && gap.h_rate(0) <= 0) return {RootKind::pressed, 0, 0};

    double low = 0, h_low = h0;
    double left = 0;  // where the current falling piece of F began
    for (std::size_t i = 0; i <= cuts.size(); ++i) {
        double high = i < cuts.size() ? cuts[i] : infinity;
        if (high == infinity) {  // H only grows from here on
            if (h_low >= 0) return {};
            high = gap.time_of_growth(low);
            if (high == infinity) return {};
        }
        const double h_high = gap.h(high);
        if (h_low < 0 && h_high >= 0) {
            const double lowest = refine(h, h_rate, low, high, false);
            if (gap.f(lowest) < 0)  // it may turn round while still inside
                return {RootKind::impact, gap.f(left) <= 0 ? left : refine(f, f_rate, left, lowest, true), 0};
        } else if (h_low >= 0 && h_high < 0) {
            left = refine(h, h_rate, low, high, true);
        }
        low = high;
        h_low = h_high;
    }
    return {};
}

}  // namespace carom
