#include <algorithm>
#include <carom/method.hpp>

#include "io/scene_draft.hpp"

namespace carom::io {

namespace {

/// Options of a command that a scene may preset: long names with `_` for `-`.
struct CommandOptions {
    std::string command;
    std::vector<std::string> now, later;
};

const std::vector<CommandOptions>& command_options()
{
    static const std::vector<CommandOptions> options{
        {"run",
         {"method",       "dt",    "substeps",   "passes",      "order",         "integrator", "literal",
          "most_impacts", "until", "max_events", "max_seconds", "final",         "kernel",     "certified",
          "impact",       "guard", "stiffness",  "hertz",       "damping_ratio", "frames"},
         {"equilibrate"}},
        {"compare",
         {"methods", "dt", "substeps", "passes", "order", "integrator", "literal", "until", "repeats", "tolerance",
          "max_seconds", "impact", "stiffness", "hertz", "damping_ratio"},
         {}},
        {"tunnel",
         {"speed", "thickness", "radius", "dt", "target", "offset", "methods", "trials", "bisect", "max_seconds"},
         {}},
        {"view", {"out"}, {}},
    };
    return options;
}

/// An entry of a list: text, or a number as the file wrote it.
std::optional<std::string> as_entry(const Place& place, Problems& problems)
{
    if (place.value->kind == Json::Kind::number) return place.value->text;
    if (place.value->kind == Json::Kind::string) return place.value->text;
    problems.add(place.pointer, "must be a number or a string, is " + describe(*place.value));
    return {};
}

std::optional<OptionValue> as_option(const Place& place, Problems& problems)
{
    switch (place.value->kind) {
        case Json::Kind::boolean:
            return place.value->boolean;
        case Json::Kind::number:
            return place.value->number;
        case Json::Kind::string:
            return place.value->text;
        case Json::Kind::array: {
            std::vector<std::string> entries;
            for (const auto& entry : as_list(place, problems))
                if (auto text = as_entry(entry, problems)) entries.push_back(*std::move(text));
            return entries;
        }
        case Json::Kind::null:
        case Json::Kind::object:
            break;
    }
    problems.add(place.pointer, "must be a value or a list of values, is " + describe(*place.value));
    return {};
}

void check_methods(const Place& place, Problems& problems)
{
    if (place.value->kind == Json::Kind::array)
        for (const auto& entry : as_list(place, problems)) as_word(entry, method_names(), {}, problems);
}

CommandDefaults read_defaults(const Place& section, const CommandOptions& options, Problems& problems)
{
    CommandDefaults defaults;
    ObjectView view(section, problems);
    const auto listed = [](const std::vector<std::string>& names, const std::string& key) {
        return std::find(names.begin(), names.end(), key) != names.end();
    };
    for (const auto& key : section.value->keys) {
        const Place place{section.value->find(key), view.pointer(key)};
        if (listed(options.later, key)) {
            problems.add(place.pointer, "not yet supported (remove it)");
        } else if (!listed(options.now, key)) {
            problems.add(place.pointer, "unknown key" + suggestion(key, options.now, "options of " + options.command));
        } else {
            // Libraries of others are methods of `tunnel`, too; which, the command knows.
            if (key == "methods" && options.command != "tunnel") check_methods(place, problems);
            if (key == "method") as_word(place, method_names(), {}, problems);
            if (auto value = as_option(place, problems)) defaults.emplace(key, *std::move(value));
        }
    }
    return defaults;
}

}  // namespace

void read_command_defaults(ObjectView& root, SceneDraft& draft)
{
    CommandDefaults* const targets[]{&draft.scene.run, &draft.scene.compare, &draft.scene.tunnel, &draft.scene.view};
    for (std::size_t i = 0; i < command_options().size(); ++i) {
        const auto& options = command_options()[i];
        if (const auto section = root.find(options.command))
            *targets[i] = read_defaults(*section, options, root.problems());
    }
}

}  // namespace carom::io
