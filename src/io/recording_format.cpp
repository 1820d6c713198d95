#include "io/recording_format.hpp"

namespace carom::io {

namespace {

/// Values one after the other, little endian, as the checksums see them.
class Digest {
public:
    explicit Digest(std::uint32_t before = 0) : crc_(before) {}
    template <class T>
    Digest& number(T value)
    {
        static_assert(std::is_arithmetic_v<T>);
        unsigned char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        crc_ = checksum(bytes, crc_);
        return *this;
    }
    /// With its length, so that what follows cannot be taken for a part of it.
    Digest& bytes(std::span<const unsigned char> data)
    {
        number(static_cast<std::int64_t>(data.size()));
        crc_ = checksum(data, crc_);
        return *this;
    }
    Digest& text(const std::string& text)
    {
        return bytes({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    }
    std::uint32_t value() const { return crc_; }

private:
    std::uint32_t crc_;
};

void add_rows(Digest& digest, const Meta& meta, const std::vector<std::string>& keys)
{
    for (const std::string& key : keys) {
        digest.text(key);
        const auto found = meta.find(key);
        digest.text(found == meta.end() ? std::string() : found->second);
    }
}

}  // namespace

const std::vector<std::string>& recording_tables()
{
    static const std::vector<std::string> tables{
        "CREATE TABLE meta(key TEXT, value TEXT)", "CREATE TABLE scene(document BLOB)",
        "CREATE TABLE frame(epoch_length REAL, cell_size REAL, gravity BLOB, accelerations BLOB, "
        "closing_speed REAL, impact_window REAL)",
        "CREATE TABLE bodies(kind TEXT, count INTEGER, data BLOB)",
        "CREATE TABLE chunks(seq INTEGER PRIMARY KEY, kind TEXT, count INTEGER, first_epoch INTEGER, first_offset "
        "REAL, last_epoch INTEGER, last_offset REAL, lowest_body INTEGER, highest_body INTEGER, checksum INTEGER, "
        "data BLOB)"};
    return tables;
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
    digest.bytes(scene);
    digest.number(frame.epoch_length).number(frame.cell_size).bytes(frame.gravity).bytes(frame.accelerations);
    digest.number(frame.closing_speed).number(frame.window);
    for (const BodiesRow& row : bodies) digest.text(row.kind).number(row.count).bytes(row.data);
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
    digest.number(row.seq).text(row.kind).number(row.count);
    digest.number(row.first.epoch).number(row.first.offset).number(row.last.epoch).number(row.last.offset);
    digest.number(row.lowest_body).number(row.highest_body).bytes(data);
    return digest.value();
}

}  // namespace carom::io
