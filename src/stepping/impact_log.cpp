#include "stepping/impact_log.hpp"

#include <algorithm>
#include <tuple>

namespace carom::stepping {

ImpactLog::ImpactLog(const Scene& scene, const Observer& observer, bool merge)
    : on_event_(observer.on_event),
      merge_(merge),
      spheres_(static_cast<BodyId>(scene.spheres.size())),
      plane_impulses_(scene.planes.size(), 0.0)
{
}

void ImpactLog::add(const Contact& contact, const Impulse& impulse, double time)
{
    press(contact, impulse.normal);
    if (!merge_) ++count_;
    if (!merge_ && !on_event_) return;
    const Event event{EventKind::impact, {0, time}, time, contact.a, contact.b, contact.normal, impulse.on_a};
    if (merge_) {
        pending_.push_back({event, pending_.size()});
    } else {
        on_event_(event);
    }
}

void ImpactLog::press(const Contact& contact, double impulse)
{
    if (contact.b >= spheres_) plane_impulses_[static_cast<std::size_t>(contact.b - spheres_)] += impulse;
}

void ImpactLog::close()
{
    if (pending_.empty()) return;
    // Bring the impulses of one contact together, add them up in the first, and restore the order of the firsts.
    std::sort(pending_.begin(), pending_.end(), [](const Pending& x, const Pending& y) {
        return std::tie(x.event.a, x.event.b, x.sequence) < std::tie(y.event.a, y.event.b, y.sequence);
    });
    std::size_t last = 0;
    for (std::size_t k = 1; k < pending_.size(); ++k) {
        if (pending_[k].event.a == pending_[last].event.a && pending_[k].event.b == pending_[last].event.b) {
            pending_[last].event.impulse += pending_[k].event.impulse;
        } else {
            pending_[++last] = pending_[k];
        }
    }
    pending_.resize(last + 1);
    count_ += static_cast<std::int64_t>(pending_.size());
    if (on_event_) {
        std::sort(pending_.begin(), pending_.end(),
                  [](const Pending& x, const Pending& y) { return x.sequence < y.sequence; });
        for (const Pending& p : pending_) on_event_(p.event);
    }
    pending_.clear();
}

}  // namespace carom::stepping
