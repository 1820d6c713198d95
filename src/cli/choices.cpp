#include "cli/choices.hpp"

#include "cli/exit_codes.hpp"
#include "cli/limits.hpp"
#include "cli/lists.hpp"
#include "cli/peer_rows.hpp"
#include "core/names.hpp"
#include "io/problems.hpp"

#include <carom/error.hpp>
#include <carom/features.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace carom::cli {

namespace {

std::string text_of(const OptionValue& value)
{
    if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const double* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
    if (const std::string* text = std::get_if<std::string>(&value)) return *text;
    std::string list;
    for (const std::string& item : std::get<std::vector<std::string>>(value)) list += (list.empty() ? "" : ",") + item;
    return list;
}

double positive(double value, const std::string& text)
{
    if (!(value > 0)) throw std::invalid_argument("\"" + text + "\" must be > 0");
    return value;
}

long long at_least_one(const std::string& text)
{
    return parse_integer(text, 1, largest_count);
}

ImpactOperator impact_operator(std::string_view word)
{
    if (const auto known = value_named<ImpactOperator>(word, impact_operator_names)) return *known;
    const std::string text(word);
    throw InputError(
        {"unknown operator \"" + text + "\"" + io::suggestion(text, words_of(impact_operator_names), "take")});
}

void expect_known_word(const std::string& word, const std::vector<std::string>& known, const std::string& what)
{
    if (std::find(known.begin(), known.end(), word) != known.end()) return;
    const std::string near = io::nearest(word, known);
    throw std::invalid_argument(fmt::format("unknown {} \"{}\" ({}take {})", what, word,
                                            near.empty() ? "" : "did you mean \"" + near + "\"? ",
                                            fmt::join(known, ", ")));
}

}  // namespace

Choices::Choices(const GivenOptions& given, const CommandDefaults& defaults, std::string place)
    : given_(given), place_(std::move(place))
{
    for (const auto& [key, value] : defaults) defaults_[key] = text_of(value);
}

template <typename T, typename Parse>
T Choices::read(const std::string& name, T otherwise, Parse parse) const
{
    if (const auto typed = given_.find(name); typed != given_.end()) try {
            return parse(typed->second);
        } catch (const std::invalid_argument& error) {
            std::string option = name;
            std::replace(option.begin(), option.end(), '_', '-');
            throw UsageError("--" + option + ": " + error.what());
        }
    if (const auto written = defaults_.find(name); written != defaults_.end()) try {
            return parse(written->second);
        } catch (const std::invalid_argument& error) {
            throw InputError({place_ + "/" + name + ": " + error.what()});
        }
    return otherwise;
}

double Choices::number(const std::string& name, double otherwise) const
{
    return read(name, otherwise, [](const std::string& text) { return positive(parse_number(text), text); });
}

long long Choices::integer(const std::string& name, long long otherwise) const
{
    return read(name, otherwise, at_least_one);
}

std::vector<double> Choices::numbers(const std::string& name, std::vector<double> otherwise) const
{
    return read(name, std::move(otherwise), [](const std::string& text) {
        std::vector<double> values = parse_list(text);
        for (const double value : values)
            if (!(value > 0)) throw std::invalid_argument(fmt::format("{} in \"{}\" must be > 0", value, text));
        return values;
    });
}

std::vector<int> Choices::integers(const std::string& name, std::vector<int> otherwise) const
{
    return read(name, std::move(otherwise), [](const std::string& text) {
        std::vector<int> values;
        for (const std::string& word : parse_words(text))
            values.push_back(static_cast<int>(parse_integer(word, 1, std::numeric_limits<int>::max())));
        return values;
    });
}

std::vector<double> Choices::numbers_from_zero(const std::string& name, std::vector<double> otherwise) const
{
    return read(name, std::move(otherwise), [](const std::string& text) {
        std::vector<double> values = parse_list(text);
        for (const double value : values)
            if (!(value >= 0)) throw std::invalid_argument(fmt::format("{} in \"{}\" must be >= 0", value, text));
        return values;
    });
}

std::vector<std::string> Choices::methods(const std::string& name, std::vector<std::string> otherwise) const
{
    return words(name, std::move(otherwise), method_names(), "method");
}

std::vector<std::string> Choices::words(const std::string& name, std::vector<std::string> otherwise,
                                        const std::vector<std::string>& known, const std::string& what) const
{
    return read(name, std::move(otherwise), [&](const std::string& text) {
        std::vector<std::string> listed = parse_words(text);
        for (const std::string& word : listed) expect_known_word(word, known, what);
        return listed;
    });
}

std::string Choices::word(const std::string& name, const std::vector<std::string>& known) const
{
    return read(name, std::string(), [&](const std::string& word) {
        if (std::find(known.begin(), known.end(), word) != known.end()) return word;
        throw std::invalid_argument("unknown word \"" + word + "\"" + io::suggestion(word, known, "take"));
    });
}

std::string Choices::text(const std::string& name) const
{
    return read(name, std::string(), [](const std::string& word) { return word; });
}

template <typename T>
T Choices::named(const std::string& name, T otherwise, T (*value_of)(std::string_view)) const
{
    return read(name, otherwise, [value_of](const std::string& text) {
        try {
            return value_of(text);
        } catch (const InputError& error) {
            throw std::invalid_argument(error.what());
        }
    });
}

