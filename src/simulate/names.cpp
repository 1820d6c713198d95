/// \file
/// The words that options, results and files use for the enumerations of the public headers.
#include <carom/error.hpp>
#include <carom/simulate.hpp>

#include <array>
#include <type_traits>
#include <utility>

namespace carom {

const char* name(Mode mode)
{
    switch (mode) {
        case Mode::flying:
            return "flying";
        case Mode::series:
            return "series";
        case Mode::sliding:
            return "sliding";
        case Mode::resting:
            return "resting";
        case Mode::numeric:
            return "numeric";
        case Mode::fixed:
            return "fixed";
    }
    return "?";
}

const char* name(EventKind kind)
{
    switch (kind) {
        case EventKind::impact:
            return "impact";
        case EventKind::rest:
            return "rest";
        case EventKind::release:
            return "release";
        case EventKind::guard:
            return "guard";
        case EventKind::settle:
            return "settle";
    }
    return "?";
}

const char* name(Status status)
{
    switch (status) {
        case Status::reached_end:
            return "reached_end";
        case Status::event_limit:
            return "event_limit";
        case Status::time_limit:
            return "time_limit";
        case Status::zeno:
            return "zeno";
        case Status::unresolved:
            return "unresolved";
        case Status::interrupted:
            return "interrupted";
    }
    return "?";
}

namespace {

template <std::size_t... I>
std::vector<std::string> names_of_alternatives(std::index_sequence<I...>)
{
    return {std::string(std::variant_alternative_t<I, Method>::method_name)...};
}

/// The I-th alternative or one after it.
template <std::size_t I>
Method make_alternative(std::string_view wanted, const StepOptions& options)
{
    if constexpr (I < std::variant_size_v<Method>) {
        using Alternative = std::variant_alternative_t<I, Method>;
        if (wanted != Alternative::method_name) return make_alternative<I + 1>(wanted, options);
        if constexpr (std::is_base_of_v<StepOptions, Alternative>)
            return Alternative{options};
        else
            return Alternative{};
    } else {
        std::string known;
        for (const std::string& name : method_names()) known += (known.empty() ? "" : ", ") + name;
        throw InputError({"unknown method \"" + std::string(wanted) + "\" (take " + known + ")"});
    }
}

}  // namespace

const std::vector<std::string>& method_names()
{
    static const std::vector<std::string> names =
        names_of_alternatives(std::make_index_sequence<std::variant_size_v<Method>>());
    return names;
}

std::string_view name(const Method& method)
{
    return std::visit([](const auto& m) { return std::decay_t<decltype(m)>::method_name; }, method);
}

Method make_method(std::string_view wanted, const StepOptions& options)
{
    return make_alternative<0>(wanted, options);
}

const StepOptions* step_options(const Method& method)
{
    return std::visit(
        [](const auto& m) -> const StepOptions* {
            if constexpr (std::is_base_of_v<StepOptions, std::decay_t<decltype(m)>>) return &m;
            return nullptr;
        },
        method);
}

namespace {
constexpr std::array<std::string_view, 4> order_names{"index", "reverse", "random", "deepest"};
}

ContactOrder contact_order(std::string_view wanted)
{
    for (std::size_t i = 0; i < order_names.size(); ++i)
        if (order_names[i] == wanted) return static_cast<ContactOrder>(i);
    throw InputError({"unknown order \"" + std::string(wanted) + "\" (take index, reverse, random or deepest)"});
}

std::string_view name(ContactOrder order)
{
    return order_names[static_cast<std::size_t>(order)];
}

std::vector<double> sample_grid(double until, std::size_t n)
{
    std::vector<double> times(n + 1);
    for (std::size_t k = 0; k <= n; ++k)
        times[k] = k == n ? until : until * static_cast<double>(k) / static_cast<double>(n);
    return times;
}

}  // namespace carom
