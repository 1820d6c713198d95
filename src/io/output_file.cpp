#include "io/output_file.hpp"

#include <carom/error.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace carom::io {

namespace {

std::string reason(int error)
{
    return std::generic_category().message(error);
}

int open_to_write(const std::filesystem::path& file)
{
    constexpr mode_t anyone = S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH;  // less what the umask takes
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, anyone);
    if (descriptor < 0) throw InputError({file.string() + ": cannot be written: " + reason(errno)});
    return descriptor;
}

}  // namespace

DescriptorBuffer::DescriptorBuffer(int descriptor) : descriptor_(descriptor)
{
    setp(buffer_.data(), buffer_.data() + buffer_.size());
}

DescriptorBuffer::~DescriptorBuffer()
{
    sync();
}

std::string DescriptorBuffer::failure() const
{
    return error_ == 0 ? "" : reason(error_);
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type c)
{
    if (sync() != 0) return traits_type::eof();
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    return sputc(traits_type::to_char_type(c));
}

/// 0, or -1 from the first failure on, as the standard has it.
int DescriptorBuffer::sync()
{
    const char* next = pbase();
    while (error_ == 0 && next < pptr()) {
        const ssize_t written = ::write(descriptor_, next, static_cast<std::size_t>(pptr() - next));
        if (written >= 0)
            next += written;
        else if (errno != EINTR)
            error_ = errno;
    }
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    return error_ == 0 ? 0 : -1;
}

OutputFile::OutputFile(const std::filesystem::path& file)
    : file_(file), descriptor_(open_to_write(file)), buffer_(descriptor_), stream_(&buffer_)
{
}

OutputFile::~OutputFile()
{
    buffer_.pubsync();
    ::close(descriptor_);
}

void OutputFile::check() const
{
    if (const std::string why = buffer_.failure(); !why.empty())
        throw InputError({file_.string() + ": cannot be written: " + why});
}

void OutputFile::close()
{
    stream_.flush();
    check();
}

}  // namespace carom::io
