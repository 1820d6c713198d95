/// \file
/// What a recording looks like inside, shared by writer and reader; docs/recording.md tells it to others.
#pragma once

#include "io/columns.hpp"
#include "io/limits.hpp"

#include <carom/verify.hpp>

#include <map>
#include <string>
#include <vector>

namespace carom::io {

inline constexpr std::int64_t recording_application_id = 0x6361726f;  ///< "caro"
inline constexpr std::int64_t recording_version = 2;
inline constexpr const char* recording_format = "carom-recording/2";

/// The statements that make the tables. The reader compares them letter by letter.
const std::vector<std::string>& recording_tables();

using Meta = std::map<std::string, std::string>;
/// Keys of the table meta that are there from the beginning, and those that the end of a run adds.
const std::vector<std::string>& head_keys();
const std::vector<std::string>& end_keys();

struct BodiesRow {
    std::string kind;
    std::int64_t count = 0;
    Bytes data;
};

struct FrameRow {
    double epoch_length = 1, cell_size = 1;
    Bytes gravity, accelerations;
    double closing_speed = 0, window = 0;  ///< RecordedRun
};

/// CRC of everything that is written before the first chunk.
std::uint32_t head_checksum(const Meta& meta, const Bytes& scene, const FrameRow& frame,
                            const std::vector<BodiesRow>& bodies);
/// CRC of the rows that the end adds, carried on from the last chunk's.
std::uint32_t end_checksum(const Meta& meta, std::uint32_t before);

struct ChunkRow {
    std::int64_t seq = 0;
    std::string kind;  ///< "events" for even seq, "flights" for odd
    std::int64_t count = 0;
    EpochTime first, last;                           ///< times of the first and last row; 0 for none
    std::int64_t lowest_body = 0, highest_body = 0;  ///< named first in the rows; 0 for none
};
/// CRC of a chunk, carried on from the one before: a chunk that is missing, or not in its place, shows.
std::uint32_t chunk_checksum(const ChunkRow& row, std::span<const unsigned char> data, std::uint32_t before);

/// Rows of a chunk as columns.
struct EventColumns {
    std::vector<std::uint8_t> kind;
    std::vector<std::int32_t> a, b;
    std::vector<std::int64_t> epoch;
    std::vector<double> offset;
    std::vector<double> normal[3], impulse[3];

    std::size_t rows() const { return kind.size(); }
    void add(const Event& event);
    Event row(std::size_t i) const;
    void clear();
    template <class Self, class Visit>
    static void visit(Self& self, const Visit& visit);
};

struct FlightColumns {
    std::vector<std::int32_t> body;
    std::vector<std::int64_t> after;  ///< how many events came before
    std::vector<std::int64_t> epoch;
    std::vector<double> offset;
    std::vector<std::int64_t> cell[3];
    std::vector<double> local[3], local_low[3], velocity[3], velocity_low[3];
    std::vector<std::int32_t> acceleration, support;
    std::vector<double> own[3];  ///< zeros but for an acceleration of its own
    std::vector<std::uint8_t> mode, guarded;
    std::vector<double> series[10];  ///< all rows; zeros but for series, which cost nothing

    std::size_t rows() const { return body.size(); }
    void add(const FlightRecord& flight, std::int64_t events_before);
    /// \pre mode is valid
    FlightRecord row(std::size_t i) const;
    void clear();
    template <class Self, class Visit>
    static void visit(Self& self, const Visit& visit);
};

Bytes packed(const EventColumns& columns);
Bytes packed(const FlightColumns& columns);
/// \throws InputError if the bytes are no such columns, or a value has no meaning
void unpack(EventColumns& columns, std::span<const unsigned char> data, std::size_t rows, const std::string& file);
void unpack(FlightColumns& columns, std::span<const unsigned char> data, std::size_t rows, const std::string& file);

}  // namespace carom::io
