#include "cli/arguments.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace carom::cli {

namespace {

constexpr std::array<std::string_view, 3> later_commands{"view", "export", "query"};
constexpr std::array<std::string_view, 2> later_options{"--save-state", "--equilibrate"};

template <typename List>
bool contains(const List& list, std::string_view word)
{
    return std::find(list.begin(), list.end(), word) != list.end();
}

std::string refusal(std::string_view what)
{
    return std::string(what) + ": not yet (planned)";
}

}  // namespace

std::optional<std::string> later_feature(const std::vector<std::string>& args)
{
    std::vector<std::string_view> words;  // commands and scenes: all but options and the value of --seed
    for (std::size_t i = 0; i < args.size(); ++i) {
        const std::string_view arg = args[i];
        if (arg == "--") break;
        if (contains(later_options, arg.substr(0, arg.find('=')))) return refusal(arg.substr(0, arg.find('=')));
        if (arg == "--seed")
            ++i;
        else if (!arg.starts_with("-"))
            words.push_back(arg);
    }
    if (words.empty()) return std::nullopt;
    if (contains(later_commands, words[0])) return refusal(words[0]);
    return std::nullopt;
}

}  // namespace carom::cli
