#include "event_driven/certified_place.hpp"

#include "event_driven/certified_time.hpp"

namespace carom {

Flown flown(const State& state, BodyId body, const EpochTime& now)
{
    const Flight& f = state.flight(body);
    if (!state.certified() || !flies_freely(f)) return {advanced(state, body, now), Vec3::Zero()};
    Flown out = at_start(state, body);
    const DoubleDouble dt = lifted_between(state.frame, f.start, now);
    if (dt.high == 0) return out;
    const double size = state.frame.cell_size;
    const Vec3& g = state.accelerations[f.acceleration];
    const DoubleDouble half = dt * DoubleDouble(0.5);
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble shift = dt * (DoubleDouble(f.velocity[k]) + half * DoubleDouble(g[k]));
        DoubleDouble sum = (DoubleDouble(f.place.local[k]) + DoubleDouble(out.low[k])) + shift;
        const double whole = std::floor(sum.high / size);
        if (whole != 0 && std::abs(whole) < furthest) {
            sum = sum - DoubleDouble(whole * size);
            out.flight.place.cell[k] += static_cast<std::int64_t>(whole);
        }
        const bool below = sum.high < 0;  // by a rounding: the head was the wall itself
        out.flight.place.local[k] = below ? 0 : sum.high;
        out.low[k] = below ? sum.high : sum.low;
        out.flight.velocity[k] = static_cast<double>(DoubleDouble(f.velocity[k]) + dt * DoubleDouble(g[k]));
    }
    out.flight.start = now;
    return out;
}

}  // namespace carom
