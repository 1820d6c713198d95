/// \file
/// When a sphere in free flight touches a plane, for certified runs.
#pragma once

#include "event_driven/certified_place.hpp"
#include "toi/plane_solver.hpp"

namespace carom {

/// Height above contact with a plane, on the side of `normal`, its rate and acceleration: in double-double and exactly.
class PlaneQuery {
public:
    PlaneQuery(const State& state, const Flown& sphere, BodyId body, int p)
        : state_(state), sphere_(sphere), plane_(state.plane(p)), radius_(state.radius(body))
    {
        side_ = facing_normal(state, p, sphere.flight.place) == plane_.normal ? 1 : -1;
        const Flight& f = sphere.flight;
        DoubleDouble h = -plane_.offset;
        double scale = std::abs(plane_.offset) + radius_;
        for (int k = 0; k < 3; ++k) {
            const double n = plane_.normal[k];
            if (n == 0) continue;
            const double cells = static_cast<double>(f.place.cell[k]) * state.frame.cell_size;
            h = h + DoubleDouble(two_product(n, cells)) + DoubleDouble(two_product(n, f.place.local[k])) +
                DoubleDouble(n * sphere.low[k]);
            scale += std::abs(n * cells) + state.frame.cell_size;
        }
        h = DoubleDouble(side_) * h - DoubleDouble(plane_.thickness.value_or(0) / 2) - DoubleDouble(radius_);
        h_ = {h, dd_error * scale};
        w_ = along(f.velocity);
        g_ = along(state.accelerations[f.acceleration]);
    }

    Enclosure<DoubleDouble> enclose() const { return PlaneSolver<DoubleDouble, PlaneQuery>(h_, w_, g_, *this).solve(); }
    /// Without the exact values: the places are roundings themselves.
    Enclosure<DoubleDouble> enclose_rounded() const
    {
        return PlaneSolver<DoubleDouble, NoExactPlane>(h_, w_, g_, {}).solve();
    }

    double overlap() const
    {
        if (h_.is_positive() || h().sign() >= 0) return 0;
        return -h_.value.high;
    }

    // What PlaneSolver wants of exact numbers.
    static constexpr bool available = true;
    Dyadic h() const
    {
        Dyadic sum = -Dyadic(plane_.offset);
        for (int k = 0; k < 3; ++k)
            sum = sum + Dyadic(plane_.normal[k]) * exact_coordinate(state_.frame, sphere_.flight, sphere_.low, k, 0);
        return Dyadic(side_) * sum - Dyadic(plane_.thickness.value_or(0) / 2) - Dyadic(radius_);
    }
    Dyadic w() const { return exact_along(sphere_.flight.velocity); }
    Dyadic g() const { return exact_along(state_.accelerations[sphere_.flight.acceleration]); }

private:
    Bounded along(const Vec3& x) const
    {
        DoubleDouble sum;
        double scale = 0;
        for (int k = 0; k < 3; ++k) {
            const Sum product = two_product(plane_.normal[k], x[k]);
            sum = sum + DoubleDouble(product);
            scale += std::abs(product.high);
        }
        return {DoubleDouble(side_) * sum, dd_error * scale};
    }
    Dyadic exact_along(const Vec3& x) const
    {
        const Vec3& n = plane_.normal;
        return Dyadic(side_) *
               (Dyadic(n.x()) * Dyadic(x.x()) + Dyadic(n.y()) * Dyadic(x.y()) + Dyadic(n.z()) * Dyadic(x.z()));
    }

    const State& state_;
    const Flown& sphere_;
    const Plane& plane_;
    double radius_, side_;
    Bounded h_, w_, g_;
};

}  // namespace carom
