#include "cli/console.hpp"

#include <carom/error.hpp>

#include <fstream>
#include <iterator>
#include <ostream>
#include <system_error>

namespace carom::cli {

void print_error(const Console& console, const std::string& text)
{
    console.err << (console.color ? "\033[31mcarom:\033[0m " : "carom: ") << text << '\n';
}

void print_note(const Console& console, const std::string& text)
{
    console.err << "carom: note: " << text << '\n';
}

void write_file(const std::filesystem::path& file, const std::string& text)
{
    std::error_code error;
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
    const std::filesystem::path half = file.string() + ".part";
    std::ofstream stream(half, std::ios::binary);
    stream << text;
    stream.close();
    if (stream) std::filesystem::rename(half, file, error);
    if (!stream || error) throw InputError({file.string() + ": cannot be written"});
}

std::string read_file(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream.good() && !stream.eof()) throw InputError({file.string() + ": cannot be read"});
    if (!std::filesystem::is_regular_file(file)) throw InputError({file.string() + ": no such file"});
    return text;
}

}  // namespace carom::cli
