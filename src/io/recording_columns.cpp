/// \file
/// Events and flights as columns, and back. The order of `visit` is the order in the blob.
#include "io/recording_format.hpp"

#include <carom/error.hpp>

#include <algorithm>

namespace carom::io {

namespace {

constexpr int spatial = 3;

/// The numbers of a series in their order.
std::array<double, 10> numbers_of(const SeriesRecord& s)
{
    return {s.normal_speed, s.gravity,      s.restitution,      s.tangential,       s.velocity.x(),
            s.velocity.y(), s.velocity.z(), s.acceleration.x(), s.acceleration.y(), s.acceleration.z()};
}

SeriesRecord series_of(const std::array<double, 10>& n)
{
    return {n[0], n[1], n[2], n[3], Vec3(n[4], n[5], n[6]), Vec3(n[7], n[8], n[9])};
}

struct Pack {
    ColumnWriter& out;
    template <class T>
    void values(const std::vector<T>& column) const
    {
        out.add(column);
    }
    void differences(const std::vector<std::int64_t>& column) const { out.add_differences(column); }
};

struct Unpack {
    ColumnReader& in;
    template <class T>
    void values(std::vector<T>& column) const
    {
        in.read(column);
    }
    void differences(std::vector<std::int64_t>& column) const { in.read_differences(column); }
};

struct Clear {
    template <class T>
    void values(std::vector<T>& column) const
    {
        column.clear();
    }
    void differences(std::vector<std::int64_t>& column) const { column.clear(); }
};

template <class Columns>
Bytes pack_columns(const Columns& columns)
{
    ColumnWriter out;
    Columns::visit(columns, Pack{out});
    return out.bytes();
}

template <class Columns>
void unpack_columns(Columns& columns, std::span<const unsigned char> data, std::size_t rows, const std::string& file)
{
    ColumnReader in(data, rows, file);
    Columns::visit(columns, Unpack{in});
    in.finish();
}

}  // namespace

template <class Self, class Visit>
void EventColumns::visit(Self& self, const Visit& visit)
{
    visit.values(self.kind);
    visit.values(self.a);
    visit.values(self.b);
    visit.differences(self.epoch);
    visit.values(self.offset);
    for (auto& column : self.normal) visit.values(column);
    for (auto& column : self.impulse) visit.values(column);
}

template <class Self, class Visit>
void FlightColumns::visit(Self& self, const Visit& visit)
{
    visit.values(self.body);
    visit.differences(self.after);
    visit.differences(self.epoch);
    visit.values(self.offset);
    for (auto& column : self.cell) visit.values(column);
    for (auto& column : self.local) visit.values(column);
    for (auto& column : self.local_low) visit.values(column);
    for (auto& column : self.velocity) visit.values(column);
    for (auto& column : self.velocity_low) visit.values(column);
    visit.values(self.acceleration);
    visit.values(self.support);
    for (auto& column : self.own) visit.values(column);
    visit.values(self.mode);
    visit.values(self.guarded);
    for (auto& column : self.series) visit.values(column);
}

void EventColumns::add(const Event& event)
{
    kind.push_back(static_cast<std::uint8_t>(event.kind));
    a.push_back(event.a);
    b.push_back(event.b);
    epoch.push_back(event.at.epoch);
    offset.push_back(event.at.offset);
    for (int k = 0; k < spatial; ++k) {
        normal[k].push_back(event.normal[k]);
        impulse[k].push_back(event.impulse[k]);
    }
}

Event EventColumns::row(std::size_t i) const
{
    Event event{static_cast<EventKind>(kind[i]), {epoch[i], offset[i]}, 0, a[i], b[i], {}, {}};
    for (int k = 0; k < spatial; ++k) {
        event.normal[k] = normal[k][i];
        event.impulse[k] = impulse[k][i];
    }
    return event;
}

void EventColumns::clear()
{
    visit(*this, Clear{});
}

void FlightColumns::add(const FlightRecord& flight, std::int64_t events_before)
{
    body.push_back(flight.body);
    after.push_back(events_before);
    epoch.push_back(flight.start.epoch);
    offset.push_back(flight.start.offset);
    for (std::size_t k = 0; k < spatial; ++k) {
        cell[k].push_back(flight.cell[k]);
        local[k].push_back(flight.local[k]);
        local_low[k].push_back(flight.local_low[k]);
        velocity[k].push_back(flight.velocity[k]);
        velocity_low[k].push_back(flight.velocity_low[k]);
        own[k].push_back(flight.own[k]);
    }
    acceleration.push_back(flight.acceleration);
    support.push_back(flight.support);
    mode.push_back(static_cast<std::uint8_t>(flight.mode));
    guarded.push_back(flight.guarded);
    const auto numbers = flight.series ? numbers_of(*flight.series) : std::array<double, 10>{};
    for (std::size_t k = 0; k < numbers.size(); ++k) series[k].push_back(numbers[k]);
}

FlightRecord FlightColumns::row(std::size_t i) const
{
    FlightRecord flight;
    flight.body = body[i];
    flight.start = {epoch[i], offset[i]};
    for (std::size_t k = 0; k < spatial; ++k) {
        flight.cell[k] = cell[k][i];
        flight.local[k] = local[k][i];
        flight.local_low[k] = local_low[k][i];
        flight.velocity[k] = velocity[k][i];
        flight.velocity_low[k] = velocity_low[k][i];
        flight.own[k] = own[k][i];
    }
    flight.acceleration = acceleration[i];
    flight.support = support[i];
    flight.mode = static_cast<Mode>(mode[i]);
    flight.guarded = guarded[i] != 0;
    if (flight.mode != Mode::series) return flight;
    std::array<double, 10> numbers{};
    for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = series[k][i];
    flight.series = series_of(numbers);
    return flight;
}

void FlightColumns::clear()
{
    visit(*this, Clear{});
}

Bytes packed(const EventColumns& columns)
{
    return pack_columns(columns);
}

Bytes packed(const FlightColumns& columns)
{
    return pack_columns(columns);
}

void unpack(EventColumns& columns, std::span<const unsigned char> data, std::size_t rows, const std::string& file)
{
    unpack_columns(columns, data, rows, file);
    for (const std::uint8_t kind : columns.kind)
        if (kind < static_cast<int>(EventKind::impact) || kind > static_cast<int>(EventKind::settle))
            throw InputError({file + ": damaged: an event of unknown kind"});
}

void unpack(FlightColumns& columns, std::span<const unsigned char> data, std::size_t rows, const std::string& file)
{
    unpack_columns(columns, data, rows, file);
    for (const std::uint8_t mode : columns.mode)
        if (mode > static_cast<int>(Mode::fixed)) throw InputError({file + ": damaged: a flight of unknown mode"});
    for (const std::uint8_t guarded : columns.guarded)
        if (guarded > 1) throw InputError({file + ": damaged: a flight that is neither guarded nor not"});
}

}  // namespace carom::io
