/// \file
/// Columns of numbers as bytes, compressed: the inside of a recording's blobs (docs/recording.md).
///
/// A column of n values, w bytes each, little endian, is written as w planes: first byte 0 of every value, then byte 1
/// of every value, ... Of measured numbers the high planes (sign, exponent) hold few values and compress well, the low
/// ones are noise and are kept as they are: trying to compress them would cost more time than all the rest.
#pragma once

#include "io/sqlite.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace carom::io {

static_assert(std::endian::native == std::endian::little, "recordings are little endian");

/// CRC-32 (ISO 3309, as zlib computes it) of `data`, carried on from `before`. Every single flipped bit changes it.
std::uint32_t checksum(std::span<const unsigned char> data, std::uint32_t before = 0);

class ColumnWriter {
public:
    template <class T>
    void add(const std::vector<T>& values)
    {
        static_assert(std::is_arithmetic_v<T>);
        planes(reinterpret_cast<const unsigned char*>(values.data()), values.size(), sizeof(T));
    }
    /// Differences from row to row, the first from 0; for what mostly grows in small steps.
    void add_differences(const std::vector<std::int64_t>& values);
    const Bytes& bytes() const { return bytes_; }

private:
    void planes(const unsigned char* data, std::size_t count, std::size_t width);
    void plane(const Bytes& values);

    Bytes bytes_, plane_;
};

/// Reads back what ColumnWriter wrote. \throws InputError "FILE: damaged: ..." if the bytes cannot be that.
class ColumnReader {
public:
    /// `bytes` must outlive the reader.
    ColumnReader(std::span<const unsigned char> bytes, std::size_t rows, std::string file);

    template <class T>
    void read(std::vector<T>& values)
    {
        static_assert(std::is_arithmetic_v<T>);
        values.resize(rows_);
        planes(reinterpret_cast<unsigned char*>(values.data()), sizeof(T));
    }
    void read_differences(std::vector<std::int64_t>& values);
    /// \throws InputError unless everything has been read
    void finish() const;

private:
    void planes(unsigned char* data, std::size_t width);
    std::span<const unsigned char> take(std::size_t count);
    [[noreturn]] void damaged(const char* why) const;

    std::span<const unsigned char> rest_;
    std::size_t rows_;
    std::string file_;
    Bytes plane_;
};

}  // namespace carom::io
