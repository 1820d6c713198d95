/// \file
/// What many trials say together.
#pragma once

#include "generated/trial.hpp"

#include <cstdint>
#include <map>
#include <string>

namespace carom::test {

class Tally {
public:
    void add(std::uint64_t index, const std::string& kind, const Trial& trial);
    /// For people: shares, the worst of everything and where, and the targets that are missed.
    std::string table(double seconds) const;
    /// 99 % to the end, all with a status, no more impacts than the bound, guarded body-seconds at most 0.1 % and
    /// numeric ones at most 5 % of all, no sphere lost, no penetration deeper than stated.
    bool targets_met() const;

private:
    struct Worst {
        double value = 0;
        std::uint64_t index = 0;
        void add(double x, std::uint64_t i)
        {
            if (x > value) *this = {x, i};
        }
    };
    struct Share {
        long long all = 0, reached = 0;
        double bodies = 0, numeric = 0;  ///< body-seconds
    };

    long long all_ = 0, lost_ = 0, deeper_ = 0, no_status_ = 0;
    std::map<std::string, Share> kinds_;
    std::map<std::string, long long> statuses_;
    double closed_form_ = 0, numeric_ = 0, guarded_ = 0, cpu_ = 0;
    Worst busiest_, penetration_, slowest_;
    Counts counts_;
};

}  // namespace carom::test
