/// \file
/// The discrete methods behind one name each, for tests that go over all of them.
#pragma once

#include "stepping/stepping.hpp"

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace carom::test {

inline StepOptions steps(double dt, int substeps = 1, int passes = 1)
{
    StepOptions options;
    options.dt = dt;
    options.substeps = substeps;
    options.passes = passes;
    return options;
}

inline RunOptions until(double time)
{
    RunOptions options;
    options.until = time;
    return options;
}

/// Any discrete method. \pre not EventDriven.
inline Outcome run_discrete(const Scene& scene, const Method& method, const RunOptions& options,
                            const Observer& observer = {})
{
    return std::visit(
        [&](const auto& m) {
            if constexpr (std::is_same_v<std::decay_t<decltype(m)>, EventDriven>) {
                return Outcome{};
            } else {
                return run_stepping(scene, m, options, observer);
            }
        },
        method);
}

inline std::vector<Method> all_discrete(const StepOptions& options)
{
    std::vector<Method> methods;
    for (const std::string& name : method_names())
        if (const Method method = make_method(name, options); step_options(method)) methods.push_back(method);
    return methods;
}

/// All but naive.
inline std::vector<Method> all_serious(const StepOptions& options)
{
    std::vector<Method> methods;
    for (const Method& method : all_discrete(options))
        if (!std::holds_alternative<Naive>(method)) methods.push_back(method);
    return methods;
}

/// Those of them whose contacts are over within a step. The springs of penalty take ten.
inline std::vector<Method> all_impulsive(const StepOptions& options)
{
    std::vector<Method> methods;
    for (const Method& method : all_serious(options))
        if (!std::holds_alternative<Penalty>(method)) methods.push_back(method);
    return methods;
}

/// Whether it looks along the paths of a step, so that nothing passes through anything thin.
inline bool looks_ahead(const Method& method)
{
    return std::holds_alternative<ImpactSubsteps>(method) || std::holds_alternative<Speculative>(method) ||
           std::holds_alternative<Soft>(method);
}

}  // namespace carom::test
