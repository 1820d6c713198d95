/// \file
/// The columns of a comparison's row: the one table from which compare.csv, compare.json, the data of the page, the
/// headings on the terminal and docs/compare.md are made.
#pragma once

#include "core/names.hpp"

#include <carom/study.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace carom::study {

/// Unit of a figure: one of the scene, but for seconds.
enum class ColumnUnit : std::uint8_t { none, time, length, speed, seconds };
inline constexpr std::array<std::string_view, 5> column_unit_names{"", "time", "length", "length/time", "s"};

/// Cell of a row in a column; an empty optional is nothing, and so are numbers that are not finite.
using CompareCell = std::variant<std::string, std::optional<double>, std::optional<std::int64_t>>;

inline CompareCell as_cell(const std::string& text)
{
    return text;
}
inline CompareCell as_cell(const std::optional<std::string>& text)
{
    return text.value_or("");
}
inline CompareCell as_cell(Status status)
{
    return name(status);
}
inline CompareCell as_cell(std::optional<ContactOrder> order)
{
    return order ? std::string(name(*order)) : std::string();
}
inline CompareCell as_cell(std::optional<Integrator> integrator)
{
    return integrator ? std::string(name(*integrator)) : std::string();
}
inline CompareCell as_cell(std::optional<ImpactOperator> impact)
{
    return impact ? std::string(name_of(*impact, impact_operator_names)) : std::string();
}
inline CompareCell as_cell(std::optional<double> value)
{
    return value;
}
inline CompareCell as_cell(double value)
{
    return std::optional(value);
}
inline CompareCell as_cell(std::int64_t value)
{
    return std::optional(value);
}
inline CompareCell as_cell(std::optional<std::int64_t> value)
{
    return value;
}
inline CompareCell as_cell(std::optional<int> value)
{
    return value ? std::optional<std::int64_t>(*value) : std::nullopt;
}

template <auto Member>
CompareCell cell_of(const CompareRow& row)
{
    return as_cell(row.*Member);
}

/// A count of the audit; empty where a row has none.
template <auto Member>
CompareCell audit_cell(const CompareRow& row)
{
    return row.audit ? std::optional((*row.audit).*Member) : std::nullopt;
}

/// A count of impacts; empty for a peer, which shows none.
template <auto Member>
CompareCell impacts_cell(const CompareRow& row)
{
    return row.peer_settings ? std::nullopt : std::optional(row.*Member);
}

struct CompareColumn {
    std::string_view name;     ///< key in files
    std::string_view heading;  ///< on the terminal; empty: not shown there
    ColumnUnit unit;
    std::string_view meaning;
    CompareCell (*cell)(const CompareRow&);
};

