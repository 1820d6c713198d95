/// \file
/// Syntax errors in words for people: the right place, the usual slips with their cure.
#pragma once

#include <string>
#include <string_view>

namespace carom::io {

/// "FILE:LINE:COL: what is wrong (the cure)" of what a JSON parser could not take.
/// \param read how many bytes it had read, more than there are at the end of the text.
/// \param what its own message.
/// \param too_large the pointer of the number, if the error is that it exceeds a double; otherwise empty.
std::string syntax_error(std::string_view text, const std::string& file, std::size_t read, const std::string& what,
                         const std::string& too_large);

/// \throws InputError for what cannot be JSON at all and deserves a better word than the parser's: empty and binary
/// files.
void refuse_what_is_no_text(std::string_view text, const std::string& file);
/// \throws InputError
[[noreturn]] void refuse_binary(const std::string& file);

}  // namespace carom::io
