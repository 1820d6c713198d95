#include "cli/interrupt.hpp"

#include <csignal>

namespace carom::cli {

namespace {

// A signal handler can reach nothing but a global: the one of the program.
volatile std::sig_atomic_t signal_seen = 0;

extern "C" void remember_signal(int)
{
    signal_seen = 1;
}

}  // namespace

InterruptGuard::InterruptGuard()
{
    signal_seen = 0;
    struct sigaction action {};
    action.sa_handler = remember_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

InterruptGuard::~InterruptGuard()
{
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool InterruptGuard::interrupted() const
{
    return signal_seen != 0;
}

}  // namespace carom::cli
