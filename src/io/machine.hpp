/// \file
/// The machine on which times were taken, and what compiled the program.
#pragma once

#include <string>

namespace carom::io {

struct Machine {
    std::string cpu;       ///< model as the system names it; empty where it does not say
    unsigned threads = 0;  ///< that it runs at once; 0 where it does not say
    std::string compiler;  ///< name and version
};
Machine this_machine();

}  // namespace carom::io
