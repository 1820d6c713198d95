#include "cli/toi_command.hpp"

#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "io/toi_line.hpp"

#include <iostream>
#include <limits>
#include <string>

namespace carom::cli {

namespace {

/// The next line, of one too long for a query only so much that this shows: it may have no end. False: there is none.
bool read_line(std::istream& in, std::string& line)
{
    line.clear();
    std::streambuf& source = *in.rdbuf();
    using Traits = std::istream::traits_type;
    while (line.size() <= io::longest_toi_line) {
        const int c = source.sbumpc();
        if (Traits::eq_int_type(c, Traits::eof())) return !line.empty();
        if (c == '\n') return true;
        line.push_back(Traits::to_char_type(c));
    }
    return true;
}

/// The rest of a line that was answered before its end.
void skip_line(std::istream& in)
{
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
}

}  // namespace

void serve_toi(std::istream& in, std::ostream& out)
{
    std::string line;
    while (out && read_line(in, line)) {
        out << io::answer_toi_line(line) << '\n';
        const bool is_cut = line.size() > io::longest_toi_line;
        if (is_cut || in.rdbuf()->in_avail() <= 0) out.flush();
        if (is_cut) skip_line(in);
    }
    out.flush();
}

int do_toi(const Console& console)
{
    std::ios::sync_with_stdio(false);  // nothing was read or written yet
    std::cin.tie(nullptr);
    serve_toi(std::cin, console.out);
    return console.out ? exit_ok : exit_failed;
}

}  // namespace carom::cli
