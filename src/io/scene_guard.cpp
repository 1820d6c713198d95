#include "io/named_value.hpp"
#include "io/scene_draft.hpp"

#include <limits>

namespace carom::io {

void read_guard(ObjectView& root, SceneDraft& draft)
{
    const auto section = root.find("guard");
    if (!section) return;
    GuardOptions& guard = draft.scene.guard;
    if (section->value->kind == Json::Kind::string) {
        guard.on = as_word(*section, {"on", "off"}, {}, root.problems()) != "off";
        return;
    }
    if (section->value->kind != Json::Kind::object) {
        root.problem("guard", "must be \"on\", \"off\" or an object, is " + describe(*section->value));
        return;
    }
    constexpr std::uint64_t most = std::numeric_limits<int>::max();
    ObjectView view(*section, root.problems());
    guard.impacts =
        static_cast<int>(view.integer("impacts", 1, most).value_or(static_cast<std::uint64_t>(guard.impacts)));
    guard.window = view.number("window", positive);
    guard.fallback = read_named<GuardFallback>(view, "fallback", guard_fallback_names).value_or(guard.fallback);
    view.finish();
}

}  // namespace carom::io
