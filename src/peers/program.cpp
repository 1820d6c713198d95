#include "peers/program.hpp"

#include "peers/limits.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace carom::peers {

namespace {

/// Line with which every answer ends.
constexpr std::string_view last_line = "# end\n";

bool ends_answer(const std::string& text)
{
    return text.ends_with(last_line) &&
           (text.size() == last_line.size() || text[text.size() - last_line.size() - 1] == '\n');
}

/// In the child: what is left is to become the program.
[[noreturn]] void become(const std::filesystem::path& file, const std::vector<std::string>& arguments, int in, int out)
{
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::dup2(in, STDIN_FILENO);
    ::dup2(out, STDOUT_FILENO);
    std::vector<char*> words{const_cast<char*>(file.c_str())};
    for (const std::string& each : arguments) words.push_back(const_cast<char*>(each.c_str()));
    words.push_back(nullptr);
    ::execv(file.c_str(), words.data());
    ::_exit(EXIT_FAILURE);
}

/// A write of as much as goes without a wait. \returns false if nobody reads any more
bool write_some(int to, const std::string& text, std::size_t& written)
{
    const ssize_t n = ::write(to, text.data() + written, text.size() - written);
    if (n > 0) written += static_cast<std::size_t>(n);
    return n > 0 || errno == EAGAIN || errno == EINTR;
}

/// Text that has come, at most a pipeful. False at its end.
bool read_some(int from, std::string& text)
{
    std::array<char, read_at_once> buffer;
    const ssize_t n = ::read(from, buffer.data(), buffer.size());
    if (n > 0) text.append(buffer.data(), static_cast<std::size_t>(n));
    return n > 0 || (n < 0 && errno == EINTR);
}

/// A write to a program that has ended must fail, not end us.
class PipeSignalIgnored {
public:
    PipeSignalIgnored() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
    ~PipeSignalIgnored() { std::signal(SIGPIPE, before_); }
    PipeSignalIgnored(const PipeSignalIgnored&) = delete;
    PipeSignalIgnored& operator=(const PipeSignalIgnored&) = delete;

private:
    void (*before_)(int);
};

}  // namespace

Program::Program(std::filesystem::path file, std::vector<std::string> arguments)
    : file_(std::move(file)), arguments_(std::move(arguments))
{
}

Program::~Program()
{
    kill();
}

bool Program::start()
{
    std::array<int, 2> requests{}, answers{};
    if (::pipe2(requests.data(), O_CLOEXEC) != 0) return false;
    if (::pipe2(answers.data(), O_CLOEXEC) != 0) {
        for (const int end : requests) ::close(end);
        return false;
    }
    const pid_t id = ::fork();
    if (id == 0) become(file_, arguments_, requests[0], answers[1]);
    ::close(requests[0]);
    ::close(answers[1]);
    if (id < 0) {
        ::close(requests[1]);
        ::close(answers[0]);
        return false;
    }
    ::fcntl(requests[1], F_SETFL, O_NONBLOCK);
    child_ = Child{id, requests[1], answers[0]};
    return true;
}

void Program::kill()
{
    if (!child_) return;
    ::close(child_->to);
    ::close(child_->from);
    ::kill(child_->id, SIGKILL);
    while (::waitpid(child_->id, nullptr, 0) < 0 && errno == EINTR) continue;
    child_.reset();
}

Reply Program::ask(const std::string& request, const std::function<bool()>& keep_going, double seconds)
{
    using Clock = std::chrono::steady_clock;
    const PipeSignalIgnored ignored;
    const Clock::time_point deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    Reply reply;
    const auto end = [&](Talk talk) {
        kill();
        reply.talk = talk;
        return reply;
    };
    if (!child_ && !start()) return reply;
    std::size_t written = 0;
    while (!ends_answer(reply.text)) {
        const short writes = written < request.size() ? POLLOUT : 0;
        std::array<pollfd, 2> ends{{{child_->from, POLLIN, 0}, {writes != 0 ? child_->to : -1, writes, 0}}};
        ::poll(ends.data(), ends.size(), question_interval);
        if (keep_going && !keep_going()) return end(Talk::interrupted);
        if (Clock::now() > deadline) return end(Talk::too_long);
        if (ends[1].revents != 0 && !write_some(child_->to, request, written)) return end(Talk::broken);
        if (ends[0].revents != 0 && !read_some(child_->from, reply.text)) return end(Talk::broken);
    }
    reply.text.resize(reply.text.size() - last_line.size());
    reply.talk = Talk::answered;
    return reply;
}

}  // namespace carom::peers
