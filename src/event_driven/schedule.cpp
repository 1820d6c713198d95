#include "event_driven/schedule.hpp"

#include "event_driven/motion.hpp"
#include "toi/sphere_plane.hpp"

#include <algorithm>
#include <limits>

namespace carom {

namespace {

constexpr std::size_t few = 32;  ///< up to here all pairs cost less than a grid (tests/bench)

/// Two centres further apart than this cannot matter to each other before one of them crosses a cell wall. A swept ball
/// is larger than its sphere, off its centre, and ends off its cell by at most `series_below` radii each; the last per
/// cent covers all rounding.
double reach(const State& state)
{
    double largest = 0;
    for (const auto& s : state.scene.spheres) largest = std::max(largest, s.radius);
    return 2 * largest * (1 + 3 * state.scene.rest.series_below) * 1.01;
}

std::variant<AllPairs, CellGrid> choose(const State& state, BroadPhase wanted)
{
    const std::size_t n = state.flights.size();
    if (n < 2 || wanted == BroadPhase::all_pairs || (wanted == BroadPhase::automatic && n <= few))
        return AllPairs(static_cast<BodyId>(n));
    std::vector<Place> places;
    places.reserve(n);
    for (const auto& f : state.flights) places.push_back(f.place);
    return CellGrid(state.frame, places, reach(state));
}

}  // namespace

Schedule::Schedule(const State& state, BroadPhase broad_phase, Counts& counts)
    : broad_(choose(state, broad_phase)),
      queue_(state.flights.size() * (std::holds_alternative<CellGrid>(broad_) ? 2 : 1)),
      partner_stamp_(state.flights.size(), 0)
{
    for (BodyId i = 0; i < state.count(); ++i) {
        examine(state, i, counts);
        watch_cell(state, i, {}, counts);
    }
}

bool Schedule::is_stale(const State& state, const Next& next) const
{
    const Key& key = next.key;
    if (key.kind != Scheduled::pair_impact && key.kind != Scheduled::intrusion) return false;
    if (state.is_plane(key.b)) return false;
    const auto owner = static_cast<BodyId>(next.slot);
    const BodyId partner = key.a == owner ? key.b : key.a;
    return partner_stamp_[next.slot] != state.stamps[static_cast<std::size_t>(partner)];
}

void Schedule::offer(const State& state, BodyId body, BodyId other, Key& best, std::uint32_t& stamp,
                     Counts& counts) const
{
    const BodyId a = std::min(body, other), b = std::max(body, other);
    const PairMotion m = pair_motion(state, moving(state, a), moving(state, b));
    ++counts.pair_tests;
    const Root root = pair_root(state, m);
    if (root.kind == RootKind::none) return;
    ++counts.root_solves;
    const Key key{state.frame.after(m.from, root.t), m.swept ? Scheduled::intrusion : Scheduled::pair_impact, a, b};
    if (key < best) {
        best = key;
        stamp = state.stamps[static_cast<std::size_t>(other)];
    }
}

void Schedule::examine(const State& state, BodyId body, Counts& counts)
{
    const auto slot = static_cast<std::size_t>(body);
    const Moving self = moving(state, body);
    const Flight& flight = self.flight;
    Key best;
    std::uint32_t stamp = 0;
    if (flight.mode == Mode::series)
        best = {state.frame.after(flight.start, self.series->duration()), Scheduled::series_end, body,
                state.scene.plane_body(static_cast<std::size_t>(flight.support))};
    for (int p = 0; p < static_cast<int>(state.scene.planes.size()); ++p) {
        if (p == flight.support) continue;
        ++counts.pair_tests;
        if (recedes(state, self, p)) continue;
        const PlaneMotion m = plane_motion(state, self, p);
        const Root root = plane_root(m.h, m.w, m.g);
        if (root.kind == RootKind::none) continue;
        ++counts.root_solves;
        best = std::min(best, Key{state.frame.after(flight.start, root.t),
                                  flight.mode == Mode::series ? Scheduled::intrusion : Scheduled::plane_impact, body,
                                  state.scene.plane_body(static_cast<std::size_t>(p))});
    }
    for (const BodyId other : neighbours(body)) offer(state, body, other, best, stamp, counts);
    queue_.set(slot, best);
    partner_stamp_[slot] = stamp;
}

void Schedule::watch_cell(const State& state, BodyId body, const EpochTime& now, Counts& counts)
{
    const auto* grid = std::get_if<CellGrid>(&broad_);
    if (!grid) return;
    const Flight f = filed_path(state, body, now);
    const Vec3& a = state.accelerations[f.acceleration];
    double soonest = std::numeric_limits<double>::infinity();
    BodyId wall = 0;  // axis, and which way
    const auto look = [&](double h, double w, double g, BodyId which) {
        if (w >= 0 && g >= 0) return;
        const Root root = plane_root(h, w, g);
        ++counts.root_solves;
        // Starting to fall on the wall itself (pressed) is leaving, too.
        if (root.kind == RootKind::none || !(root.t < soonest)) return;
        soonest = root.t;
        wall = which;
    };
    for (int axis = 0; axis < 3; ++axis) {
        const double v = f.velocity[axis], g = a[axis];
        look(grid->above_lower_wall(state.frame, body, axis, f.place), v, g, 2 * axis);
        look(grid->below_upper_wall(state.frame, body, axis, f.place), -v, -g, 2 * axis + 1);
    }
    Key leaving;
    if (soonest < std::numeric_limits<double>::infinity())
        leaving = {state.frame.after(now, soonest), Scheduled::cell_crossing, body, wall};
    queue_.set(state.flights.size() + static_cast<std::size_t>(body), leaving);
}

void Schedule::cross(const State& state, const Key& crossing, Counts& counts)
{
    auto& grid = std::get<CellGrid>(broad_);
    const int axis = crossing.b / 2, direction = crossing.b % 2 == 0 ? -1 : 1;
    grid.step(crossing.a, axis, direction);
    ++counts.cell_crossings;

    const auto slot = static_cast<std::size_t>(crossing.a);
    Key best = queue_.key(slot);
    grid.new_neighbours(crossing.a, axis, direction,
                        [&](BodyId other) { offer(state, crossing.a, other, best, partner_stamp_[slot], counts); });
    queue_.set(slot, best);
    watch_cell(state, crossing.a, crossing.time, counts);
}

}  // namespace carom
