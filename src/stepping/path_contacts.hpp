/// \file
/// The contacts of a substep in the order of time, and the paths between them: the books that methods share which find
/// contacts inside a substep.
///
/// Each sphere carries its own moment: position and velocity at `since`, straight or on a parabola from there to its
/// `target` at the end of the substep. A response changes two of them; only their contacts are looked for again. (This
/// project's own.)
#pragma once

#include "stepping/step_paths.hpp"
#include "stepping/system.hpp"

#include <cstdint>
#include <vector>

namespace carom::stepping {

/// A contact that is foreseen.
struct Pending {
    double time;        ///< since the begin of the substep
    std::int64_t rank;  ///< decides among equal times, by ContactOrder
    BodyId a, b;
    std::uint64_t stamp;  ///< of the paths that it was foreseen on
};

class PathContacts {
public:
    explicit PathContacts(std::size_t spheres) : paths(spheres) {}

    Gap gap_at(const System& system, BodyId a, BodyId b, double time) const;
    Gap gap_at_targets(const System& system, BodyId a, BodyId b) const;
    /// Rate of the gap at that time: negative when approaching [length/time].
    double gap_rate(const System& system, BodyId a, BodyId b, const Vec3& normal, double time) const;

    void forget_all() { queue_.clear(); }
    bool is_empty() const { return queue_.empty(); }
    /// \param depth that decides for ContactOrder::deepest among contacts of one time [length]
    void foresee(System& system, BodyId a, BodyId b, double time, double depth);
    /// The earliest. \pre not is_empty
    Pending pop();
    /// One of the two has got another path since.
    bool is_stale(const System& system, const Pending& pending) const
    {
        return pending.stamp != stamp(system, pending.a, pending.b);
    }

    /// Brings the state of the two to that time.
    void stop(System& system, BodyId a, BodyId b, double time);

    StepPaths paths;

private:
    static std::size_t index(BodyId body) { return static_cast<std::size_t>(body); }
    std::uint64_t stamp(const System& system, BodyId a, BodyId b) const
    {
        return paths.changes(a) + (system.detector.is_wall(b) ? 0 : paths.changes(b));
    }

    std::vector<Pending> queue_;  ///< a heap
};

}  // namespace carom::stepping
