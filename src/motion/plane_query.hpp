/// \file
/// The time at which a sphere in free flight touches a plane, for certified runs: in double-double and, on demand,
/// exactly.
#pragma once

#include "motion/pair_query.hpp"
#include "toi/plane_solver.hpp"

namespace carom {

/// Height above contact with a plane, on the side of the sphere, its rate and acceleration.
class PlaneQuery {
public:
    PlaneQuery(const State& state, const Flight& flight, BodyId body, int p)
        : state_(state), flight_(flight), plane_(state.plane(p)), radius_(state.radius(body))
    {
        side_ = facing_normal(state, p, flight.place) == plane_.normal ? 1 : -1;
        double scale = std::abs(plane_.offset) + radius_;
        for (int k = 0; k < 3; ++k) {
            const double n = plane_.normal[k];
            if (n != 0) scale += std::abs(n * cells(k)) + state.frame.cell_size;
        }
        h_ = {height<DoubleDouble>(), double_double_error * scale};
        w_ = bounded_along(flight.velocity);
        g_ = bounded_along(state.acceleration(flight));
    }

    Enclosure<DoubleDouble> enclose() const { return PlaneSolver<DoubleDouble, PlaneQuery>(h_, w_, g_, *this).solve(); }
    /// The answer without exact values, for places that are roundings themselves.
    Enclosure<DoubleDouble> enclose_rounded() const
    {
        return PlaneSolver<DoubleDouble, NoExactPlane>(h_, w_, g_, {}).solve();
    }

    /// Depth of the overlap, 0 where the exact height is >= 0 [length].
    double overlap() const { return h_.is_positive() || h().sign() >= 0 ? 0 : -h_.value.high; }

    // Exact numbers, for PlaneSolver.
    static constexpr bool available = true;
    Dyadic h() const { return height<Dyadic>(); }
    Dyadic w() const { return along<Dyadic>(flight_.velocity); }
    Dyadic g() const { return along<Dyadic>(state_.acceleration(flight_)); }

private:
    double cells(int k) const { return static_cast<double>(flight_.place.cell[k]) * state_.frame.cell_size; }

    template <class Real>
    Real height() const
    {
        Real sum(-plane_.offset);
        for (int k = 0; k < 3; ++k) {
            const double n = plane_.normal[k];
            if (n == 0) continue;
            sum = sum + product<Real>(n, cells(k)) + product<Real>(n, flight_.place.local[k]) +
                  product<Real>(n, flight_.place.low[k]);
        }
        return Real(side_) * sum - Real(plane_.thickness.value_or(0) / 2) - Real(radius_);
    }

    template <class Real>
    Real along(const Vec3& x) const
    {
        Real sum(0.0);
        for (int k = 0; k < 3; ++k) sum = sum + product<Real>(plane_.normal[k], x[k]);
        return Real(side_) * sum;
    }
    Bounded bounded_along(const Vec3& x) const
    {
        return {along<DoubleDouble>(x), double_double_error * plane_.normal.cwiseProduct(x).cwiseAbs().sum()};
    }

    const State& state_;
    const Flight& flight_;
    const Plane& plane_;
    double radius_, side_ = 1;
    Bounded h_, w_, g_;
};

}  // namespace carom
