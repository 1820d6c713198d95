/// \file
/// Random numbers that are the same with every compiler and library.
#pragma once

#include <carom/types.hpp>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <random>

namespace carom::test {

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    double uniform(double low, double high)
    {
        return low + (high - low) * std::ldexp(static_cast<double>(bits()), -53);
    }
    /// Uniform in the exponent, low > 0.
    double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    int integer(int low, int high)
    {
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool coin() { return (engine_() & 1) != 0; }
    double sign() { return coin() ? 1 : -1; }
    Vec3 in_cube(double half)
    {
        const double x = uniform(-half, half), y = uniform(-half, half), z = uniform(-half, half);
        return {x, y, z};
    }
    Vec3 direction()
    {
        for (;;) {
            const Vec3 d = in_cube(1);
            if (d.squaredNorm() > 0.01 && d.squaredNorm() <= 1) return d.normalized();
        }
    }
    /// A unit vector at right angles to n.
    Vec3 across(const Vec3& n)
    {
        for (;;) {
            const Vec3 c = n.cross(direction());
            if (c.squaredNorm() > 0.1) return c.normalized();
        }
    }

private:
    std::uint64_t bits() { return engine_() >> 11; }
    std::mt19937_64 engine_;
};

}  // namespace carom::test
