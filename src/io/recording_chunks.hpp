/// \file
/// The chunks of a recording, read in pairs: events, and the flights that belong to them.
#pragma once

#include "io/recording_head.hpp"

namespace carom::io {

class ChunkReader {
public:
    /// \param head of the same file, whose checksum is carried on
    ChunkReader(Database& database, const RecordingHead& head);

    /// The next instant; valid until the next call. False at the end. \throws InputError: the file is damaged
    bool next(Instant& instant);

private:
    bool read_pair();
    template <class Columns>
    void read_chunk(const char* kind, Columns& columns);
    void check_end();

    const std::string& file_;
    const RecordingHead& head_;
    Statement chunks_;
    bool done_ = false;
    std::uint32_t checksum_;
    std::int64_t next_chunk_ = 0, events_before_ = 0, flights_before_ = 0;
    EventColumns event_columns_;
    FlightColumns flight_columns_;
    std::vector<Event> events_;
    std::vector<FlightRecord> flights_;
    std::size_t event_ = 0, flight_ = 0;  ///< next to be given out
};

}  // namespace carom::io
