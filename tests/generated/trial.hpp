/// \file
/// One run in a process of its own, so that a run that hangs or crashes is a result, too.
#pragma once

#include <carom/simulate.hpp>

#include <string>

namespace carom::test {

/// Values only: it is sent through a pipe.
struct Trial {
    bool ended = false;  ///< false: crashed, or did not stop when asked; the rest is 0 then
    Status status = Status::unresolved;
    double time = 0;         ///< reached [time]
    double cpu_seconds = 0;  ///< [s]
    Counts counts;
    double closed_form = 0, numeric = 0, guarded = 0;  ///< body-seconds [time]
    double busiest_window = 0;  ///< most impacts within one h before its last instant, a share of B n
    int lost = 0;               ///< spheres behind a plane or nowhere, at the end
    double penetration = 0;     ///< deepest at 200 times, of the smaller radius [1]
    double stated = 0;          ///< Outcome::max_penetration, of the smallest radius [1]
    char message[256] = {};     ///< Outcome::message, cut off
};

/// \param seconds limit for the run, of clock time; twice as much CPU time later the process is killed [s]
Trial run_trial(const Scene& scene, double seconds);

/// What is wrong with it, empty if nothing: a status other than reached_end, a lost sphere, too many impacts, a
/// penetration deeper than 1e-9 radii and than what the run stated, or one of 1e-2 radii that no guard made.
std::string complaint(const Trial& trial);

}  // namespace carom::test
