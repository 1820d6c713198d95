/// \file
/// Layout of a recording, shared by writer and reader; docs/recording.md tells it to others.
#pragma once

#include "io/columns.hpp"
#include "io/limits.hpp"

#include <carom/verify.hpp>

#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carom::io {

inline constexpr std::int64_t recording_application_id = 0x6361726f;  ///< "caro"
inline constexpr std::int64_t recording_version = 3;
inline constexpr const char* recording_format = "carom-recording/3";

/// A table of the file: its name, and for each column "NAME TYPE".
struct RecordingTable {
    std::string_view name;
    std::span<const std::string_view> columns;
};
namespace recording_table_columns {
inline constexpr std::array<std::string_view, 2> meta{"key TEXT", "value TEXT"};
inline constexpr std::array<std::string_view, 1> scene{"document BLOB"};
inline constexpr std::array<std::string_view, 7> frame{"epoch_length REAL", "cell_size REAL",     "drag REAL",
                                                       "gravity BLOB",      "accelerations BLOB", "closing_speed REAL",
                                                       "impact_window REAL"};
inline constexpr std::array<std::string_view, 3> bodies{"kind TEXT", "count INTEGER", "data BLOB"};
inline constexpr std::array<std::string_view, 11> chunks{
    "seq INTEGER PRIMARY KEY", "kind TEXT",          "count INTEGER",    "first_epoch INTEGER",
    "first_offset REAL",       "last_epoch INTEGER", "last_offset REAL", "lowest_body INTEGER",
    "highest_body INTEGER",    "checksum INTEGER",   "data BLOB"};
}  // namespace recording_table_columns
inline constexpr RecordingTable meta_table{"meta", recording_table_columns::meta};
inline constexpr RecordingTable scene_table{"scene", recording_table_columns::scene};
inline constexpr RecordingTable frame_table{"frame", recording_table_columns::frame};
inline constexpr RecordingTable bodies_table{"bodies", recording_table_columns::bodies};
inline constexpr RecordingTable chunks_table{"chunks", recording_table_columns::chunks};
/// In the order in which a file has them.
inline constexpr std::array<RecordingTable, 5> recording_tables{meta_table, scene_table, frame_table, bodies_table,
                                                                chunks_table};

/// "meta(key, value)", as docs/recording.md names a table.
std::string table_text(const RecordingTable& table);
/// The statement that makes a table. The reader compares it letter by letter.
std::string create_table(const RecordingTable& table);
/// The statement that reads all rows, every column in its order. \param order the column that they are sorted by
std::string select_all(const RecordingTable& table, const char* order = "rowid");
/// The statement that adds a row, a parameter for each column in its order.
std::string insert_into(const RecordingTable& table);

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
    double epoch_length = 1, cell_size = 1, drag = 0;  ///< RunFrame
    Bytes gravity, accelerations;
    double closing_speed = 0, window = 0;  ///< RecordedRun
};

/// Each value of a row of `frame` in the order of its columns.
template <class Row, class Visit>
void each_frame_value(Row& row, const Visit& visit)
{
    visit(row.epoch_length);
    visit(row.cell_size);
    visit(row.drag);
    visit(row.gravity);
    visit(row.accelerations);
    visit(row.closing_speed);
    visit(row.window);
}

/// Each value of a row of `bodies` in the order of its columns.
template <class Row, class Visit>
void each_bodies_value(Row& row, const Visit& visit)
{
    visit(row.kind);
    visit(row.count);
    visit(row.data);
}

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
/// Each value of a row of `chunks` in the order of its columns, up to the checksum.
template <class Row, class Visit>
void each_chunk_value(Row& row, const Visit& visit)
{
    visit(row.seq);
    visit(row.kind);
    visit(row.count);
    visit(row.first.epoch);
    visit(row.first.offset);
    visit(row.last.epoch);
    visit(row.last.offset);
    visit(row.lowest_body);
    visit(row.highest_body);
}
/// CRC of a chunk, carried on from the one before: a chunk that is missing, or not in its place, shows.
std::uint32_t chunk_checksum(const ChunkRow& row, std::span<const unsigned char> data, std::uint32_t before);

}  // namespace carom::io
