/// \file
/// Programs of a few lines that stand for engines.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace carom::test {

/// A shell script in a folder of its own, gone afterwards.
class Script {
public:
    explicit Script(const std::string& text, const std::string& name = "peer")
        : folder_(std::filesystem::temp_directory_path() /
                  ("carom-peer-" + std::to_string(::getpid()) + "-" + std::to_string(number())))
    {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        file_ = folder_ / name;
        std::ofstream(file_) << "#!/bin/sh\n" << text;
        std::filesystem::permissions(file_, std::filesystem::perms::owner_all);
    }
    ~Script() { std::filesystem::remove_all(folder_); }
    Script(const Script&) = delete;
    Script& operator=(const Script&) = delete;

    const std::filesystem::path& file() const { return file_; }
    const std::filesystem::path& folder() const { return folder_; }

private:
    static int number()
    {
        static int last = 0;
        return ++last;
    }

    std::filesystem::path folder_, file_;
};

/// Answers each request by a sphere "s0" that is at (T, 0, 0) with velocity (1, 0, 0) at each time T.
inline const char* const along_x =
    "while read -r run dt times && read -r scene; do\n"
    "  echo '# Walker 1.0, as it comes'; echo t,id,x,y,z,vx,vy,vz\n"
    "  for t in $times; do echo \"$t,s0,$t,0,0,1,0,0\"; done\n"
    "  echo '# steps 7 cpu_seconds 0.25'; echo '# end'\n"
    "done\n";

}  // namespace carom::test
