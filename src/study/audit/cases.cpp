#include "study/audit/cases.hpp"

#include "core/random.hpp"
#include "study/audit/neighbours.hpp"
#include "study/tolerances.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace carom::study {

namespace {

/// Streams of the seed, so that a further draw of one kind moves none of another.
enum Stream : std::uint64_t { contact_stream = 0x61756469, phase_stream, quiet_stream };

bool can_move(const Scene& scene, BodyId body)
{
    return static_cast<std::size_t>(body) < scene.spheres.size() &&
           !scene.spheres[static_cast<std::size_t>(body)].fixed;
}

std::vector<BodyId> spheres_of(const Scene& scene, const TruthContact& contact)
{
    if (static_cast<std::size_t>(contact.b) < scene.spheres.size()) return {contact.a, contact.b};
    return {contact.a};
}

bool is_crowded(const Scene& scene, const Truth& truth, const TruthContact& contact, double begin, double end)
{
    const std::vector<BodyId> spheres = spheres_of(scene, contact);
    return !std::all_of(spheres.begin(), spheres.end(), [&](BodyId body) {
        return !can_move(scene, body) || truth.is_alone(body, begin, end, contact.time);
    });
}

/// Whether a sphere of the impact overlaps another body at `time`: flights that go back beyond the start of the run
/// may.
bool overlaps(const Scene& scene, const Truth& truth, const TruthContact& contact, const std::vector<BodyId>& near,
              double time)
{
    for (const BodyId body : spheres_of(scene, contact)) {
        const Sphere& sphere = scene.spheres[static_cast<std::size_t>(body)];
        const Vec3 place = truth.state(body, time).position;
        for (const Plane& plane : scene.planes)
            if (plane_gap(plane, sphere, place) < 0) return true;
        for (const BodyId other : near) {
            const double sum = sphere.radius + scene.spheres[static_cast<std::size_t>(other)].radius;
            if (other != body && (truth.state(other, time).position - place).norm() < sum) return true;
        }
    }
    return false;
}

std::vector<QuietCase> quiet_cases(const Scene& scene, const Truth& truth, double dt, double end, std::uint64_t seed)
{
    std::vector<QuietCase> cases;
    std::vector<BodyId> movable;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        if (!scene.spheres[i].fixed) movable.push_back(static_cast<BodyId>(i));
    if (movable.empty()) return cases;
    Random random(seed, quiet_stream);
    for (std::size_t k = 0; k < quiet_draws; ++k) {
        const BodyId body = movable[random.below(movable.size())];
        const double start = random.uniform(0, end);
        if (!truth.is_quiet(body, start, start + longest_case * dt)) continue;
        cases.push_back({body, start, bodies_near(scene, truth, std::array{body}, start, longest_case * dt)});
    }
    return cases;
}

}  // namespace

std::vector<std::size_t> drawn_contacts(const Truth& truth, double end, std::uint64_t seed)
{
    const auto last = std::partition_point(truth.contacts.begin(), truth.contacts.end(),
                                           [&](const TruthContact& contact) { return contact.time <= end; });
    std::vector<std::size_t> indices(static_cast<std::size_t>(last - truth.contacts.begin()));
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    if (indices.size() <= most_audited) return indices;
    Random random(seed, contact_stream);
    for (std::size_t k = 0; k < most_audited; ++k) std::swap(indices[k], indices[k + random.below(indices.size() - k)]);
    indices.resize(most_audited);
    std::sort(indices.begin(), indices.end());
    return indices;
}

int phases_of(std::size_t drawn)
{
    return drawn == 0 ? 1 : static_cast<int>((least_asked + drawn - 1) / drawn);
}

AuditCases make_cases(const Scene& scene, const Truth& truth, const std::vector<std::size_t>& drawn, double dt,
                      double end, std::uint64_t seed)
{
    AuditCases cases;
    cases.dt = dt;
    Random random(seed, phase_stream);
    const auto add = [&](const TruthContact& contact, double phase) {
        const double start = contact.time - phase * dt;
        if (is_crowded(scene, truth, contact, start, start + audited_steps * dt)) {
            ++cases.crowded;
            return;
        }
        std::vector<BodyId> near = bodies_near(scene, truth, spheres_of(scene, contact), start, longest_case * dt);
        if (start < 0 && overlaps(scene, truth, contact, near, start))
            ++cases.crowded;
        else
            cases.contacts.push_back({contact, start, std::move(near)});
    };
    for (int k = 0; k < phases_of(drawn.size()); ++k)
        for (const std::size_t index : drawn) {
            const double phase = 1 - random.uniform();  // in (0, 1]: the contact comes after the start
            add(truth.contacts[index], phase);
        }
    cases.quiet = quiet_cases(scene, truth, dt, end, seed);
    return cases;
}

}  // namespace carom::study
