#include "motion/state.hpp"

namespace carom {

State::State(const Scene& s, Precision p)
    : scene(s),
      precision(p),
      frame(make_frame(s)),
      laws(s),
      rest(rest_thresholds(s)),
      drag(s.drag),
      tolerances(make_tolerances(s, rest)),
      loses_energy(laws.lose_energy()),
      rebound_gap(loses_energy && s.rest.policy == RestPolicy::contact && p == Precision::plain
                      ? rest.closing_speed * rest.window / 4
                      : 0),
      bodies(s, frame, p),
      recent(frame, rest.window, s.spheres.size())
{
}

}  // namespace carom
