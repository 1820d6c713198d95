/// \file
/// The response of a scene beyond the law of a single impact: several contacts at once, coming to rest, and the guard
/// against impacts that accumulate. Laws and thresholds: docs/impacts.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace carom {

/// Operators that resolve the impacts of several contacts at one instant together.
enum class ImpactOperator : std::uint8_t {
    reflections,  ///< generalized reflections (Smith et al. 2012), with a test for jams; any mix of e
    sequential,   ///< the pair law again and again, in the order of the contacts (Gauss-Seidel)
    lcp,          ///< one linear complementarity problem, see LcpOptions
    shock,        ///< from the ground up, lower bodies infinitely heavy (Guendelman et al. 2003)
    jacobi        ///< the pair law of all contacts at once, again and again; for teaching
};
inline constexpr std::array<std::string_view, 5> impact_operator_names{"reflections", "sequential", "lcp", "shock",
                                                                       "jacobi"};

enum class LcpLaw : std::uint8_t {
    newton,  ///< each velocity after is at least -e times the one before
    poisson  ///< compression first, then e times its impulses are given back
};
inline constexpr std::array<std::string_view, 2> lcp_law_names{"newton", "poisson"};
enum class LcpSolver : std::uint8_t { exact, gauss_seidel };
inline constexpr std::array<std::string_view, 2> lcp_solver_names{"exact", "gauss_seidel"};

struct LcpOptions {
    LcpLaw law = LcpLaw::newton;
    LcpSolver solver = LcpSolver::exact;
    int sweeps = 100;  ///< >= 1, of Gauss-Seidel
};

/// Course of a run in which the operator meets its bound.
enum class OnCap : std::uint8_t {
    stop,   ///< it ends with Status::unresolved
    accept  ///< these contacts are inelastic, counted, and their energy is named
};
inline constexpr std::array<std::string_view, 2> on_cap_names{"stop", "accept"};

struct ImpactOptions {
    ImpactOperator impact_operator = ImpactOperator::reflections;
    OnCap on_cap = OnCap::accept;
    /// Gap >= 0 [smaller radius] up to which another contact belongs to the instant at which one closes. Unset: 1e-12.
    /// In certified runs the contacts must also close at the same time, as far as double-double can tell.
    std::optional<double> tie;
    LcpOptions lcp;
};

enum class RestPolicy : std::uint8_t {
    contact,  ///< bounces are summed, contacts persist
    micro,    ///< a train of bounces of a smallest speed (Hahn 1988)
    none      ///< purely event-driven: a run ends where impacts accumulate, with Status::zeno
};
inline constexpr std::array<std::string_view, 3> rest_policy_names{"contact", "micro", "none"};

/// Options of coming to rest. Unset values take the defaults of `rest_thresholds`.
struct RestOptions {
    RestPolicy policy = RestPolicy::contact;
    std::optional<double> closing_speed;  ///< v_c >= 0 [length/time]
    std::optional<double> window;         ///< tau_p >= 0 [time]
    std::optional<double> numeric_step;   ///< h > 0 [time]
    std::optional<double> gap_tolerance;  ///< g_tol >= 0 [length]
    double series_below = 1e-3;  ///< >= 0; bounces lower than this fraction of the radius are summed in closed form
};

/// Discrete method that takes a jammed component over for one window.
enum class GuardFallback : std::uint8_t {
    moreau,
    velocity,
    pbd,
    windows  ///< of heaps, until they rest (docs/windows.md); what is no heap as moreau
};
inline constexpr std::array<std::string_view, 4> guard_fallback_names{"moreau", "velocity", "pbd", "windows"};

/// Options of the guard: a discrete method takes over connected bodies whose impacts, some of them inelastic,
/// accumulate.
struct GuardOptions {
    bool on = true;                ///< off: such a run ends with Status::unresolved
    int impacts = 100;             ///< B >= 1: more than B n impacts of n connected bodies within a window are too many
    std::optional<double> window;  ///< > 0 [time]; unset: the numeric step h
    GuardFallback fallback = GuardFallback::moreau;
};

}  // namespace carom
