#include "toi/sphere_plane.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

Root detail::scaled_plane_root(double h, double w, double g)
{
    // Another unit of length, by a power of two, leaves the time as it is.
    const double speed = std::max(std::abs(w), std::sqrt(std::abs(g)) * std::sqrt(std::abs(h)));
    int exponent = 0;
    std::frexp(speed, &exponent);
    return moderate_plane_root(std::ldexp(h, -exponent), std::ldexp(w, -exponent), std::ldexp(g, -exponent));
}

}  // namespace carom
