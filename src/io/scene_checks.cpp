#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>

#include "core/text.hpp"
#include "io/limits.hpp"
#include "io/named_value.hpp"
#include "io/scene_draft.hpp"
#include "scene/check_keys.hpp"

namespace carom::io {

namespace {

constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());

class CheckReader {
public:
    explicit CheckReader(const SceneDraft& draft) : draft_(draft) {}

    std::optional<Check> read(ObjectView& view)
    {
        view.require({"type"});
        const auto type = read_named<CheckType>(view, "type", check_type_names);
        if (!type) return {};  // nobody knows which keys it may have
        const CheckKeys& keys = check_keys_of(*type);
        Check check;
        check.type = *type;
        view.one_of({"abs", "rel"}, false);
        check.abs = view.number("abs", not_negative);
        check.rel = view.number("rel", not_negative);
        for (std::size_t k = 0; k < check_key_names.size(); ++k) {
            const auto key = static_cast<CheckKey>(k);
            if (keys.required.has(key)) view.require({check_key_names[k]});
            if (keys.has(key)) read_key(key, view, check);
        }
        slips(view, keys);
        view.finish();
        return check;
    }

private:
    void read_key(CheckKey key, ObjectView& view, Check& check)
    {
        const auto whole = [&](const char* name) {
            return static_cast<std::int64_t>(view.integer(name, 0, most).value_or(0));
        };
        switch (key) {
            case CheckKey::event:
                check.index = whole("event");
                break;
            case CheckKey::time:
                check.time = view.number("time", not_negative).value_or(0);
                break;
            case CheckKey::count:
                check.count = whole("count");
                break;
            case CheckKey::kind:
                check.kind =
                    read_named<EventKind>(view, "kind", event_kind_names, first_event_kind).value_or(check.kind);
                break;
            case CheckKey::body:
                if (const auto place = view.find("body")) check.body = sphere(*place, view.problems());
                break;
            case CheckKey::value:
                check.value = view.vector("value").value_or(check.value);
                break;
            case CheckKey::between:
                if (const auto place = view.find("between")) check.between = pair(*place, view.problems());
                break;
        }
    }

    /// Words that are as good as the right ones.
    static void slips(ObjectView& view, const CheckKeys& keys)
    {
        if (keys.has(CheckKey::body)) view.never({"sphere", "ball", "id"}, "did you mean \"body\"?");
        if (keys.has(CheckKey::value)) view.never({"position", "velocity", "by"}, "did you mean \"value\"?");
        if (keys.has(CheckKey::time) && !keys.has(CheckKey::value))
            view.never({"value", "t"}, "did you mean \"time\"?");
        if (keys.has(CheckKey::count)) view.never({"value", "number"}, "did you mean \"count\"?");
        view.never({"tolerance", "tol"}, "did you mean \"abs\" or \"rel\"?");
    }

    void know_bodies()
    {
        for (const Sphere& sphere : draft_.scene.spheres) ids_.push_back(sphere.id);
        for (const Plane& plane : draft_.scene.planes) ids_.push_back(plane.id);
        for (std::size_t i = 0; i < ids_.size(); ++i) bodies_.try_emplace(ids_[i], static_cast<BodyId>(i));
    }

    /// The two bodies of an impact, one of which may be a plane.
    std::optional<std::array<BodyId, 2>> pair(const Place& place, Problems& problems)
    {
        const std::vector<Place> names = as_list(place, problems);
        if (names.size() != 2) {
            problems.add(place.pointer, "must be two ids");
            return {};
        }
        return std::array{any_body(names[0], problems), any_body(names[1], problems)};
    }

    BodyId sphere(const Place& place, Problems& problems)
    {
        return named(place, draft_.scene.spheres.size(), "no sphere has the id ", problems);
    }

    BodyId any_body(const Place& place, Problems& problems)
    {
        return named(place, draft_.scene.spheres.size() + draft_.scene.planes.size(), "no sphere or plane has the id ",
                     problems);
    }

    /// One of the first `count` bodies.
    BodyId named(const Place& place, std::size_t count, const char* missing, Problems& problems)
    {
        const auto id = as_string(place, problems);
        if (!id) return no_body;
        if (bodies_.empty()) know_bodies();  // most scenes have no check that names a body
        const auto found = bodies_.find(*id);
        if (found != bodies_.end() && static_cast<std::size_t>(found->second) < count) return found->second;
        if (!draft_.bodies_complete) return no_body;  // it may be one of those left out
        const std::vector<std::string> known(
            ids_.begin(), ids_.begin() + static_cast<std::ptrdiff_t>(std::min(count, most_candidates)));
        problems.add(place.pointer, missing + quoted(*id) + suggestion(*id, known, "known"));
        return no_body;
    }

    const SceneDraft& draft_;
    std::vector<std::string> ids_;  ///< as events number bodies
    std::unordered_map<std::string_view, BodyId> bodies_;
};

}  // namespace

void read_checks(ObjectView& root, SceneDraft& draft)
{
    const std::vector<Place> list = root.list("checks");
    if (list.empty()) return;
    CheckReader reader(draft);
    for (const Place& place : list) {
        const std::size_t before = root.problems().count();
        ObjectView view(place, root.problems());
        const auto check = reader.read(view);
        const bool of_missing_body =
            check && ((view.has("body") && check->body == no_body) ||
                      (check->between && ((*check->between)[0] == no_body || (*check->between)[1] == no_body)));
        if (check && !of_missing_body && root.problems().count() == before) draft.scene.checks.push_back(*check);
    }
}

}  // namespace carom::io
