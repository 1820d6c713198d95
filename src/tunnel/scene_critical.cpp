#include "core/expect.hpp"
#include "core/patience.hpp"
#include "tunnel/judge.hpp"
#include "tunnel/scene_throws.hpp"

#include <algorithm>

namespace carom::tunnel {

namespace {

/// The greatest speed at the start [length/time].
double own_speed(const Scene& scene)
{
    double speed = 0;
    for (const Sphere& sphere : scene.spheres) speed = std::max(speed, sphere.velocity.norm());
    return speed;
}

/// Whether a throw tunnels in one of so many equal parts of a step; none where none of them can be judged.
std::optional<bool> some_tunnel(const Contestant& who, SceneThrows& throws, double dt)
{
    std::optional<bool> some;
    if (!throws.has_contact()) return some;
    for (std::size_t k = 0; k < searched_phases; ++k) {
        if (!throws.place(searched_phase(k), dt)) continue;
        some = judge(who, throws.current(), dt).fate == Fate::tunnelled;
        if (*some) break;
    }
    return some;
}

}  // namespace

void find_scene_criticals(const Scene& scene, const Matrix& matrix, const std::vector<Contestant>& contestants,
                          Report& report, const OnProgress& on_progress)
{
    CAROM_EXPECT(some_body_moves(scene));
    Patience patience(on_progress);
    const OnProgress asked = [&](const Progress&) { return patience.lasts(); };
    patience.begin("critical speeds", static_cast<double>(matrix.dt.size() * contestants.size()), "searches");
    std::size_t done = 0;
    for (const double dt : matrix.dt) {
        const SceneThrows own(scene, own_speed(scene), dt, asked);
        if (!patience.lasts()) break;
        if (!own.has_contact()) {
            report.absent.push_back({"critical speed", "\"" + own.thrown() + "\" meets nothing at its own speed"});
            break;
        }
        const Cell cell = own.cell(dt);
        if (cell.target == Target::wall) {
            report.absent.push_back(
                {"critical speed", "\"" + own.thrown() + "\" meets a wall first: nothing is behind it"});
            break;
        }
        const std::optional<double> seen = own.seen_of_a_step(dt);
        for (const Contestant& who : contestants) {
            patience.name(who.method);
            if (!patience.lasts(static_cast<double>(done++))) break;
            Critical critical{who.method, who.variant, who.integrator, cell, 0, {}, {}};
            critical.speed = search_critical(cell.reach() / dt, [&](double speed) -> std::optional<bool> {
                SceneThrows throws(scene, speed, dt, asked);
                if (patience.ended()) return {};
                return some_tunnel(who, throws, dt);
            });
            if (seen && who.chords_seen) critical.law = *who.chords_seen * *seen * own.speed();
            if (!patience.ended()) report.criticals.push_back(std::move(critical));
        }
    }
    report.interrupted = report.interrupted || patience.ended();
}

}  // namespace carom::tunnel
