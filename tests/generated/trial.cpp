#include "generated/trial.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <type_traits>

namespace carom::test {

namespace {

static_assert(std::is_trivially_copyable_v<Trial>);

double deepest(const Scene& scene, std::span<const BodyState> states)
{
    double worst = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Sphere& s = scene.spheres[i];
        for (std::size_t j = 0; j < i; ++j) {
            const Sphere& t = scene.spheres[j];
            if (s.fixed && t.fixed) continue;
            const double gap = (states[i].position - states[j].position).norm() - s.radius - t.radius;
            worst = std::max(worst, -gap / std::min(s.radius, t.radius));
        }
        if (s.fixed) continue;
        for (const Plane& p : scene.planes) worst = std::max(worst, -plane_gap(p, s, states[i].position) / s.radius);
    }
    return worst;
}

int lost(const Scene& scene, const std::vector<BodyState>& states)
{
    int count = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        bool there = states[i].position.allFinite() && states[i].velocity.allFinite();
        for (const Plane& p : scene.planes) there = there && p.normal.dot(states[i].position) > p.offset;
        if (!there) ++count;
    }
    return count;
}

/// The bound on impacts of a body in a window: B, and 1.11 B / (1 - e) if that is more, for the largest e < 1
/// (docs/impacts.md, section 7).
double bound_of_impacts(const Scene& scene)
{
    double largest = 0;
    const int n = static_cast<int>(scene.materials.size());
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (const ContactLaw& law : {sphere_contact_law(scene, i, j), plane_contact_law(scene, i, j)})
                if (law.restitution < 1) largest = std::max(largest, law.restitution);
    return static_cast<double>(scene.guard.impacts) * std::max(1.0, 1.11 / (1 - largest));
}

Trial measure(const Scene& scene, double seconds)
{
    const double window = rest_thresholds(scene).numeric_step;
    double smallest = scene.spheres.front().radius, movable = 0;
    for (const Sphere& s : scene.spheres) {
        smallest = std::min(smallest, s.radius);
        movable += s.fixed ? 0 : 1;
    }
    Trial trial;
    // Impacts of one window, without those of its last instant: the guard comes after an instant, whatever its size.
    double bin = 0, in_bin = 0, instant = -1, most = 0;
    Observer observer;
    observer.on_event = [&](const Event& e) {
        if (e.kind != EventKind::impact || !(window > 0)) return;
        const double now = std::floor(e.time / window);
        if (now != bin) in_bin = 0;
        if (e.time != instant) most = std::max(most, in_bin);
        ++in_bin;
        bin = now;
        instant = e.time;
    };
    observer.sample_times = sample_grid(scene.end_time, 200);
    observer.on_sample = [&](std::size_t, double, std::span<const BodyState> states) {
        trial.penetration = std::max(trial.penetration, deepest(scene, states));
    };
    observer.on_progress = [](double) { return true; };
    RunOptions options;
    options.max_seconds = seconds;
    const std::clock_t start = std::clock();
    const Outcome outcome = simulate(scene, EventDriven{}, options, observer);
    trial.cpu_seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    trial.ended = true;
    trial.status = outcome.status;
    trial.time = outcome.time;
    trial.counts = outcome.counts;
    trial.closed_form = outcome.body_seconds.closed_form;
    trial.numeric = outcome.body_seconds.numeric;
    trial.guarded = outcome.body_seconds.guarded;
    trial.busiest_window = most / (bound_of_impacts(scene) * movable);
    trial.lost = lost(scene, outcome.final);
    trial.stated = outcome.max_penetration / smallest;
    std::strncpy(trial.message, outcome.message.c_str(), sizeof trial.message - 1);
    return trial;
}

}  // namespace

Trial run_trial(const Scene& scene, double seconds)
{
    int ends[2];
    if (pipe(ends) != 0) return {};
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        const auto limit = static_cast<rlim_t>(2 * seconds + 2);
        const rlimit cpu{limit, limit};
        setrlimit(RLIMIT_CPU, &cpu);
        const Trial trial = measure(scene, seconds);
        const bool sent = write(ends[1], &trial, sizeof trial) == static_cast<ssize_t>(sizeof trial);
        _exit(sent ? 0 : 1);
    }
    close(ends[1]);
    Trial trial;
    std::size_t got = 0;
    while (child > 0 && got < sizeof trial) {
        const ssize_t more = read(ends[0], reinterpret_cast<char*>(&trial) + got, sizeof trial - got);
        if (more <= 0) break;
        got += static_cast<std::size_t>(more);
    }
    close(ends[0]);
    if (child > 0) waitpid(child, nullptr, 0);
    return got == sizeof trial ? trial : Trial{};
}

std::string complaint(const Trial& trial)
{
    constexpr double touching = 1e-9;  // persistent contacts are within it
    constexpr double sunk = 1e-2;      // of a radius: no numeric step does that
    if (!trial.ended) return "crashed or hung";
    if (trial.status != Status::reached_end) return name(trial.status);
    if (trial.lost > 0) return "lost spheres";
    if (trial.busiest_window > 1) return "more impacts than the bound";
    if (trial.counts.guarded == 0 && trial.stated > sunk) return "sunk";
    if (trial.penetration > std::max(1.01 * touching, 1.01 * trial.stated)) return "deeper than stated";
    return "";
}

}  // namespace carom::test
