#include "io/named_value.hpp"
#include "io/scene_draft.hpp"

namespace carom::io {

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
