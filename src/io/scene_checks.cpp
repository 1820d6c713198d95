#include <limits>
#include <unordered_map>

#include "core/text.hpp"
#include "io/limits.hpp"
#include "io/scene_draft.hpp"

namespace carom::io {

namespace {

constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());

class CheckReader {
public:
    explicit CheckReader(const SceneDraft& draft) : draft_(draft) {}

    std::optional<Check> read(ObjectView& view)
    {
        Check check;
        view.require({"type"});
        const auto type = view.word("type", {"no_overlap", "energy", "momentum", "inside", "event_time", "event_count",
                                             "rest_time", "final_position", "final_velocity"});
        if (!type) return {};  // nobody knows which keys it may have
        check.type = *type;
        view.one_of({"abs", "rel"}, false);
        check.abs = view.number("abs", not_negative);
        check.rel = view.number("rel", not_negative);
        if (*type == "event_time") {
            view.require({"event", "time"});
            check.index = static_cast<std::int64_t>(view.integer("event", 0, most).value_or(0));
            check.time = view.number("time", not_negative).value_or(0);
        } else if (*type == "event_count") {
            view.require({"count"});
            check.count = static_cast<std::int64_t>(view.integer("count", 0, most).value_or(0));
            check.kind = view.word("kind", {"impact", "rest", "release", "guard", "settle"}).value_or("impact");
        } else if (*type == "rest_time") {
            view.require({"body", "time"});
            check.body = body(view);
            check.time = view.number("time", not_negative).value_or(0);
        } else if (*type == "final_position" || *type == "final_velocity") {
            view.require({"body", "value"});
            check.body = body(view);
            check.value = view.vector("value").value_or(check.value);
        }
        slips(view, *type);
        view.finish();
        return check;
    }

private:
    /// Words that are as good as the right ones.
    static void slips(ObjectView& view, const std::string& type)
    {
        const bool vector = type == "final_position" || type == "final_velocity";
        if (vector || type == "rest_time") view.never({"sphere", "ball", "id"}, "did you mean \"body\"?");
        if (vector) view.never({"position", "velocity"}, "did you mean \"value\"?");
        if (type == "rest_time" || type == "event_time") view.never({"value", "t"}, "did you mean \"time\"?");
        if (type == "event_count") view.never({"value", "number"}, "did you mean \"count\"?");
        view.never({"tolerance", "tol"}, "did you mean \"abs\" or \"rel\"?");
    }

    BodyId body(ObjectView& view)
    {
        const auto id = view.string("body");
        if (!id) return no_body;
        if (bodies_.empty()) {  // most scenes have no check that names a body
            const auto& spheres = draft_.scene.spheres;
            for (std::size_t i = 0; i < spheres.size(); ++i) bodies_.try_emplace(spheres[i].id, static_cast<BodyId>(i));
        }
        const auto found = bodies_.find(*id);
        if (found != bodies_.end()) return found->second;
        if (!draft_.bodies_complete) return no_body;  // it may be one of those left out
        std::vector<std::string> known;
        for (const auto& s : draft_.scene.spheres)
            if (known.size() < most_candidates) known.push_back(s.id);
        view.problem("body", "no sphere has the id " + quoted(*id) + suggestion(*id, known, "known"));
        return no_body;
    }

    const SceneDraft& draft_;
    std::unordered_map<std::string_view, BodyId> bodies_;
};

}  // namespace

void read_checks(ObjectView& root, SceneDraft& draft)
{
    CheckReader reader(draft);
    for (const auto& place : root.list("checks")) {
        const std::size_t before = root.problems().count();
        ObjectView view(place, root.problems());
        const auto check = reader.read(view);
        const bool of_missing_body = check && view.has("body") && check->body == no_body;
        if (check && !of_missing_body && root.problems().count() == before) draft.scene.checks.push_back(*check);
    }
}

}  // namespace carom::io
