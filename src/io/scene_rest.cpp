#include "io/named_value.hpp"
#include "io/scene_draft.hpp"

namespace carom::io {

void read_rest(ObjectView& root, SceneDraft& draft)
{
    const auto section = root.find("rest");
    if (!section) return;
    ObjectView view(*section, root.problems());
    RestOptions& rest = draft.scene.rest;
    rest.policy = read_named<RestPolicy>(view, "policy", rest_policy_names).value_or(rest.policy);
    rest.closing_speed = view.number("closing_speed", not_negative);
    rest.window = view.number("window", not_negative);
    rest.numeric_step = view.number("numeric_step", positive);
    rest.gap_tolerance = view.number("gap_tolerance", not_negative);
    rest.series_below = view.number("series_below", not_negative).value_or(rest.series_below);
    view.finish();
}

}  // namespace carom::io
