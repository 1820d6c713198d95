#include "tunnel/critical_speed.hpp"

#include "tunnel/tolerances.hpp"

#include <cmath>

namespace carom::tunnel {

namespace {

using End = CriticalSpeed::End;

/// \pre nothing tunnels at `below`, something at `above`
CriticalSpeed bisected(double below, double above, const std::function<std::optional<bool>(double)>& tunnels)
{
    while (above > search_bracket * below) {
        const double middle = std::sqrt(below * above);
        (tunnels(middle).value_or(false) ? above : below) = middle;
    }
    return {End::found, std::sqrt(below * above)};
}

}  // namespace

double searched_phase(std::size_t part)
{
    return (static_cast<double>(part) + 0.5) / static_cast<double>(searched_phases);
}

CriticalSpeed search_critical(double unit, const std::function<std::optional<bool>(double)>& tunnels)
{
    double speed = search_begin * unit;
    std::optional<bool> now = tunnels(speed);
    if (now.value_or(false)) {
        while (true) {
            const double lower = speed / search_stride;
            if (lower < search_floor * unit) return {End::below, speed};
            now = tunnels(lower);
            if (!now) return {End::below, speed};
            if (!*now) return bisected(lower, speed, tunnels);
            speed = lower;
        }
    }
    while (true) {
        const double higher = speed * search_stride;
        if (higher > search_end * unit) return {End::never, speed};
        now = tunnels(higher);
        if (!now) return {End::never, speed};
        if (*now) return bisected(speed, higher, tunnels);
        speed = higher;
    }
}

}  // namespace carom::tunnel
