#include "io/recording_format.hpp"

namespace carom::io {

namespace {

/// Values one after the other, little endian, as the checksums see them.
class Digest {
public:
    explicit Digest(std::uint32_t before = 0) : crc_(before) {}
    template <class T>
    Digest& add(T value)
    {
        static_assert(std::is_arithmetic_v<T>);
        unsigned char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        crc_ = checksum(bytes, crc_);
        return *this;
    }
    /// With its length, so that what follows cannot be taken for a part of it.
    Digest& add(std::span<const unsigned char> data)
    {
        add(static_cast<std::int64_t>(data.size()));
        crc_ = checksum(data, crc_);
        return *this;
    }
    Digest& add(const Bytes& data) { return add(std::span(data)); }
    Digest& add(const std::string& text)
    {
        return add(std::span{reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    }
    std::uint32_t value() const { return crc_; }

private:
    std::uint32_t crc_;
};

void add_rows(Digest& digest, const Meta& meta, const std::vector<std::string>& keys)
{
    for (const std::string& key : keys) {
        digest.add(key);
        const auto found = meta.find(key);
        digest.add(found == meta.end() ? std::string() : found->second);
    }
}

}  // namespace

namespace {

std::string name_of_column(std::string_view column)
{
    return std::string(column.substr(0, column.find(' ')));
}

/// `part` of each column, separated by ", ".
template <class Part>
std::string listed(const RecordingTable& table, const Part& part)
{
    std::string text;
    for (const std::string_view column : table.columns) text += (text.empty() ? "" : ", ") + part(column);
    return text;
}

}  // namespace

std::string table_text(const RecordingTable& table)
{
    return std::string(table.name) + "(" + listed(table, name_of_column) + ")";
}

std::string create_table(const RecordingTable& table)
{
    return "CREATE TABLE " + std::string(table.name) + "(" +
           listed(table, [](std::string_view column) { return std::string(column); }) + ")";
}

std::string select_all(const RecordingTable& table, const char* order)
{
    return "SELECT " + listed(table, name_of_column) + " FROM " + std::string(table.name) + " ORDER BY " + order;
}

std::string insert_into(const RecordingTable& table)
{
    return "INSERT INTO " + std::string(table.name) + " VALUES (" +
           listed(table, [](std::string_view) { return std::string("?"); }) + ")";
}

const std::vector<std::string>& head_keys()
{
    static const std::vector<std::string> keys{"format", "scene", "method", "number", "until"};
    return keys;
}

const std::vector<std::string>& end_keys()
{
    static const std::vector<std::string> keys{"status", "message", "time",  "event_hash",
                                               "events", "flights", "chunks"};
    return keys;
}

std::uint32_t head_checksum(const Meta& meta, const Bytes& scene, const FrameRow& frame,
                            const std::vector<BodiesRow>& bodies)
{
    Digest digest;
    add_rows(digest, meta, head_keys());
    digest.add(scene);
    const auto add = [&](const auto& value) { digest.add(value); };
    each_frame_value(frame, add);
    for (const BodiesRow& row : bodies) each_bodies_value(row, add);
    return digest.value();
}

std::uint32_t end_checksum(const Meta& meta, std::uint32_t before)
{
    Digest digest(before);
    add_rows(digest, meta, end_keys());
    return digest.value();
}

std::uint32_t chunk_checksum(const ChunkRow& row, std::span<const unsigned char> data, std::uint32_t before)
{
    Digest digest(before);
    each_chunk_value(row, [&](const auto& value) { digest.add(value); });
    digest.add(data);
    return digest.value();
}

}  // namespace carom::io
