/// \file
/// Helpers of the scene file tests: what a text is refused for.
#pragma once

#include <carom/io.hpp>
#include <string>
#include <vector>

namespace carom::test {

/// The problems that reading `text` as "s.json" reports; empty if it is accepted.
inline std::vector<std::string> problems_of(const std::string& text)
{
    try {
        parse_scene(text, "s.json");
    } catch (const InputError& error) {
        return error.problems();
    }
    return {};
}

/// A scene with nothing but `members` (and commas) added to what every scene needs.
inline std::string scene_with(const std::string& members)
{
    return R"({"format": "carom-scene/1", "end_time": 1)" + (members.empty() ? "" : ", " + members) + "}";
}

/// The one problem of a scene with these members; a text that no problem begins with if there are none or several.
inline std::string problem_with(const std::string& members)
{
    const auto problems = problems_of(scene_with(members));
    return problems.size() == 1 ? problems.front() : "(" + std::to_string(problems.size()) + " problems)";
}

}  // namespace carom::test
