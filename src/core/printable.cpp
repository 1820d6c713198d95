#include "core/printable.hpp"

#include <cstddef>

namespace carom {

namespace {

unsigned byte_of(char c)
{
    return static_cast<unsigned char>(c);
}

/// Length of the UTF-8 sequence that `text` begins with, as its first byte says and the others confirm; 0 if it is
/// none. \pre text is not empty
std::size_t sequence_length(std::string_view text)
{
    const unsigned first = byte_of(text.front());
    const std::size_t length = first < 0x80                    ? 1
                               : first >= 0xc2 && first < 0xe0 ? 2
                               : first >= 0xe0 && first < 0xf0 ? 3
                               : first >= 0xf0 && first < 0xf5 ? 4
                                                               : 0;
    if (length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte_of(text[i]) & 0xc0) != 0x80) return 0;
    return length;
}

std::string escaped(unsigned code)
{
    constexpr char digits[] = "0123456789abcdef";
    return {'\\', 'x', digits[code >> 4], digits[code & 15]};
}

}  // namespace

std::string printable(std::string_view text)
{
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = sequence_length(text);
        const unsigned first = byte_of(text.front());
        // U+0080 to U+009F, control characters too, are C2 80 to C2 9F.
        const bool is_upper_control = length == 2 && first == 0xc2 && byte_of(text[1]) < 0xa0;
        if (length == 0 || first < 0x20 || first == 0x7f)
            out += escaped(first);
        else if (is_upper_control)
            out += escaped(byte_of(text[1]));
        else
            out += text.substr(0, length);
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return out;
}

}  // namespace carom
