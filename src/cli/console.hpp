/// \file
/// Where a command writes, and how: data to `out`, words for people to `err`.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

namespace carom::cli {

struct Console {
    std::ostream& out;
    std::ostream& err;
    bool err_is_terminal = false;
    bool color = false;  ///< on a terminal, and NO_COLOR is not set
};

/// "carom: TEXT", the name in red on a terminal; control characters in TEXT, which may come from a file, are escaped.
/// So are those of notes.
void print_error(const Console& console, const std::string& text);

/// "carom: note: TEXT": what is no error but should be known.
void print_note(const Console& console, const std::string& text);

/// Writes `text` beside `file` and renames it, so that an interrupted write leaves no half file. Makes the folders.
/// \throws InputError if that cannot be done
void write_file(const std::filesystem::path& file, const std::string& text);

/// \throws InputError if the file cannot be read
std::string read_file(const std::filesystem::path& file);

}  // namespace carom::cli
