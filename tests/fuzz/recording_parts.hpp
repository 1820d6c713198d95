/// \file
/// A recording taken apart, so that it can be changed in a sensible place and put together again with every checksum
/// right.
#pragma once

#include "io/recording_format.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace carom::fuzz {

struct Chunk {
    io::ChunkRow row;
    io::Bytes data;
};

struct RecordingParts {
    io::Meta meta;
    io::Bytes scene;
    io::FrameRow frame;
    std::vector<io::BodiesRow> bodies;
    std::vector<Chunk> chunks;
};

/// \throws InputError if the file is no recording
RecordingParts read_parts(const std::filesystem::path& file);
/// With checksums as a writer would make them.
void write_parts(const std::filesystem::path& file, RecordingParts parts);

/// A file in memory where the system has such a place; gone with this object.
class MemoryFile {
public:
    MemoryFile();
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    void write(const unsigned char* data, std::size_t size) const;
    std::string read() const;
    const std::filesystem::path& path() const { return path_; }

private:
    void remove() const;
    std::filesystem::path path_;
};

}  // namespace carom::fuzz
