#include "io/machine.hpp"

#include <fstream>
#include <thread>

namespace carom::io {

namespace {

/// The value of the first line "model name : ..." of the system's list of processors.
std::string cpu_model()
{
    std::ifstream list("/proc/cpuinfo");
    for (std::string line; std::getline(list, line);) {
        if (line.rfind("model name", 0) != 0) continue;
        const std::size_t begin = line.find_first_not_of(" \t", line.find(':') + 1);
        return begin == std::string::npos ? "" : line.substr(begin);
    }
    return "";
}

std::string compiler_name()
{
#if defined(__clang__)
    return __VERSION__;  // begins with its name
#elif defined(__GNUC__)
    return "GCC " __VERSION__;
#else
    return "unknown";
#endif
}

}  // namespace

Machine this_machine()
{
    return {cpu_model(), std::thread::hardware_concurrency(), compiler_name()};
}

}  // namespace carom::io
