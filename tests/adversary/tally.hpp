/// \file
/// Asks the kernel what an adversary thinks up and compares with many digits.
#pragma once

#include "adversary/families.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace carom::test {

struct Tally {
    std::string family;
    long long queries = 0, impacts = 0, touching = 0, none = 0;
    long long missed = 0, spurious = 0, wrong_status = 0;
    long long outside = 0;     ///< exact time not in [t_lo, t_hi]
    long long beyond_ulp = 0;  ///< t more than 1 ulp from it
    long long asymmetric = 0;  ///< exchanged or scaled by a power of two, and another answer
    long long undecided = 0;   ///< by the oracle
    long long level[3] = {0, 0, 0};
    double worst_ulp = 0, widest_ulp = 0;
    std::string example;  ///< of the first failure

    long long failures() const { return missed + spurious + wrong_status + outside + beyond_ulp + asymmetric; }
};

/// About `count` queries over all families, each family its share.
std::vector<Tally> challenge(long long count, std::uint64_t seed);

std::string table(const std::vector<Tally>& tallies);

}  // namespace carom::test
