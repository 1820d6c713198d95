#include "core/random.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using carom::Random;
using carom::Vec3;

TEST_CASE("splitmix64 gives its published sequence", "[scene]")
{
    std::uint64_t state = 1234567;  // the test vector of the Java and Rosetta code implementations
    CHECK(carom::split_mix(state) == 6457827717110365317ULL);
    CHECK(carom::split_mix(state) == 3203168211198807973ULL);
    CHECK(carom::split_mix(state) == 9817491932198370423ULL);
}

TEST_CASE("random numbers are the same everywhere and differ between seeds and streams", "[scene]")
{
    Random a(1), b(1), c(2), d(1, 1);
    const std::uint64_t first = a.bits();
    CHECK(first == b.bits());
    CHECK(first != c.bits());
    CHECK(first != d.bits());
}

TEST_CASE("uniform numbers fill the unit interval evenly", "[scene]")
{
    Random random(7);
    constexpr int n = 200'000, bins = 20;
    std::vector<int> count(bins);
    for (int i = 0; i < n; ++i) {
        const double u = random.uniform();
        REQUIRE((u >= 0 && u < 1));
        ++count[static_cast<std::size_t>(u * bins)];
    }
    double chi2 = 0;
    for (const int k : count) chi2 += (k - n / bins) * (k - n / bins) / static_cast<double>(n / bins);
    CHECK(chi2 < 43.8);  // 99.9 % of 19 degrees of freedom
    CHECK(chi2 > 5.4);   // 0.1 %: too even is not random either
}

TEST_CASE("random directions are unit vectors without a preferred axis", "[scene]")
{
    Random random(3);
    constexpr int n = 100'000;
    Vec3 sum = Vec3::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (int i = 0; i < n; ++i) {
        const Vec3 u = random.direction();
        REQUIRE(std::abs(u.norm() - 1) < 1e-15);
        sum += u;
        second += u * u.transpose();
    }
    const double sigma = 1 / std::sqrt(3.0 * n);
    CHECK(sum.cwiseAbs().maxCoeff() / n < 4 * sigma);
    CHECK((second / n - Eigen::Matrix3d::Identity() / 3).cwiseAbs().maxCoeff() < 4 * 0.3 / std::sqrt(n));
}
