#include "cli/console.hpp"

#include "core/printable.hpp"
#include "io/output_file.hpp"

#include <carom/error.hpp>

#include <fstream>
#include <iterator>
#include <ostream>
#include <system_error>

namespace carom::cli {

void print_error(const Console& console, const std::string& text)
{
    console.err << (console.color ? "\033[31mcarom:\033[0m " : "carom: ") << printable(text) << '\n';
}

void print_note(const Console& console, const std::string& text)
{
    console.err << "carom: note: " << printable(text) << '\n';
}

void write_file(const std::filesystem::path& file, const std::string& text)
{
    std::error_code ignored;  // opening tells
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
    const std::filesystem::path half = file.string() + ".part";
    try {
        io::OutputFile out(half);
        out.stream() << text;
        out.close();
    } catch (const InputError&) {
        std::filesystem::remove(half, ignored);
        throw;
    }
    std::error_code error;
    std::filesystem::rename(half, file, error);
    if (error) throw InputError({file.string() + ": cannot be written: " + error.message()});
}

std::string read_file(const std::filesystem::path& file)
{
    if (!std::filesystem::is_regular_file(file)) throw InputError({file.string() + ": no such file"});
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream.good() && !stream.eof()) throw InputError({file.string() + ": cannot be read"});
    return text;
}

}  // namespace carom::cli
