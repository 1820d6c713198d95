#include "study/clock.hpp"

#include "study/tolerances.hpp"

#include <chrono>
#include <ctime>

namespace carom::study {

namespace {

double seconds_of(clockid_t clock)
{
    std::timespec now{};
    if (clock_gettime(clock, &now) != 0) return 0;
    return static_cast<double>(now.tv_sec) + nanosecond * static_cast<double>(now.tv_nsec);
}

}  // namespace

double thread_cpu_seconds()
{
    return seconds_of(CLOCK_THREAD_CPUTIME_ID);
}

double process_cpu_seconds()
{
    return seconds_of(CLOCK_PROCESS_CPUTIME_ID);
}

double wall_seconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void Stopwatch::pause()
{
    cpu_ += thread_cpu_seconds() - cpu_start_;
    wall_ += wall_seconds() - wall_start_;
}

void Stopwatch::resume()
{
    wall_start_ = wall_seconds();
    cpu_start_ = thread_cpu_seconds();
}

}  // namespace carom::study
