/// \file
/// The command line of carom, called within the process of a test.
#pragma once

#include "cli/cli.hpp"

#include <sstream>
#include <string>
#include <vector>

namespace carom::test {

struct Said {
    int code;
    std::string out, err;
};

/// Exit code, stdout and stderr of `carom` with these arguments.
inline Said carom_tool(const std::vector<std::string>& args)
{
    std::ostringstream out, err;
    const int code = cli::run_cli(args, cli::Console{out, err});
    return {code, out.str(), err.str()};
}

}  // namespace carom::test
