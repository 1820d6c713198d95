#include "core/expect.hpp"
#include "core/patience.hpp"
#include "core/random.hpp"
#include "study/words.hpp"
#include "tunnel/judge.hpp"
#include "tunnel/scene_throws.hpp"
#include "tunnel/tally.hpp"

#include <algorithm>

namespace carom::tunnel {

namespace {

void count(const Contestant& who, SceneThrows& throws, const Cell& cell, const Matrix& matrix, Tally& tally,
           Patience& patience)
{
    Random random(matrix.seed, stream_of(cell));
    for (std::int64_t k = 0; k < matrix.trials && patience.lasts_for(1); ++k) {
        const Aim aim{1 - random.uniform(), 0};
        if (throws.place(aim.phase, cell.dt)) tally.add(aim, judge(who, throws.current(), cell.dt));
    }
}

}  // namespace

bool some_body_moves(const Scene& scene)
{
    return std::any_of(scene.spheres.begin(), scene.spheres.end(),
                       [](const Sphere& sphere) { return sphere.velocity != Vec3::Zero(); });
}

void run_scene(const Scene& scene, const Matrix& matrix, const std::vector<Contestant>& contestants, Report& report,
               const OnProgress& on_progress)
{
    report.scene = scene.name;
    CAROM_EXPECT(some_body_moves(scene));
    Patience patience(on_progress);
    const double longest_step = *std::max_element(matrix.dt.begin(), matrix.dt.end());
    std::vector<SceneThrows> speeds;
    for (const double speed : matrix.speed) {
        if (!patience.lasts()) break;
        SceneThrows throws(scene, speed, longest_step, on_progress);
        if (!patience.lasts()) break;
        if (throws.has_contact())
            speeds.push_back(std::move(throws));
        else
            report.absent.push_back(
                {"speed " + study::three_digits(speed),
                 "\"" + throws.thrown() + "\" meets nothing faster than v_c in the time of the scene"});
    }
    patience.begin("tunnel", static_cast<double>(contestants.size() * matrix.dt.size() * speeds.size()), "cells");
    std::size_t done = 0;
    for (const Contestant& who : contestants) {
        patience.name(who.method);
        for (const double dt : matrix.dt)
            for (SceneThrows& throws : speeds) {
                if (!patience.lasts(static_cast<double>(done++))) break;
                const Cell cell = throws.cell(dt);
                Tally tally(who, cell);
                count(who, throws, cell, matrix, tally, patience);
                const std::optional<double> seen = throws.seen_of_a_step(dt);
                if (seen && who.chords_seen) tally.row.law = std::max(0.0, 1 - *who.chords_seen * *seen);
                if (patience.ended()) break;
                if (tally.row.trials > 0 && throws.place(tally.row.example.phase, dt))
                    tally.row.example_throw = throws.current();
                report.rows.push_back(std::move(tally.row));
            }
    }
    report.interrupted = report.interrupted || patience.ended();
}

}  // namespace carom::tunnel
