/// \file
/// Overlaps that frames show, each from the first frame to the last one of it.
#pragma once

#include "audit/around.hpp"
#include "audit/report.hpp"

#include <map>

namespace carom::audit {

class OverlapWatch {
public:
    /// The scene must outlive it.
    explicit OverlapWatch(const Scene& scene) : scene_(scene) {}

    /// Looks at the frame `to`, which comes after `from` or is the same, and among spheres at the pairs given and at
    /// what overlapped before. \return the overlaps that have ended
    std::vector<Finding> look(const SeenFrame& from, const SeenFrame& to, const std::vector<Pair>& near);
    /// Overlaps that have not ended.
    std::vector<Finding> rest() const;

    Pairs pairs() const;

private:
    double depth(const Pair& pair, const SeenFrame& frame) const;
    double tolerance(const Pair& pair, const SeenFrame& frame) const;
    bool overlaps(const Pair& pair, const SeenFrame& frame) const;
    Finding begun(const Pair& pair, const SeenFrame& from, const SeenFrame& to) const;

    const Scene& scene_;
    std::map<Pair, Finding> going_on_;
};

}  // namespace carom::audit
