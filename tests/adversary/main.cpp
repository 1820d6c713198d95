/// \file
/// carom_toi_adversary [COUNT] [SEED]: COUNT queries (1e6) over all families against hundreds of digits. Exit 1 if one
/// answer is wrong.
#include "adversary/tally.hpp"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv)
{
    const double count = argc > 1 ? std::strtod(argv[1], nullptr) : 1e6;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    if (!(count >= 1 && count <= 1e12)) {
        std::fputs("usage: carom_toi_adversary [COUNT] [SEED]\n", stderr);
        return 2;
    }
    const auto tallies = carom::test::challenge(static_cast<long long>(count), seed);
    std::fputs(carom::test::table(tallies).c_str(), stdout);
    for (const auto& tally : tallies)
        if (tally.failures() > 0) return 1;
    return 0;
}
