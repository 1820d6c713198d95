#include "cli/define.hpp"

#include <CLI/CLI.hpp>

namespace carom::cli {

void define_toi(CLI::App& app)
{
    app.footer(
        "Reads queries from stdin, one JSON object a line, and answers each with one on stdout. Accelerations are 0 "
        "and\n"
        "\"until\" is infinite unless given; a plane {\"n\", \"offset\", \"thickness\"} may stand in place of b. The "
        "exact\n"
        "time lies in [lo, hi], t within 1 ulp of it; level: 0 double, 1 double-double, 2 exact. A line that is no "
        "query\n"
        "is answered with {\"status\": \"error\", \"message\": ..} and the next one is served.\n"
        "Example:\n"
        "  echo '{\"a\": {\"p\": [0,0,0], \"v\": [1,0,0], \"r\": 1}, \"b\": {\"p\": [10,0,0], \"v\": [-1,0,0], \"r\": "
        "2}}' | carom toi\n"
        "  "
        "{\"status\":\"impact\",\"t\":3.5,\"lo\":3.4999999999999996,\"hi\":3.5000000000000004,\"normal\":[-1,0,0],"
        "\"approach_speed\":2,\"level\":0}\n"
        "Exit: 0 when stdin ends.");
}

}  // namespace carom::cli
