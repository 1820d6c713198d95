// Balls dropped into one box, by the engine: carom_heap_bench COUNT RESTITUTION SECONDS SEED [LAYERS].
#include "heap_box.hpp"

#include <carom/simulate.hpp>

#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace carom;

namespace {

double cpu()
{
    std::timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

Scene scene_of(const bench::Box& box, double restitution, double seconds)
{
    Scene scene;
    scene.guard.fallback = GuardFallback::windows;
    scene.gravity = Vec3(0, 0, -bench::gravity);
    scene.end_time = seconds;
    scene.materials.resize(1);
    scene.materials.front().restitution = restitution;
    for (const WindowBody& ball : box.balls) {
        Sphere sphere;
        sphere.radius = ball.radius;
        sphere.mass = 1 / ball.inverse_mass;
        sphere.position = ball.place;
        scene.spheres.push_back(sphere);
    }
    for (const WindowPlane& plane : box.planes) {
        Plane each;
        each.normal = plane.normal;
        each.offset = plane.offset;
        scene.planes.push_back(each);
    }
    return scene;
}

double energy(const Scene& scene, const std::vector<BodyState>& states)
{
    double out = 0;
    for (std::size_t i = 0; i < states.size(); ++i)
        out += scene.spheres[i].mass * (states[i].velocity.squaredNorm() / 2 - scene.gravity.dot(states[i].position));
    return out;
}

/// Lowest gap of all pairs now [smallest radius].
double lowest_gap(const Scene& scene, std::span<const BodyState> states)
{
    double out = 1;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Sphere& a = scene.spheres[i];
        for (std::size_t j = 0; j < i; ++j) {
            const double sum = a.radius + scene.spheres[j].radius;
            const Vec3 apart = states[i].position - states[j].position;
            if (apart.squaredNorm() < 4 * sum * sum)
                out = std::min(out, (apart.norm() - sum) / std::min(a.radius, scene.spheres[j].radius));
        }
        for (const Plane& p : scene.planes)
            out = std::min(out, (p.normal.dot(states[i].position) - p.offset - a.radius) / a.radius);
    }
    return out;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc < 5) {
        std::fprintf(stderr, "usage: carom_heap_bench COUNT RESTITUTION SECONDS SEED [LAYERS]\n");
        return 2;
    }
    const bench::Box box = bench::drop(std::atoi(argv[1]), static_cast<std::uint64_t>(std::atoll(argv[4])),
                                       argc > 5 ? std::atof(argv[5]) : 3.5);
    const Scene scene = scene_of(box, std::atof(argv[2]), std::atof(argv[3]));
    double least = 1, most_energy = 0, rise_at = 0, checking = 0;
    Observer observer;
    observer.sample_times = sample_grid(scene.end_time, 1500);
    std::vector<BodyState> start;
    double before = 0;
    observer.on_sample = [&](std::size_t k, double time, std::span<const BodyState> states) {
        const double begun = cpu();
        const double now = energy(scene, {states.begin(), states.end()});
        if (k == 0) start.assign(states.begin(), states.end());
        if (k > 0 && now - before > most_energy) {
            most_energy = now - before;
            rise_at = time;
        }
        before = now;
        least = std::min(least, lowest_gap(scene, states));
        checking += cpu() - begun;
    };
    const double begun = cpu();
    const Outcome out = simulate(scene, EventDriven{}, {}, observer);
    const double spent = cpu() - begun - checking;
    int resting = 0, sliding = 0;
    double last = 0, height = 0, mass = 0, fastest = 0;
    for (std::size_t i = 0; i < out.final.size(); ++i) {
        resting += out.final[i].mode == Mode::resting;
        sliding += out.final[i].mode == Mode::sliding;
        last = std::max(last, out.rest_times[i].value_or(scene.end_time));
        height += scene.spheres[i].mass * out.final[i].position.z();
        mass += scene.spheres[i].mass;
        fastest = std::max(fastest, out.final[i].velocity.norm());
    }
    const double first = energy(scene, start), taken = first - energy(scene, out.final);
    std::printf(
        "N %zu e %.2f: cpu %.2f s, %s at %.3f s, resting %d + sliding %d (last %.3f s), fastest %.1e, lowest "
        "gap %.1e r, energy taken %.4f E0 (window %.4f), largest rise %.1e E0 (at %.5f s), height %.6f m\n"
        "   impacts %lld, windows %lld, numeric steps %lld, clusters %lld; body-seconds: closed %.2f numeric "
        "%.3f windows %.2f; hash %016llx\n",
        out.final.size(), std::atof(argv[2]), spent, name(out.status), out.time, resting, sliding, last, fastest, least,
        taken / first, out.energy_taken.window / first, most_energy / first, rise_at, height / mass,
        static_cast<long long>(out.counts.impacts), static_cast<long long>(out.counts.guarded),
        static_cast<long long>(out.counts.numeric_steps), static_cast<long long>(out.counts.clusters),
        out.body_seconds.closed_form, out.body_seconds.numeric, out.body_seconds.guarded,
        static_cast<unsigned long long>(out.event_hash));
}
