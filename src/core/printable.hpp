/// \file
/// Text from files as a terminal may show it.
#pragma once

#include <string>
#include <string_view>

namespace carom {

/// `text` with control characters and what is no UTF-8 written as \xNN (the code point or byte, hexadecimal), so that
/// nothing in a file can move the cursor, colour or forge a line. Other text stays as it is.
std::string printable(std::string_view text);

}  // namespace carom
