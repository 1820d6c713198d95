#include "fuzz/recording_parts.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <system_error>

namespace carom::fuzz {

using namespace io;

namespace {

Bytes copy(std::span<const unsigned char> bytes)
{
    return {bytes.begin(), bytes.end()};
}

ChunkRow chunk_row(const Statement& rows)
{
    ChunkRow row;
    int column = 0;
    each_chunk_value(row, [&](auto& value) { rows.get(column++, value); });
    return row;
}

void write_chunks(Database& database, const RecordingParts& parts, std::uint32_t& checksum)
{
    for (const auto& [row, data] : parts.chunks) {
        checksum = chunk_checksum(row, data, checksum);
        Statement insert(database, insert_into(chunks_table).c_str());
        int parameter = 0;
        each_chunk_value(row, [&](const auto& value) { insert.bind(parameter++, value); });
        insert.bind(parameter, static_cast<std::int64_t>(checksum)).bind(parameter + 1, data).step();
    }
}

void write_meta(Database& database, const Meta& meta)
{
    for (const auto& [key, value] : meta)
        Statement(database, "INSERT INTO meta VALUES (?, ?)").bind(0, key).bind(1, value).step();
}

}  // namespace

RecordingParts read_parts(const std::filesystem::path& file)
{
    Database database(file, Access::read);
    RecordingParts parts;
    for (Statement rows(database, "SELECT key, value FROM meta"); rows.step();) parts.meta[rows.text(0)] = rows.text(1);
    for (Statement rows(database, "SELECT document FROM scene"); rows.step();) parts.scene = copy(rows.blob(0));
    for (Statement rows(database, select_all(frame_table).c_str()); rows.step();) {
        int column = 0;
        each_frame_value(parts.frame, [&](auto& value) { rows.get(column++, value); });
    }
    for (Statement rows(database, "SELECT kind, count, data FROM bodies ORDER BY rowid"); rows.step();)
        parts.bodies.push_back({rows.text(0), rows.integer(1), copy(rows.blob(2))});
    Statement rows(database, select_all(chunks_table, "seq").c_str());
    while (rows.step()) parts.chunks.push_back({chunk_row(rows), copy(rows.blob(10))});
    return parts;
}

void write_parts(const std::filesystem::path& file, RecordingParts parts)
{
    Database database(file, Access::create);
    database.execute("PRAGMA page_size = 1024; PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; BEGIN;");
    database.execute(("PRAGMA application_id = " + std::to_string(recording_application_id) +
                      "; PRAGMA user_version = " + std::to_string(recording_version))
                         .c_str());
    for (const RecordingTable& table : recording_tables) database.execute(create_table(table).c_str());
    std::uint32_t checksum = head_checksum(parts.meta, parts.scene, parts.frame, parts.bodies);
    if (parts.meta.contains("head_checksum")) parts.meta["head_checksum"] = std::to_string(checksum);
    Statement(database, "INSERT INTO scene VALUES (?)").bind(0, parts.scene).step();
    Statement frame(database, insert_into(frame_table).c_str());
    int column = 0;
    each_frame_value(parts.frame, [&](const auto& value) { frame.bind(column++, value); });
    frame.step();
    for (const BodiesRow& row : parts.bodies)
        Statement(database, "INSERT INTO bodies VALUES (?, ?, ?)")
            .bind(0, row.kind)
            .bind(1, row.count)
            .bind(2, row.data)
            .step();
    write_chunks(database, parts, checksum);
    if (parts.meta.contains("end_checksum"))
        parts.meta["end_checksum"] = std::to_string(end_checksum(parts.meta, checksum));
    write_meta(database, parts.meta);
    database.execute("COMMIT");
}

MemoryFile::MemoryFile()
{
    std::error_code none;
    const std::filesystem::path memory = "/dev/shm";
    const auto folder = std::filesystem::is_directory(memory, none) ? memory : std::filesystem::temp_directory_path();
    static int made = 0;
    path_ = folder / ("carom-fuzz-" + std::to_string(::getpid()) + "-" + std::to_string(made++ % 4));
    remove();
}

MemoryFile::~MemoryFile()
{
    remove();
}

void MemoryFile::remove() const
{
    std::error_code ignored;
    for (const char* suffix : {"", "-journal", "-wal", "-shm"})
        std::filesystem::remove(path_.string() + suffix, ignored);
}

void MemoryFile::write(const unsigned char* data, std::size_t size) const
{
    remove();
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
}

std::string MemoryFile::read() const
{
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace carom::fuzz
