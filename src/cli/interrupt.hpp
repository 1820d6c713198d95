/// \file
/// Ctrl-C as a question that a run asks now and then.
#pragma once

namespace carom::cli {

/// While it lives, the first SIGINT or SIGTERM is remembered, and the second ends the process as usual.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    bool interrupted() const;
};

}  // namespace carom::cli
