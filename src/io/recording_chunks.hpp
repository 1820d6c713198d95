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
    /// Content of the next row of chunks; valid until the next one.
    struct Chunk {
        std::span<const unsigned char> data;
        std::size_t count = 0;
    };
    Chunk read_chunk(const char* kind);
    void check_end();

    const std::string& file_;
    const RecordingHead& head_;
    Statement chunks_;
    bool done_ = false;
    std::uint32_t checksum_;
    std::int64_t next_chunk_ = 0, events_before_ = 0, flights_before_ = 0;
    std::vector<Event> events_;
    std::vector<FlightRecord> flights_;
    std::vector<std::int64_t> after_;     ///< by flight: how many events came before
    std::size_t event_ = 0, flight_ = 0;  ///< next to be given out
};

}  // namespace carom::io
