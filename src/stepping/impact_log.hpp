/// \file
/// Counts impacts, sums impulses on planes and reports events.
#pragma once

#include "stepping/contact.hpp"
#include "stepping/response.hpp"

#include <carom/simulate.hpp>

#include <functional>
#include <vector>

namespace carom::stepping {

class ImpactLog {
public:
    /// \param merge a contact may get several impulses in one substep: report their sum once, at `close`.
    ImpactLog(const Scene& scene, const Observer& observer, bool merge);

    void add(const Contact& contact, const Impulse& impulse, double time);
    /// An impulse that is no event: of a contact that rests, or goes on. A plane feels it [mass length/time].
    void press(const Contact& contact, double impulse);
    /// End of a substep.
    void close();

    std::int64_t count() const { return count_; }
    const std::vector<double>& plane_impulses() const { return plane_impulses_; }

private:
    struct Pending {
        Event event;
        std::size_t sequence;
    };

    const std::function<void(const Event&)>& on_event_;
    bool merge_;
    BodyId spheres_;
    std::int64_t count_ = 0;
    std::vector<double> plane_impulses_;
    std::vector<Pending> pending_;
};

}  // namespace carom::stepping
