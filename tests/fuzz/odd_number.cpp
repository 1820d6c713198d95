#include "fuzz/fuzz.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace carom::fuzz {

void finding(const std::string& what)
{
    std::fprintf(stderr, "finding: %s\n", what.c_str());
    std::abort();
}

double odd_number(Random& random, double near)
{
    static constexpr std::array<double, 20> odd{
        0,   -0.0, 1,    -1,    0.5,  2,      3,      10,        0.1,      1e-3,
        1e3, 1e9,  1e-9, -1e16, 1e16, 1e-300, -1e300, 0x1p-1074, 0x1p1000, 1.7976931348623157e308};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double x = near;
    switch (random.below(8)) {
        case 0:
        case 1:
            return odd[random.below(odd.size())];
        case 2:
            x = std::ldexp(near, static_cast<int>(random.below(41)) - 20);
            break;
        case 3:
            x = std::ldexp(near, static_cast<int>(random.below(2001)) - 1000);
            break;
        case 4:
            x = std::nextafter(near, random.below(2) == 0 ? infinity : -infinity);
            break;
        case 5:
            x = -near;
            break;
        case 6:
            x = random.uniform(-10, 10);
            break;
        default:
            x = std::round(random.uniform(-20, 20));
    }
    return std::isfinite(x) ? x : near;
}

}  // namespace carom::fuzz
