/// \file
/// Families of queries that defeat rounding, each by another way.
#pragma once

#include "adversary/query.hpp"
#include "support/random.hpp"

#include <functional>
#include <string>
#include <vector>

namespace carom::test {

struct Family {
    std::string name;
    std::function<Query(Random&)> make;
    int share = 8;              ///< of the queries
    bool needs_digits = false;  ///< 700 instead of 200
};

std::vector<Family> sphere_families();
std::vector<Family> plane_families();
std::vector<Family> accelerated_families();

inline std::vector<Family> all_families()
{
    std::vector<Family> all = sphere_families();
    for (auto&& more : {plane_families(), accelerated_families()}) all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace carom::test
