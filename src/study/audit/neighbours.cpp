#include "study/audit/neighbours.hpp"

#include "study/tolerances.hpp"

#include <algorithm>

namespace carom::study {

namespace {

/// The ball that a sphere stays in.
struct Swept {
    BodyId body;
    Vec3 centre;    ///< [length]
    double radius;  ///< [length]
};

bool meet(const Swept& a, const Swept& b)
{
    const double sum = a.radius + b.radius;
    return (a.centre - b.centre).squaredNorm() <= sum * sum;
}

}  // namespace

std::vector<BodyId> bodies_near(const Scene& scene, const Truth& truth, std::span<const BodyId> core, double time,
                                double span)
{
    const double gain = scene.gravity.norm() * span;
    std::vector<Swept> found, others;
    double fastest = 0;
    for (const BodyId body : core) fastest = std::max(fastest, truth.state(body, time).velocity.norm());
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const auto body = static_cast<BodyId>(i);
        const TruthState state = truth.state(body, time);
        const bool in_core = std::find(core.begin(), core.end(), body) != core.end();
        const double speed = in_core ? elastic_gain * fastest : state.velocity.norm();
        const double way = scene.spheres[i].fixed ? 0 : (speed + gain) * span;
        (in_core ? found : others).push_back({body, state.position, scene.spheres[i].radius + way});
    }
    std::size_t begin = 0;
    for (int hop = 0; hop < neighbour_hops; ++hop) {
        const std::size_t end = found.size();
        for (; begin < end; ++begin) {
            if (hop > 0 && scene.spheres[static_cast<std::size_t>(found[begin].body)].fixed) continue;
            const Swept from = found[begin];
            const auto near =
                std::partition(others.begin(), others.end(), [&](const Swept& s) { return !meet(from, s); });
            found.insert(found.end(), near, others.end());
            others.erase(near, others.end());
        }
    }
    std::vector<BodyId> bodies;
    for (const Swept& each : found) bodies.push_back(each.body);
    std::sort(bodies.begin(), bodies.end());
    return bodies;
}

}  // namespace carom::study