template <typename T>
std::vector<T> Choices::named_list(const std::string& name, std::vector<T> otherwise,
                                   T (*value_of)(std::string_view)) const
{
    return read(name, std::move(otherwise), [value_of](const std::string& text) {
        std::vector<T> values;
        for (const std::string& word : parse_words(text)) try {
                values.push_back(value_of(word));
            } catch (const InputError& error) {
                throw std::invalid_argument(error.what());
            }
        return values;
    });
}

StepOptions Choices::step(std::uint64_t seed) const
{
    StepOptions step;
    step.order = named("order", step.order, contact_order);
    step.integrator = named("integrator", step.integrator, integrator);
    step.literal = flag("literal");
    step.seed = seed;
    return step;
}

bool Choices::flag(const std::string& name) const
{
    return read(name, false, [](const std::string& text) {
        if (text != "true" && text != "false") throw std::invalid_argument("\"" + text + "\" must be true or false");
        return text == "true";
    });
}

bool Choices::has(const std::string& name) const
{
    return given_.contains(name) || defaults_.contains(name);
}

void Choices::expect_known(const std::vector<std::string>& known) const
{
    std::vector<std::string> problems;
    for (const auto& each : defaults_)
        if (std::find(known.begin(), known.end(), each.first) == known.end())
            problems.push_back(fmt::format("{}/{}: unknown or not yet known option (take {})", place_, each.first,
                                           fmt::join(known, ", ")));
    if (!problems.empty()) throw InputError(problems);
}

RunSettings run_settings(const RunArguments& args, const GlobalArguments& global, const Scene& scene,
                         const std::string& file)
{
    const Choices choices(args.given, scene.run, file + ": /run");
    choices.expect_known({"method",      "dt",        "substeps",     "passes",        "order",
                          "integrator",  "literal",   "most_impacts", "until",         "max_events",
                          "max_seconds", "final",     "kernel",       "certified",     "impact",
                          "guard",       "stiffness", "hertz",        "damping_ratio", "frames"});
    StepOptions step = choices.step(global.seed.value_or(scene.seed));
    step.dt = choices.number("dt", step.dt);
    step.substeps = choices.integers("substeps", {step.substeps}).front();
    step.passes = choices.integers("passes", {step.passes}).front();
    RunSettings settings;
    settings.method = make_method(choices.methods("method", {"event"}).front(), step);
    if (auto* event = std::get_if<EventDriven>(&settings.method)) {
        event->kernel = choices.text("kernel");
        event->certified = choices.flag("certified");
        choose_kernel(scene, event->kernel);  // a wrong name is the user's mistake: say so before anything runs
    }
    if (auto* toi = std::get_if<ImpactSubsteps>(&settings.method))
        toi->most_impacts = choices.integers("most_impacts", {toi->most_impacts}).front();
    if (auto* penalty = std::get_if<Penalty>(&settings.method); penalty && choices.has("stiffness"))
        penalty->stiffness = choices.number("stiffness", 0);
    if (auto* soft = std::get_if<Soft>(&settings.method)) {
        soft->hertz = choices.number("hertz", soft->hertz);
        soft->damping_ratio = choices.number("damping_ratio", soft->damping_ratio);
    }
    settings.always_final = args.always_final || choices.flag("final");
    settings.run.until = choices.number("until", scene.end_time);
    settings.run.max_events = choices.integer("max_events", settings.run.max_events);
    settings.max_seconds = choices.number("max_seconds", settings.max_seconds);
    if (choices.has("frames")) settings.frames = choices.number("frames", 0);
    return settings;
}

CompareSettings compare_settings(const CompareArguments& args, const GlobalArguments& global, const Scene& scene,
                                 const std::string& file)
{
    const Choices choices(args.given, scene.compare, file + ": /compare");
    choices.expect_known({"methods", "dt", "substeps", "passes", "order", "integrator", "literal", "until", "repeats",
                          "tolerance", "max_seconds", "impact", "stiffness", "hertz", "damping_ratio"});
    CompareSettings settings;
    settings.max_seconds = choices.number("max_seconds", settings.max_seconds);
    CompareOptions& options = settings.compare;
    AskedMethods asked =
        asked_methods(choices.words("methods", method_names(), methods_and_peers(), "method"), scene, file);
    options.methods = std::move(asked.methods);
    options.peers = std::move(asked.peers);
    settings.absent = std::move(asked.absent);
    options.dt = choices.numbers("dt", {1.0 / 60, 1.0 / 240, 1.0 / 1000});
    options.substeps = choices.integers("substeps", options.substeps);
    options.passes = choices.integers("passes", options.passes);
    options.orders = choices.named_list("order", options.orders, contact_order);
    options.integrators =
        choices.named_list("integrator", {Integrator::euler, Integrator::parabola}, carom::integrator);
    if (choices.has("impact")) options.impacts = choices.named_list<ImpactOperator>("impact", {}, impact_operator);
    options.step.literal = choices.flag("literal");
    if (choices.has("stiffness")) options.stiffness = choices.number("stiffness", 0);
    options.hertz = choices.number("hertz", options.hertz);
    options.damping_ratio = choices.number("damping_ratio", options.damping_ratio);
    options.step.seed = global.seed.value_or(scene.seed);
    options.until = choices.number("until", scene.end_time);
    options.repeats = static_cast<int>(std::min(choices.integer("repeats", options.repeats), most_repeats));
    options.search_steps = choices.has("tolerance");
    if (options.search_steps) options.tolerance = choices.number("tolerance", 0);
    return settings;
}

}  // namespace carom::cli
