/// \file
/// The words that options, results and files use for the enumerations of the public headers.
#include "core/names.hpp"

#include <carom/error.hpp>
#include <carom/simulate.hpp>

#include <type_traits>
#include <utility>

namespace carom {

// Each name is a literal, which ends in a null character.
const char* name(Mode mode)
{
    return name_of(mode, mode_names).data();
}

const char* name(EventKind kind)
{
    return name_of(kind, event_kind_names, first_event_kind).data();
}

const char* name(Status status)
{
    return name_of(status, status_names).data();
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

/// The value called `wanted`. \param what the names are of, for messages
template <class Enum, std::size_t N>
Enum known_value(std::string_view what, std::string_view wanted, const std::array<std::string_view, N>& names)
{
    if (const auto value = value_named<Enum>(wanted, names)) return *value;
    std::string known;
    for (const std::string_view name : names) known += (known.empty() ? "" : ", ") + std::string(name);
    throw InputError({"unknown " + std::string(what) + " \"" + std::string(wanted) + "\" (take " + known + ")"});
}

}  // namespace

ContactOrder contact_order(std::string_view wanted)
{
    return known_value<ContactOrder>("order", wanted, contact_order_names);
}

std::string_view name(ContactOrder order)
{
    return name_of(order, contact_order_names);
}

Integrator integrator(std::string_view wanted)
{
    return known_value<Integrator>("integrator", wanted, integrator_names);
}

std::string_view name(Integrator integrator)
{
    return name_of(integrator, integrator_names);
}

std::vector<double> sample_grid(double until, std::size_t n)
{
    std::vector<double> times(n + 1);
    for (std::size_t k = 0; k <= n; ++k)
        times[k] = k == n ? until : until * static_cast<double>(k) / static_cast<double>(n);
    return times;
}

}  // namespace carom
