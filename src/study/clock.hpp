/// \file
/// Time spent: by this thread, by the process, and on the wall.
#pragma once

namespace carom::study {

/// CPU time of the calling thread since some moment [s].
double thread_cpu_seconds();
/// CPU time of the process, all its threads, since some moment [s].
double process_cpu_seconds();
/// Steady time since some moment [s].
double wall_seconds();

/// Both clocks, with pauses: what looking at a run costs is not the run's.
class Stopwatch {
public:
    Stopwatch() { resume(); }
    void pause();
    void resume();
    /// Total while running. \pre paused
    double cpu() const { return cpu_; }
    double wall() const { return wall_; }

private:
    double cpu_ = 0, wall_ = 0, cpu_start_ = 0, wall_start_ = 0;
};

}  // namespace carom::study
