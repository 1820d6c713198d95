#include "study/clock.hpp"

#include "study/tolerances.hpp"

#include <chrono>
#include <ctime>

namespace carom::study {

double thread_cpu_seconds()
{
    std::timespec now{};
    if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) return 0;
    return static_cast<double>(now.tv_sec) + nanosecond * static_cast<double>(now.tv_nsec);
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
