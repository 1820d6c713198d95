/// \file
/// A program that answers requests on its stdin by text on its stdout.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace carom::peers {

/// How a request ended.
enum class Talk : std::uint8_t {
    answered,
    interrupted,  ///< by `keep_going`
    too_long,     ///< no answer in time
    broken        ///< the program ended, or could not be started
};

struct Reply {
    Talk talk = Talk::broken;
    std::string text;  ///< up to the line that ends an answer, without it; what came before the talk ended otherwise
};

/// A child process in a process group of its own, so that Ctrl-C in a terminal reaches it through us. It is killed when
/// the talk ends otherwise than by an answer, with this object, and by the kernel if we are killed ourselves.
class Program {
public:
    /// Starts nothing: the first request does.
    Program(std::filesystem::path file, std::vector<std::string> arguments);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// Sends a request and waits for the line "# end". \param keep_going may be empty; asked now and then
    /// \param seconds to wait at most [s]
    Reply ask(const std::string& request, const std::function<bool()>& keep_going, double seconds);

    bool is_running() const { return child_.has_value(); }

private:
    struct Child {
        pid_t id = 0;
        int to = 0, from = 0;  ///< ends of its pipes
    };
    bool start();
    void kill();

    std::filesystem::path file_;
    std::vector<std::string> arguments_;
    std::optional<Child> child_;
};

}  // namespace carom::peers
