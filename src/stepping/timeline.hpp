/// \file
/// When steps and substeps begin and end. Every time is computed from its number, so nothing accumulates.
#pragma once

#include "stepping/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace carom::stepping {

struct Substep {
    double begin;   ///< since the start [time]
    double length;  ///< h [time]
    double end;     ///< the begin of the next one, exactly [time]
};

class Timeline {
public:
    /// \pre dt > 0, substeps >= 1, until >= 0.
    Timeline(double until, double dt, int substeps) : until_(until), dt_(dt), substeps_(substeps)
    {
        const double steps = std::min(until / dt - step_remainder, most_steps);
        steps_ = until > 0 ? std::max<std::int64_t>(1, static_cast<std::int64_t>(steps)) : 0;
        if (until > 0 && static_cast<double>(steps_) < steps) ++steps_;
    }

    std::int64_t steps() const { return steps_; }

    Substep substep(std::int64_t step, int k) const
    {
        const bool last = step + 1 == steps_;
        const double start = static_cast<double>(step) * dt_;
        const double end = last ? until_ : static_cast<double>(step + 1) * dt_;
        const double h = (last ? until_ - start : dt_) / substeps_;
        return {k == 0 ? start : start + k * h, h, k + 1 == substeps_ ? end : start + (k + 1) * h};
    }

private:
    double until_, dt_;
    int substeps_;
    std::int64_t steps_;
};

}  // namespace carom::stepping
