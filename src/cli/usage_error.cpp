#include "cli/usage_error.hpp"

#include "io/problems.hpp"

#include <algorithm>

namespace carom::cli {

namespace {

std::vector<std::string> commands_of(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::App* each : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(each->get_name());
    return names;
}

std::vector<std::string> options_of(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

/// The command that was typed, down to the last level.
const CLI::App& deepest(const CLI::App& app)
{
    const auto below = app.get_subcommands();
    return below.empty() ? app : deepest(*below.front());
}

std::string full_name(const CLI::App& app, const CLI::App& command)
{
    return &command == &app ? app.get_name() : full_name(app, *command.get_parent()) + " " + command.get_name();
}

std::string unexpected(const CLI::App& app, const CLI::App& command)
{
    const std::vector<std::string> rest = app.remaining(true);
    const auto option = std::find_if(rest.begin(), rest.end(), [](const auto& word) { return word.starts_with("-"); });
    if (option == rest.end())
        return "unexpected argument" + (rest.empty() ? "" : " \"" + rest.front() + "\"") + " (" +
               full_name(app, command) + " -h shows what it takes)";
    std::vector<std::string> known = options_of(command);
    for (const std::string& name : options_of(app)) known.push_back(name);
    const std::string typed = option->substr(0, option->find('='));
    const std::string near = io::nearest(typed, known);
    return "unknown option " + typed +
           (near.empty() ? " (" + full_name(app, command) + " -h lists them)" : " (did you mean " + near + "?)");
}

}  // namespace

std::string usage_error(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& args)
{
    const CLI::App& command = deepest(app);
    if (&command == &app && !args.empty() && !args[0].starts_with("-"))
        return "carom: unknown command \"" + args[0] + "\"" + io::suggestion(args[0], commands_of(app), "take") + "\n";
    const std::string start = full_name(app, command) + ": ";
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) return start + unexpected(app, command) + "\n";
    const std::string what = error.what();
    if (dynamic_cast<const CLI::RequiredError*>(&error) == nullptr) return start + what + "\n";
    if (&command == &app) return start + "a command is missing" + io::suggestion("", commands_of(app), "take") + "\n";
    const std::string missing = what.substr(0, what.find(" is required"));
    return start + "the " + missing + " is missing (" + full_name(app, command) + " -h has examples)\n";
}

}  // namespace carom::cli
