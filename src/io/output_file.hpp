/// \file
/// Streams over file descriptors that keep the reason of a failure, which those of the standard library lose.
#pragma once

#include <array>
#include <filesystem>
#include <ostream>
#include <streambuf>

namespace carom::io {

/// Writes to a descriptor that somebody else opened and closes.
class DescriptorBuffer final : public std::streambuf {
public:
    explicit DescriptorBuffer(int descriptor);
    /// The rest is written, as far as that goes.
    ~DescriptorBuffer() override;
    DescriptorBuffer(const DescriptorBuffer&) = delete;
    DescriptorBuffer& operator=(const DescriptorBuffer&) = delete;

    /// "No space left on device": why the first write that failed did; empty if none has.
    std::string failure() const;

protected:
    int_type overflow(int_type c) override;
    int sync() override;

private:
    int descriptor_;
    int error_ = 0;  ///< errno of the first failure
    std::array<char, 1 << 16> buffer_;
};

/// A file that is made, or emptied, and written.
class OutputFile {
public:
    /// \throws InputError "FILE: cannot be written: REASON"; so do all functions below
    explicit OutputFile(const std::filesystem::path& file);
    /// Closes it without a word.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    std::ostream& stream() { return stream_; }
    /// Whether everything so far could be taken; a full disk shows within 64 KiB.
    void check() const;
    /// Writes what is left.
    void close();

private:
    std::filesystem::path file_;
    int descriptor_;
    DescriptorBuffer buffer_;
    std::ostream stream_;
};

}  // namespace carom::io
