#include "io/json_text.hpp"
#include "io/named_value.hpp"
#include "io/scene_draft.hpp"

namespace carom::io {

namespace {

/// JSON on one line; numbers keep their digits.
void append_json(std::string& text, const Json& json)
{
    const bool is_object = json.kind == Json::Kind::object;
    switch (json.kind) {
        case Json::Kind::null:
            text += "null";
            break;
        case Json::Kind::boolean:
            text += json.boolean ? "true" : "false";
            break;
        case Json::Kind::number:
            text += json.text;
            break;
        case Json::Kind::string:
            append_string(text, json.text);
            break;
        case Json::Kind::array:
        case Json::Kind::object:
            text += is_object ? '{' : '[';
            for (std::size_t k = 0; k < json.items.size(); ++k) {
                if (k > 0) text += ',';
                if (is_object) {
                    append_string(text, json.keys[k]);
                    text += ':';
                }
                append_json(text, json.items[k]);
            }
            text += is_object ? '}' : ']';
            break;
    }
}

std::vector<std::string> read_changes(ObjectView& view)
{
    std::vector<std::string> changes;
    const auto set = view.find("set");
    if (!set) return changes;
    if (set->value->kind != Json::Kind::object || set->value->items.empty()) {
        view.problem("set", "must be an object of values by pointer (write {\"/end_time\": 2})");
        return changes;
    }
    for (std::size_t k = 0; k < set->value->items.size(); ++k) {
        std::string text = set->value->keys[k];
        if (!text.starts_with('/')) view.problem("set", "\"" + text + "\" must begin with / (write \"/" + text + "\")");
        text += '=';
        append_json(text, set->value->items[k]);
        changes.push_back(std::move(text));
    }
    return changes;
}

std::vector<StressMember> read_members(ObjectView& stress)
{
    std::vector<StressMember> members;
    for (const Place& place : stress.list("members")) {
        ObjectView view(place, stress.problems());
        view.require({"name", "set"});
        StressMember member{view.string("name").value_or(""), read_changes(view)};
        if (member.name.empty()) view.problem("name", "must not be empty");
        view.finish();
        members.push_back(std::move(member));
    }
    return members;
}

}  // namespace

void read_stress(ObjectView& root, SceneDraft& draft)
{
    const auto section = root.find("stress");
    if (!section) return;
    ObjectView view(*section, root.problems());
    view.require({"case", "dt", "exact"});
    StressPart& stress = draft.scene.stress.emplace();
    stress.case_name = view.string("case").value_or("");
    stress.dt = view.number("dt", positive).value_or(1);
    stress.exact = view.number("exact", not_negative).value_or(0);
    stress.limit = view.number("limit", not_negative).value_or(stress.limit);
    stress.title = view.string("title").value_or("");
    stress.figure = view.string("figure").value_or("");
    stress.step = view.string("step").value_or("");
    stress.stiffness = view.number("stiffness", positive);
    stress.members = read_members(view);
    if (const auto waits_for = view.string("waits_for")) {
        if (waits_for->empty()) view.problem("waits_for", "must not be empty (leave it out)");
        stress.waits_for = *waits_for;
    }
    if (const auto causes = view.find("causes")) {
        ObjectView words(*causes, root.problems());
        for (const std::string_view name : symptom_names) {
            const Symptom symptom = *value_named<Symptom>(name, symptom_names);
            if (symptom == Symptom::none) continue;  // needs no cause
            if (auto cause = words.string(name)) stress.causes.emplace(symptom, *std::move(cause));
        }
        words.finish();
    }
    view.finish();
}

}  // namespace carom::io
