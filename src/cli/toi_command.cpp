#include "cli/toi_command.hpp"

#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "io/toi_line.hpp"

#include <iostream>
#include <string>

namespace carom::cli {

void serve_toi(std::istream& in, std::ostream& out)
{
    std::string line;
    while (out && std::getline(in, line)) {
        out << io::answer_toi_line(line) << '\n';
        if (in.rdbuf()->in_avail() <= 0) out.flush();
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
