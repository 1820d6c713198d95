#include <algorithm>

#include "io/scene_draft.hpp"

namespace carom::io {

void read_materials(ObjectView& root, SceneDraft& draft)
{
    const auto section = root.find("materials");
    if (!section) return;
    ObjectView all(*section, root.problems());
    for (const auto& name : section->value->keys) {
        ObjectView view(*all.find(name), root.problems());
        Material material;
        material.name = name;
        material.restitution = view.number("restitution", fraction).value_or(material.restitution);
        material.tangential = view.number("tangential", fraction).value_or(material.tangential);
        material.color = read_color(view);
        view.never(
            {"friction", "mu"},
            "there is no friction; \"tangential\" is the part of the velocity along a plane that an impact keeps");
        view.finish();
        auto& materials = draft.scene.materials;
        if (name == materials.front().name)
            materials.front() = material;  // the file says what "default" is
        else
            materials.push_back(material);
    }
}

namespace {

std::optional<ContactRule> read_contact(ObjectView& view, const Scene& scene)
{
    ContactRule rule;
    view.require({"between"});
    const auto names = view.list("between");
    rule.restitution = view.number("restitution", fraction);
    rule.tangential = view.number("tangential", fraction);
    rule.attenuation = view.number("attenuation", fraction);
    view.finish();
    constexpr std::size_t two = 2;
    if (names.size() != two) {
        if (view.has("between")) view.problem("between", "must be a list of 2 materials");
        return {};
    }
    const auto a = as_material(names[0], scene, view.problems());
    const auto b = as_material(names[1], scene, view.problems());
    if (!a || !b) return {};
    rule.a = *a;
    rule.b = *b;
    return rule;
}

}  // namespace

void read_contacts(ObjectView& root, SceneDraft& draft)
{
    auto& contacts = draft.scene.contacts;
    for (const auto& place : root.list("contacts")) {
        ObjectView view(place, root.problems());
        const auto rule = read_contact(view, draft.scene);
        if (!rule) continue;
        const bool repeated = std::any_of(contacts.begin(), contacts.end(), [&](const ContactRule& c) {
            return std::minmax(c.a, c.b) == std::minmax(rule->a, rule->b);
        });
        if (repeated)
            view.problem("between", "an earlier entry is for the same two materials (keep one)");
        else
            contacts.push_back(*rule);
    }
}

}  // namespace carom::io
