/// \file
/// The flight that each sphere is on. Of what few flights have (low parts, accelerations of their own) nothing is kept
/// where none has it: of a million spheres every byte counts.
#pragma once

#include "verify/path.hpp"

#include <array>
#include <unordered_map>
#include <vector>

namespace carom::verification {

class Flights {
public:
    void reserve(std::size_t bodies) { kept_.reserve(bodies); }
    std::size_t size() const { return kept_.size(); }
    void add(const Path& path)
    {
        kept_.emplace_back();
        set(static_cast<BodyId>(kept_.size() - 1), path);
    }
    void set(BodyId body, const Path& path);
    Path path(BodyId body) const;
    const EpochTime& start(BodyId body) const { return kept_[static_cast<std::size_t>(body)].start; }

    double drag = 0;                                  ///< of the run [1/epoch]
    std::unordered_map<BodyId, SeriesRecord> series;  ///< of those whose mode says so [cells], [epochs]

private:
    struct Kept {
        EpochTime start;
        std::int64_t cell[3];
        double local[3], velocity[3];
        std::int32_t acceleration, support;
        Mode mode;
        bool guarded;
    };
    struct Low {
        double local[3] = {0, 0, 0}, velocity[3] = {0, 0, 0};
    };

    std::vector<Kept> kept_;
    std::vector<Low> low_;
    std::vector<std::array<double, 3>> own_;
};

}  // namespace carom::verification
