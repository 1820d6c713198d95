#include "cli/define.hpp"

#include <CLI/CLI.hpp>

namespace carom::cli {

void define_toi(CLI::App& app)
{
    app.footer(
        "Reads queries from stdin, one JSON object a line, and answers each with one on stdout.\n"
        "Query:\n"
        "  a, b    spheres: centre \"p\", velocity \"v\", acceleration \"acc\" [0,0,0], radius \"r\"\n"
        "  plane   in place of b: normal \"n\", \"offset\" of the free side n.x >= offset, \"thickness\" of a plate "
        "[none]\n"
        "  until   a later impact is none [infinity]\n"
        "Answer:\n"
        "  status  impact; touching: at t = 0 the gap is <= 0 and the bodies approach; none: neither ever happens; "
        "error\n"
        "  t       within 1 ulp of the exact time, which lies in [lo, hi]\n"
        "  level   of arithmetic that decided: 0 double, 1 double-double, 2 exact\n"
        "  overlap only of bodies that overlap at t = 0, and how deep: at rest or parting they are in no impact, so "
        "that\n"
        "          the status is none, or a later impact when they come back\n"
        "A line that is no query is answered with {\"status\": \"error\", \"message\": ..} and the next one is "
        "served.\n"
        "Example:\n"
        "  echo '{\"a\": {\"p\": [0,0,0], \"v\": [1,0,0], \"r\": 1}, \"b\": {\"p\": [10,0,0], \"v\": [-1,0,0], \"r\": "
        "2}}' | carom toi\n"
        "  "
        "{\"status\":\"impact\",\"t\":3.5,\"lo\":3.4999999999999996,\"hi\":3.5000000000000004,\"normal\":[-1,0,0],"
        "\"approach_speed\":2,\"level\":0}\n"
        "Exit: 0 when stdin ends.");
}

}  // namespace carom::cli
