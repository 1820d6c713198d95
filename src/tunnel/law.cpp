#include "tunnel/law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::tunnel {

std::optional<double> share_missed(const Contestant& who, const Cell& cell)
{
    if (!who.chords_seen) return {};
    if (cell.target == Target::wall) return 0;
    const double seen = *who.chords_seen / cell.number();  // of the way of a step, at a central hit
    if (cell.target == Target::plate) return std::max(0.0, 1 - seen);
    // The mean of max(0, 1 - seen sqrt(u)), u = 1 - b^2 / (r1+r2)^2 being uniform in (0, 1].
    return seen <= 1 ? 1 - 2 * seen / 3 : 1 / (3 * seen * seen);
}

double chord_of(const Cell& cell, double offset)
{
    return cell.reach() * std::sqrt((1 - offset) * (1 + offset));
}

std::optional<double> critical_speed(const Contestant& who, const Cell& cell, double offset)
{
    if (!who.chords_seen) return {};
    if (cell.target == Target::wall) return std::numeric_limits<double>::infinity();
    return *who.chords_seen * chord_of(cell, offset) / cell.dt;
}

}  // namespace carom::tunnel
