#include "io/recording_columns.hpp"

namespace carom::io {

Bytes packed(std::span<const Event> events)
{
    return pack(event_columns, events);
}

Bytes packed(std::span<const FlightRow> flights)
{
    return pack(flight_columns, flights);
}

std::vector<Event> unpacked_events(std::span<const unsigned char> data, std::size_t count, const std::string& file)
{
    return unpack<Event>(event_columns, data, count, file);
}

std::vector<FlightRow> unpacked_flights(std::span<const unsigned char> data, std::size_t count, const std::string& file)
{
    std::vector<FlightRow> rows = unpack<FlightRow>(flight_columns, data, count, file);
    for (FlightRow& row : rows)
        if (row.flight.mode != Mode::series) row.flight.series.reset();
    return rows;
}

}  // namespace carom::io
