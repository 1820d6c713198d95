#include "toi/enclosure.hpp"
#include "toi/plane_solver.hpp"

namespace carom {

namespace {

/// h, w, g are exactly what they are.
struct ExactPlane {
    static constexpr bool available = true;
    DoubleDouble height, rate, acceleration;

    Dyadic h() const { return height; }
    Dyadic w() const { return rate; }
    Dyadic g() const { return acceleration; }
};

}  // namespace

Enclosure<double> enclose_plane(double h, double w, double g, const PlaneInputError& error)
{
    return PlaneSolver<double, NoExactPlane>({h, error.h}, {w, error.w}, {g, error.g}, {}).solve();
}

Enclosure<DoubleDouble> enclose_plane(DoubleDouble h, DoubleDouble w, DoubleDouble g, const PlaneInputError& error)
{
    if (error.any())
        return PlaneSolver<DoubleDouble, NoExactPlane>({h, error.h}, {w, error.w}, {g, error.g}, {}).solve();
    const ExactPlane exact{h, w, g};
    return PlaneSolver<DoubleDouble, ExactPlane>({h, 0}, {w, 0}, {g, 0}, exact).solve();
}

}  // namespace carom
