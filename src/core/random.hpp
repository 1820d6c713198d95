/// \file
/// Random numbers that are the same with every compiler: xoshiro256** (Blackman and Vigna, Scrambled linear
/// pseudorandom number generators, 2021) seeded by splitmix64 (Steele, Lea, Flood, Fast splittable pseudorandom number
/// generators, 2014). No distribution of the standard library (they differ between libraries) and no libm but sqrt.
#pragma once

#include "core/limits.hpp"

#include <array>
#include <bit>
#include <carom/types.hpp>
#include <cmath>
#include <cstdint>

namespace carom {

/// One step of splitmix64: advances `state` and returns 64 well mixed bits.
constexpr std::uint64_t split_mix(std::uint64_t& state)
{
    state += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

class Random {
public:
    /// Generators of one seed with different streams are independent, so that a further draw here moves nothing there.
    explicit constexpr Random(std::uint64_t seed, std::uint64_t stream = 0)
    {
        std::uint64_t mixer = seed;
        const std::uint64_t base = split_mix(mixer);
        std::uint64_t state = base ^ (stream * 0xd1342543de82ef95ULL);
        for (auto& word : state_) word = split_mix(state);
    }

    constexpr std::uint64_t bits()
    {
        const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
        const std::uint64_t t = state_[1] << 17;
        state_[2] ^= state_[0];
        state_[3] ^= state_[1];
        state_[1] ^= state_[2];
        state_[0] ^= state_[3];
        state_[2] ^= t;
        state_[3] = std::rotl(state_[3], 45);
        return result;
    }

    /// Uniform in [0, 1), a multiple of 2^-53.
    constexpr double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

    /// Uniform in [low, high).
    constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// Uniform among 0 .. n-1. \pre 0 < n < 2^53 (the bias is below n 2^-53).
    constexpr std::size_t below(std::size_t n)
    {
        const auto k = static_cast<std::size_t>(uniform() * static_cast<double>(n));
        return k < n ? k : n - 1;
    }

    /// Isotropic unit vector: a point of the unit ball by rejection from the cube, normalised.
    Vec3 direction()
    {
        for (int k = 0; k < most_direction_draws; ++k) {
            const double x = uniform(-1, 1);
            const double y = uniform(-1, 1);
            const double z = uniform(-1, 1);
            const double norm2 = x * x + y * y + z * z;
            if (norm2 > least_direction_square && norm2 <= 1) return Vec3(x, y, z) / std::sqrt(norm2);
        }
        return Vec3::UnitX();
    }

private:
    std::array<std::uint64_t, 4> state_{};
};

}  // namespace carom
