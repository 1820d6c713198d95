#include "peers/limits.hpp"
#include "peers/peers.hpp"
#include "study/tolerances.hpp"

#include <carom/error.hpp>
#include <carom/progress.hpp>

#include <cstddef>

namespace carom::peers {

namespace {

/// When the engine first answered: the begin of the first step in which the velocity of the body changes by more than
/// gravity's part, for engines change velocities first and move then.
std::optional<double> first_answer(const tunnel::Throw& t, const PeerRun& run, double dt)
{
    const auto body = static_cast<std::size_t>(t.body);
    Vec3 before = t.scene.spheres[body].velocity;
    for (std::size_t k = 0; k < run.samples.size(); ++k) {
        const Vec3& after = run.samples[k][body].velocity;
        if ((after - before - dt * t.scene.gravity).norm() > least_answer * t.speed_change)
            return static_cast<double>(k) * dt;
        before = after;
    }
    return {};
}

/// Words of the engine on itself in a run without a step; empty if it gives no answer, as then throws will tell.
std::string settings_of(const Peer& peer, const std::function<bool()>& keep_going)
{
    Scene still;
    still.end_time = 1;
    Sphere ball;
    ball.id = "ball";
    ball.radius = 1;
    still.spheres.push_back(ball);
    return peer.run(still, 1, {}, keep_going).settings;
}

tunnel::Flown flown(const tunnel::Throw& t, const PeerRun& run, double dt)
{
    const auto body = static_cast<std::size_t>(t.body);
    const BodyState& judged = run.samples[static_cast<std::size_t>(study::audited_steps) - 1][body];
    const BodyState& last = run.samples.back()[body];
    return {first_answer(t, run, dt), judged.position, judged.velocity, last.position, last.velocity};
}

}  // namespace

tunnel::Contestant peer_contestant(const std::string& name, const std::filesystem::path& program,
                                   std::function<bool()> keep_going)
{
    tunnel::Contestant who;
    who.method = name;
    who.chords_seen = chords_seen_by(name);
    const Peer peer = make_peer(name, program);
    who.settings = settings_of(peer, keep_going);
    who.fly = [peer, keep_going = std::move(keep_going)](const tunnel::Throw& t, double dt, std::int64_t steps) {
        std::vector<double> times;
        for (std::int64_t k = 1; k <= steps; ++k) times.push_back(static_cast<double>(k) * dt);
        const PeerRun run = peer.run(t.scene, dt, times, keep_going);
        if (run.status == Status::interrupted) throw Stopped();
        if (run.status != Status::reached_end)
            throw InputError({peer.name + ": " + run.message + " (a throw at a step of " + std::to_string(dt) + ")"});
        return flown(t, run, dt);
    };
    return who;
}

}  // namespace carom::peers
