/// \file
/// The columns of tunnel.csv and critical.csv: the tables from which files, pages and docs/tunnel.md are made.
#pragma once

#include "study/compare_columns.hpp"
#include "study/share.hpp"
#include "tunnel/study.hpp"

namespace carom::tunnel {

template <class Line>
struct Column {
    std::string_view name;  ///< key in files; stable
    study::ColumnUnit unit;
    std::string_view meaning;
    study::CompareCell (*cell)(const Line&);
};

inline study::CompareCell target_cell(const Cell& cell)
{
    return std::string(name_of(cell.target, target_names));
}
/// None for a row without a throw.
inline std::optional<study::Share> share_of(const Row& row)
{
    if (row.trials == 0) return {};
    return study::wilson_share(row.tunnelled, row.trials);
}
template <auto Member>
study::CompareCell share_cell(const Row& row)
{
    const auto share = share_of(row);
    return share ? std::optional((*share).*Member) : std::nullopt;
}

inline constexpr std::array<Column<Row>, 19> row_columns{{
    {"method", study::ColumnUnit::none, "Who was thrown with.", [](const Row& r) { return study::as_cell(r.method); }},
    {"dt", study::ColumnUnit::time,
     "Length of a step; for `event` the time within which throws begin before the contact.",
     [](const Row& r) { return study::as_cell(r.cell.dt); }},
    {"speed", study::ColumnUnit::speed, "Speed of the ball.",
     [](const Row& r) { return study::as_cell(r.cell.speed); }},
    {"radius", study::ColumnUnit::length, "Radius of the ball.",
     [](const Row& r) { return study::as_cell(r.cell.radius); }},
    {"thickness", study::ColumnUnit::length, "Thickness of a plate, diameter of a sphere; none for a wall.",
     [](const Row& r) { return study::as_cell(r.cell.thickness); }},
    {"trials", study::ColumnUnit::none, "Throws.", [](const Row& r) { return study::as_cell(r.trials); }},
    {"tunnelled", study::ColumnUnit::none, "Of them, not answered within two steps, or behind the plate at last.",
     [](const Row& r) { return study::as_cell(r.tunnelled); }},
    {"wrong", study::ColumnUnit::none,
     "Of them, answered, but in the step after the contact, or with a velocity after two steps that is off by more "
     "than 1 % "
     "of what the contact changes; of `event`: time or velocity off by more than 1e-9.",
     [](const Row& r) { return study::as_cell(r.wrong); }},
    {"worst_error", study::ColumnUnit::length,
     "Largest distance from the true place two steps after the begin, of throws that did not tunnel.",
     [](const Row& r) { return study::as_cell(r.worst_error); }},
    {"target", study::ColumnUnit::none, "What was thrown at: `plate`, `sphere`, `wall`.",
     [](const Row& r) { return target_cell(r.cell); }},
    {"integrator", study::ColumnUnit::none, "Motion between contacts; none for `event` and for collision libraries.",
     [](const Row& r) { return study::as_cell(r.integrator); }},
    {"variant", study::ColumnUnit::none, "Motion and solver of a collision library.",
     [](const Row& r) { return study::as_cell(r.variant); }},
    {"number", study::ColumnUnit::none, "v dt / (radius + thickness/2), on which alone the share depends.",
     [](const Row& r) { return study::as_cell(r.cell.number()); }},
    {"share", study::ColumnUnit::none, "tunnelled / trials.", share_cell<&study::Share::value>},
    {"share_low", study::ColumnUnit::none, "Lower end of its interval of 95 % (Wilson).",
     share_cell<&study::Share::low>},
    {"share_high", study::ColumnUnit::none, "Upper end of it.", share_cell<&study::Share::high>},
    {"law", study::ColumnUnit::none,
     "Share by the law; none for methods without one, and in scenes with gravity or drag, or where the other body "
     "moves.",
     [](const Row& r) { return study::as_cell(r.law); }},
    {"example_phase", study::ColumnUnit::none,
     "Part of a step from the begin to the contact of a throw that shows the row: the first that tunnelled, else was "
     "wrong.",
     [](const Row& r) { return study::as_cell(r.example.phase); }},
    {"example_offset", study::ColumnUnit::none,
     "Offset of its path from a sphere's middle, in radius + sphere's radius.",
     [](const Row& r) { return study::as_cell(r.example.offset); }},
}};

inline constexpr std::array<Column<Critical>, 11> critical_columns{{
    {"method", study::ColumnUnit::none, "Who was thrown with.",
     [](const Critical& c) { return study::as_cell(c.method); }},
    {"dt", study::ColumnUnit::time, "Length of a step.", [](const Critical& c) { return study::as_cell(c.cell.dt); }},
    {"radius", study::ColumnUnit::length, "Radius of the ball.",
     [](const Critical& c) { return study::as_cell(c.cell.radius); }},
    {"thickness", study::ColumnUnit::length, "Thickness of the plate, diameter of the sphere.",
     [](const Critical& c) { return study::as_cell(c.cell.thickness); }},
    {"target", study::ColumnUnit::none, "`plate` or `sphere`.", [](const Critical& c) { return target_cell(c.cell); }},
    {"offset", study::ColumnUnit::none, "Offset of the path from a sphere's middle, in radius + sphere's radius.",
     [](const Critical& c) { return study::as_cell(c.offset); }},
    {"critical_speed", study::ColumnUnit::speed,
     "Lowest speed that tunnels, within 1 %; with `below` one that tunnels still; none if none does.",
     [](const Critical& c) {
         return study::as_cell(c.speed.end == CriticalSpeed::End::never ? std::nullopt : std::optional(c.speed.speed));
     }},
    {"law", study::ColumnUnit::speed, "By the law; none for methods that never tunnel or have no law.",
     [](const Critical& c) { return study::as_cell(c.law); }},
    {"integrator", study::ColumnUnit::none, "As in tunnel.csv.",
     [](const Critical& c) { return study::as_cell(c.integrator); }},
    {"variant", study::ColumnUnit::none, "As in tunnel.csv.",
     [](const Critical& c) { return study::as_cell(c.variant); }},
    {"end", study::ColumnUnit::none,
     "`found`; `below`: it tunnels at every speed looked at, down to that one; `never`: at none, up to v dt = 1e6 "
     "chords, "
     "or in a scene up to where other contacts come within two steps.",
     [](const Critical& c) { return study::CompareCell(std::string(name_of(c.speed.end, critical_end_names))); }},
}};

}  // namespace carom::tunnel
