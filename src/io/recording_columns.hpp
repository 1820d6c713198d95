/// \file
/// The columns of a recording, each described once: writer, reader and docs/recording.md go by these tables.
#pragma once

#include "io/recorded_columns.hpp"

#include <carom/verify.hpp>

namespace carom::io {

/// Events, by Event.
// clang-format off
inline constexpr std::tuple event_columns{
    column("kind", [](auto& e) -> auto& { return e.kind; }).within(1, 5, "an event of unknown kind"),
    column("a", [](auto& e) -> auto& { return e.a; }),
    column("b", [](auto& e) -> auto& { return e.b; }),
    column("epoch", [](auto& e) -> auto& { return e.at.epoch; }).by_differences(),
    column("offset", [](auto& e) -> auto& { return e.at.offset; }),
    lanes<3>("normal", [](auto& e, std::size_t k) -> auto& { return e.normal[static_cast<int>(k)]; }),
    lanes<3>("impulse", [](auto& e, std::size_t k) -> auto& { return e.impulse[static_cast<int>(k)]; })};
// clang-format on

struct FlightRow {
    FlightRecord flight;
    std::int64_t after = 0;  ///< how many events came before
};

/// The numbers of a series in their order.
template <class Series>
auto& series_number(Series& s, std::size_t k)
{
    constexpr std::array scalars{&SeriesRecord::normal_speed, &SeriesRecord::gravity, &SeriesRecord::restitution,
                                 &SeriesRecord::tangential};
    if (k < scalars.size()) return s.*scalars[k];
    const auto i = static_cast<int>(k - scalars.size());
    return i < 3 ? s.velocity[i] : s.acceleration[i - 3];
}

/// Zeros without a series, which cost nothing.
struct SeriesNumbers {
    double operator()(const FlightRow& row, std::size_t k) const
    {
        return row.flight.series ? series_number(*row.flight.series, k) : 0;
    }
    double& operator()(FlightRow& row, std::size_t k) const
    {
        if (!row.flight.series) row.flight.series.emplace();
        return series_number(*row.flight.series, k);
    }
};

/// Flights, by FlightRow.
// clang-format off
inline constexpr std::tuple flight_columns{
    column("body", [](auto& f) -> auto& { return f.flight.body; }),
    column("after", [](auto& f) -> auto& { return f.after; }).by_differences(),
    column("epoch", [](auto& f) -> auto& { return f.flight.start.epoch; }).by_differences(),
    column("offset", [](auto& f) -> auto& { return f.flight.start.offset; }),
    lanes<3>("cell", [](auto& f, std::size_t k) -> auto& { return f.flight.cell[k]; }),
    lanes<3>("local", [](auto& f, std::size_t k) -> auto& { return f.flight.local[k]; }),
    lanes<3>("local_low", [](auto& f, std::size_t k) -> auto& { return f.flight.local_low[k]; }),
    lanes<3>("velocity", [](auto& f, std::size_t k) -> auto& { return f.flight.velocity[k]; }),
    lanes<3>("velocity_low", [](auto& f, std::size_t k) -> auto& { return f.flight.velocity_low[k]; }),
    column("acceleration", [](auto& f) -> auto& { return f.flight.acceleration; }),
    column("support", [](auto& f) -> auto& { return f.flight.support; }),
    lanes<3>("own", [](auto& f, std::size_t k) -> auto& { return f.flight.own[k]; }),
    column("mode", [](auto& f) -> auto& { return f.flight.mode; }).within(0, 5, "a flight of unknown mode"),
    column("guarded", [](auto& f) -> auto& { return f.flight.guarded; })
        .within(0, 1, "a flight that is neither guarded nor not"),
    lanes<10>("series", SeriesNumbers{})};
// clang-format on

struct SphereRow {
    RecordedSphere sphere;
    RecordedStart start;
};

/// Spheres, by SphereRow.
// clang-format off
inline constexpr std::tuple sphere_columns{
    column("radius", [](auto& s) -> auto& { return s.sphere.radius; }),
    column("mass", [](auto& s) -> auto& { return s.sphere.mass; }),
    lanes<3>("position", [](auto& s, std::size_t k) -> auto& { return s.start.position[static_cast<int>(k)]; }),
    lanes<3>("velocity", [](auto& s, std::size_t k) -> auto& { return s.start.velocity[static_cast<int>(k)]; }),
    column("material", [](auto& s) -> auto& { return s.sphere.material; }),
    column("fixed", [](auto& s) -> auto& { return s.sphere.fixed; })};
// clang-format on

/// Planes, by Plane.
// clang-format off
inline constexpr std::tuple plane_columns{
    lanes<3>("normal", [](auto& p, std::size_t k) -> auto& { return p.normal[static_cast<int>(k)]; }),
    column("offset", [](auto& p) -> auto& { return p.offset; }),
    column("thickness", [](auto& p) -> auto& { return p.thickness; }),
    column("material", [](auto& p) -> auto& { return p.material; })};
// clang-format on

/// Materials, by Material.
// clang-format off
inline constexpr std::tuple material_columns{
    column("restitution", [](auto& m) -> auto& { return m.restitution; }),
    column("tangential", [](auto& m) -> auto& { return m.tangential; })};
// clang-format on

/// Contact rules, by ContactRule.
// clang-format off
inline constexpr std::tuple contact_columns{
    column("a", [](auto& c) -> auto& { return c.a; }),
    column("b", [](auto& c) -> auto& { return c.b; }),
    column("restitution", [](auto& c) -> auto& { return c.restitution; }),
    column("tangential", [](auto& c) -> auto& { return c.tangential; }),
    column("attenuation", [](auto& c) -> auto& { return c.attenuation; })};
// clang-format on

Bytes packed(std::span<const Event> events);
Bytes packed(std::span<const FlightRow> flights);
/// \throws InputError if the bytes are no such columns, or a value has no meaning
std::vector<Event> unpacked_events(std::span<const unsigned char> data, std::size_t count, const std::string& file);
std::vector<FlightRow> unpacked_flights(std::span<const unsigned char> data, std::size_t count,
                                        const std::string& file);

}  // namespace carom::io