/// In the order of compare.csv. Names are stable: files and pages of others read them.
inline constexpr std::array<CompareColumn, 40> compare_columns{{
    {"method", "method", ColumnUnit::none, "How the scene was simulated. \"event\" is exact in time and takes no step.",
     cell_of<&CompareRow::method>},
    {"dt", "dt", ColumnUnit::time, "Length of a time step; none for the event-driven method.",
     cell_of<&CompareRow::dt>},
    {"substeps", "substeps", ColumnUnit::none, "Equal parts into which each step is cut.",
     cell_of<&CompareRow::substeps>},
    {"passes", "passes", ColumnUnit::none,
     "How often the contacts are visited in a substep; none where a method reads no passes.",
     cell_of<&CompareRow::passes>},
    {"order", "order", ColumnUnit::none, "Order in which contacts are visited; none where a method reads no order.",
     cell_of<&CompareRow::order>},
    {"integrator", "integrator", ColumnUnit::none,
     "Motion between contacts: \"euler\" moves by the speed after gravity, \"parabola\" is exact in flight.",
     cell_of<&CompareRow::integrator>},
    {"impact", "impact", ColumnUnit::none, "Operator of the event method for several contacts at once.",
     cell_of<&CompareRow::impact>},
    {"stiffness", "", ColumnUnit::none,
     "Stiffness of the springs of \"penalty\", mass/time^2; none where each contact has its own.",
     cell_of<&CompareRow::stiffness>},
    {"hertz", "", ColumnUnit::none, "Frequency of the springs of \"soft\", 1/time.", cell_of<&CompareRow::hertz>},
    {"damping_ratio", "", ColumnUnit::none, "Damping ratio of the springs of \"soft\".",
     cell_of<&CompareRow::damping_ratio>},
    {"cpu_seconds", "CPU", ColumnUnit::seconds,
     "Processor time of one run up to the end of what is compared, giving its samples: the median of the repeats.",
     cell_of<&CompareRow::cpu_seconds>},
    {"cpu_min", "", ColumnUnit::seconds, "The fastest repeat.", cell_of<&CompareRow::cpu_min>},
    {"cpu_max", "", ColumnUnit::seconds, "The slowest repeat.", cell_of<&CompareRow::cpu_max>},
    {"position_rms", "", ColumnUnit::length,
     "Distance to the reference: root mean square over spheres and sample times.", cell_of<&CompareRow::position_rms>},
    {"position_max", "max error", ColumnUnit::length,
     "Distance to the reference: the greatest over spheres and sample times.", cell_of<&CompareRow::position_max>},
    {"position_final_rms", "", ColumnUnit::length,
     "Distance to the reference at the end: root mean square over spheres.", cell_of<&CompareRow::position_final_rms>},
    {"position_final_max", "at end", ColumnUnit::length,
     "Distance to the reference at the end: the sphere that is worst.", cell_of<&CompareRow::position_final_max>},
    {"velocity_rms", "", ColumnUnit::speed,
     "Difference of velocity to the reference: root mean square over spheres and sample times.",
     cell_of<&CompareRow::velocity_rms>},
    {"energy_error", "energy err", ColumnUnit::none,
     "Greatest difference of energy to the reference at a sample time, divided by the reference's greatest kinetic "
     "energy.",
     cell_of<&CompareRow::energy_error>},
    {"max_penetration", "overlap", ColumnUnit::length,
     "Deepest overlap seen; for discrete methods at the end of a substep, before correction, which a chart over time "
     "does not see.",
     cell_of<&CompareRow::max_penetration>},
    {"overlap_left", "left", ColumnUnit::length, "Deepest overlap at a sample time, after the method's corrections.",
     cell_of<&CompareRow::overlap_left>},
    {"missed_impacts", "run missed", ColumnUnit::none,
     "Impacts of the reference that the method did not find within 3 steps: those that came early or late, and those "
     "that never came. Counted up to the divergence.",
     impacts_cell<&CompareRow::missed_impacts>},
    {"invented_impacts", "run invented", ColumnUnit::none,
     "Impacts of the method that the reference does not have within 3 steps. Counted up to the divergence.",
     impacts_cell<&CompareRow::invented_impacts>},
    {"impacts", "", ColumnUnit::none, "Contacts that got an impulse.", impacts_cell<&CompareRow::impacts>},
    {"audited", "audited", ColumnUnit::none,
     "Impacts that the method was put to one at a time: begun anew from the exact state at a random phase of the step "
     "before each, it takes two steps. Where there are few, each at several phases. For \"event\": impacts of the "
     "reference that its run was held against.",
     audit_cell<&Audit::audited>},
    {"found", "found", ColumnUnit::none,
     "Of those audited, answered in their step, and the velocity after two steps is right to 1 % of what the impact "
     "changed. For \"event\": at the right time, to 1e-9 of the smallest radius at the speed of the scene.",
     audit_cell<&Audit::found>},
    {"late", "late", ColumnUnit::none,
     "Of those audited, answered in the step after. For \"event\": early or late by more than that.",
     audit_cell<&Audit::late>},
    {"missed", "missed", ColumnUnit::none, "Of those audited, not answered within two steps.",
     audit_cell<&Audit::missed>},
    {"wrong", "wrong", ColumnUnit::none, "Of those audited, answered in their step, but with another velocity.",
     audit_cell<&Audit::wrong>},
    {"invented", "invented", ColumnUnit::none,
     "Two steps of bodies that have no impact in them, in which the method answers one all the same; how many were "
     "looked at says compare.json. For \"event\": impacts that the reference does not have.",
     audit_cell<&Audit::invented>},
    {"crowded", "crowded", ColumnUnit::none,
     "Impacts not audited at this step: one of the bodies has another contact within the two steps.",
     audit_cell<&Audit::crowded>},
    {"absorbed", "absorbed", ColumnUnit::none,
     "Impacts of the reference closing slower than v_c that the event method took for rest, neither found nor missed; "
     "its errors say what that costs.",
     cell_of<&CompareRow::absorbed_impacts>},
    {"rest_jitter", "jitter", ColumnUnit::speed, "Root mean square speed of bodies that rest in the reference.",
     cell_of<&CompareRow::rest_jitter>},
    {"divergence_time", "diverges", ColumnUnit::time,
     "First sample at which some sphere is further than a hundredth of the smallest radius from the reference; empty "
     "if never.",
     cell_of<&CompareRow::divergence_time>},
    {"reference_bound", "", ColumnUnit::length,
     "How far the reference itself may be off. Errors below it are not resolved.",
     cell_of<&CompareRow::reference_bound>},
    {"steps", "", ColumnUnit::none, "Time steps taken, substeps counted.", cell_of<&CompareRow::steps>},
    {"root_solves", "", ColumnUnit::none,
     "Contact times computed by solving for a root: work that does not depend on the machine.",
     cell_of<&CompareRow::root_solves>},
    {"pair_tests", "", ColumnUnit::none, "Pairs of bodies examined: work that does not depend on the machine.",
     cell_of<&CompareRow::pair_tests>},
    {"status", "status", ColumnUnit::none, "How the run ended; \"reached_end\" is the good one.",
     cell_of<&CompareRow::status>},
    {"peer_settings", "", ColumnUnit::none,
     "Name, version and settings of an engine that is none of carom's. Its impacts are not counted, and its time is "
     "that "
     "of its own steps, as it says itself, without reading and writing.",
     cell_of<&CompareRow::peer_settings>},
}};

/// A cell as a value of a JSON library; nothing is null.
template <class Json>
Json cell_value(const CompareCell& cell)
{
    if (const auto* text = std::get_if<std::string>(&cell)) return *text;
    if (const auto* number = std::get_if<std::optional<double>>(&cell)) return *number ? Json(**number) : Json(nullptr);
    const auto& whole = std::get<std::optional<std::int64_t>>(cell);
    return whole ? Json(*whole) : Json(nullptr);
}

/// \pre a column has that name
constexpr const CompareColumn& compare_column(std::string_view name)
{
    std::size_t k = 0;
    while (compare_columns[k].name != name) ++k;
    return compare_columns[k];
}

}  // namespace carom::study
