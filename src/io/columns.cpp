#include "io/columns.hpp"

#include "io/limits.hpp"

#include <carom/error.hpp>

#include <zlib.h>

#include <algorithm>
#include <array>

namespace carom::io {

namespace {

enum PlaneMethod : unsigned char { plain = 0, deflated = 1, constant = 2 };

/// Is it worth a try? Noise has every byte equally often: the chance that two bytes agree is then 1/256. Compressible
/// planes agree more often.
bool looks_compressible(const Bytes& values)
{
    std::array<std::uint32_t, 256> seen{};
    const std::size_t n = std::min(values.size(), compression_sample);
    for (std::size_t i = 0; i < n; ++i) ++seen[values[i]];
    double agreeing = 0;
    for (const std::uint32_t k : seen) agreeing += static_cast<double>(k) * (k - (k > 0));
    const double pairs = static_cast<double>(n) * static_cast<double>(n - 1);
    return agreeing * static_cast<double>(seen.size()) > compressible_from * pairs;
}

}  // namespace

std::uint32_t checksum(std::span<const unsigned char> data, std::uint32_t before)
{
    return static_cast<std::uint32_t>(crc32_z(before, data.data(), data.size()));
}

void ColumnWriter::add_differences(const std::vector<std::int64_t>& values)
{
    std::vector<std::uint64_t> differences(values.size());  // unsigned: they may wrap around
    std::uint64_t before = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto value = static_cast<std::uint64_t>(values[i]);
        differences[i] = value - before;
        before = value;
    }
    add(differences);
}

void ColumnWriter::planes(const unsigned char* data, std::size_t count, std::size_t width)
{
    plane_.resize(count);
    for (std::size_t k = 0; k < width; ++k) {
        for (std::size_t i = 0; i < count; ++i) plane_[i] = data[i * width + k];
        plane(plane_);
    }
}

void ColumnWriter::plane(const Bytes& values)
{
    const auto head = [&](PlaneMethod method, std::size_t length) {
        bytes_.push_back(method);
        const auto n = static_cast<std::uint32_t>(length);
        for (int k = 0; k < 4; ++k) bytes_.push_back(static_cast<unsigned char>(n >> (8 * k)));
    };
    if (values.empty()) return head(plain, 0);
    if (std::all_of(values.begin(), values.end(), [&](unsigned char v) { return v == values.front(); })) {
        head(constant, 1);
        bytes_.push_back(values.front());
        return;
    }
    if (looks_compressible(values)) {
        uLongf length = compressBound(values.size());
        Bytes packed(length);
        const int fastest = 1;
        if (compress2(packed.data(), &length, values.data(), values.size(), fastest) == Z_OK &&
            length < values.size()) {
            head(deflated, length);
            bytes_.insert(bytes_.end(), packed.begin(), packed.begin() + static_cast<std::ptrdiff_t>(length));
            return;
        }
    }
    head(plain, values.size());
    bytes_.insert(bytes_.end(), values.begin(), values.end());
}

ColumnReader::ColumnReader(std::span<const unsigned char> bytes, std::size_t rows, std::string file)
    : rest_(bytes), rows_(rows), file_(std::move(file))
{
}

void ColumnReader::damaged(const char* why) const
{
    throw InputError({file_ + ": damaged: " + why});
}

std::span<const unsigned char> ColumnReader::take(std::size_t count)
{
    if (count > rest_.size()) damaged("a column ends early");
    const auto taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
}

void ColumnReader::planes(unsigned char* data, std::size_t width)
{
    for (std::size_t k = 0; k < width; ++k) {
        const auto head = take(5);
        std::uint32_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length |= static_cast<std::uint32_t>(head[1 + i]) << (8 * i);
        std::span<const unsigned char> values = take(length);
        if (head[0] == constant) {
            if (length != 1) damaged("a constant column of several bytes");
            for (std::size_t i = 0; i < rows_; ++i) data[i * width + k] = values[0];
            continue;
        }
        if (head[0] == deflated) {
            plane_.resize(rows_);
            uLongf unpacked = rows_;
            if (uncompress(plane_.data(), &unpacked, values.data(), values.size()) != Z_OK || unpacked != rows_)
                damaged("a column cannot be unpacked");
            values = plane_;
        } else if (head[0] != plain) {
            damaged("a column packed in an unknown way");
        }
        if (values.size() != rows_) damaged("a column of the wrong length");
        for (std::size_t i = 0; i < rows_; ++i) data[i * width + k] = values[i];
    }
}

void ColumnReader::read_differences(std::vector<std::int64_t>& values)
{
    read(values);
    std::uint64_t sum = 0;
    for (std::int64_t& value : values) {
        sum += static_cast<std::uint64_t>(value);
        value = static_cast<std::int64_t>(sum);
    }
}

void ColumnReader::finish() const
{
    if (!rest_.empty()) damaged("bytes after the last column");
}

}  // namespace carom::io
