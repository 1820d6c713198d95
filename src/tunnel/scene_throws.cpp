#include "tunnel/scene_throws.hpp"

#include "study/audit/neighbours.hpp"
#include "study/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::tunnel {

namespace {

BodyId fastest(const Scene& scene)
{
    const auto slower = [](const Sphere& a, const Sphere& b) { return a.velocity.norm() < b.velocity.norm(); };
    return static_cast<BodyId>(std::max_element(scene.spheres.begin(), scene.spheres.end(), slower) -
                               scene.spheres.begin());
}

Scene scaled(Scene scene, BodyId body, double speed)
{
    Vec3& velocity = scene.spheres[static_cast<std::size_t>(body)].velocity;
    velocity *= speed / velocity.norm();
    return scene;
}

/// When the body has its first impact; `until` if it has none before [time].
double first_impact(const Scene& scene, BodyId body, double until, const OnProgress& on_progress)
{
    double first = until;
    bool found = false;
    Observer observer;
    observer.on_event = [&](const Event& event) {
        if (found || event.kind != EventKind::impact || (event.a != body && event.b != body)) return;
        found = true;
        first = event.time;
    };
    observer.on_progress = [&](double time) {
        return !found && (!on_progress || on_progress({"truth", "truth", time / until, time, ""}));
    };
    simulate(scene, EventDriven{}, {.until = until}, observer);
    return first;
}

/// How long a body is watched for its first impact: the scene's length, and longer where it is slower [time].
double horizon(const Scene& scene, BodyId body, double speed)
{
    return scene.end_time * std::max(1.0, scene.spheres[static_cast<std::size_t>(body)].velocity.norm() / speed);
}

std::vector<BodyId> movable_of(const Scene& scene, const study::TruthContact& contact)
{
    std::vector<BodyId> bodies;
    for (const BodyId body : {contact.a, contact.b})
        if (static_cast<std::size_t>(body) < scene.spheres.size() &&
            !scene.spheres[static_cast<std::size_t>(body)].fixed)
            bodies.push_back(body);
    return bodies;
}

}  // namespace

SceneThrows::SceneThrows(const Scene& scene, double speed, double longest_step, const OnProgress& on_progress)
    : scene_(scaled(scene, fastest(scene), speed)),
      speed_(speed),
      body_(fastest(scene)),
      truth_(study::record_truth(
          scene_,
          first_impact(scene_, body_, horizon(scene, body_, speed), on_progress) + study::longest_case * longest_step,
          on_progress))
{
    const auto found = std::find_if(truth_.contacts.begin(), truth_.contacts.end(),
                                    [&](const auto& contact) { return contact.a == body_ || contact.b == body_; });
    contact_ = static_cast<std::size_t>(found - truth_.contacts.begin());
    throw_.scene = scene_;
}

Cell SceneThrows::cell(double dt) const
{
    const study::TruthContact& contact = truth_.contacts[contact_];
    const auto partner = static_cast<std::size_t>(contact.a == body_ ? contact.b : contact.a);
    Cell cell{Target::wall, {}, scene_.spheres[static_cast<std::size_t>(body_)].radius, dt, speed_};
    if (partner < scene_.spheres.size()) {
        cell.target = Target::sphere;
        cell.thickness = 2 * scene_.spheres[partner].radius;
    } else if (const Plane& plane = scene_.planes[partner - scene_.spheres.size()]; plane.thickness) {
        cell.target = Target::plate;
        cell.thickness = plane.thickness;
    }
    return cell;
}

bool SceneThrows::is_crowded(double start, double dt) const
{
    const study::TruthContact& contact = truth_.contacts[contact_];
    for (const BodyId body : movable_of(scene_, contact))
        if (!truth_.is_alone(body, start, start + study::audited_steps * dt, contact.time)) return true;
    if (start >= 0) return false;
    // Flights that are followed back beyond the start of the run may begin in other bodies.
    for (const Sphere& sphere : throw_.scene.spheres) {
        if (sphere.fixed) continue;
        for (const Plane& plane : scene_.planes)
            if (plane_gap(plane, sphere, sphere.position) < 0) return true;
        for (const Sphere& other : throw_.scene.spheres)
            if (&other != &sphere && (other.position - sphere.position).norm() < other.radius + sphere.radius)
                return true;
    }
    return false;
}

/// Steps in which the body would be through, were nothing in its way, by its speed along the normal.
double SceneThrows::closing_steps(double dt) const
{
    const study::TruthContact& contact = truth_.contacts[contact_];
    const study::TruthState a = truth_.state_before(contact.a, contact.time);
    const auto partner = static_cast<std::size_t>(contact.b);
    study::TruthState b;
    Vec3 normal;
    if (partner < scene_.spheres.size()) {
        b = truth_.state_before(contact.b, contact.time);
        normal = (a.position - b.position).normalized();
    } else {
        normal = scene_.planes[partner - scene_.spheres.size()].normal;
    }
    const double closing = std::abs(normal.dot(a.velocity - b.velocity));
    return 2 * cell(dt).reach() / (closing * dt);
}

std::optional<double> SceneThrows::seen_of_a_step(double dt) const
{
    const study::TruthContact& contact = truth_.contacts[contact_];
    if (!scene_.gravity.isZero(0) || scene_.drag > 0 || movable_of(scene_, contact).size() > 1) return {};
    const study::TruthState at = truth_.state_before(body_, contact.time);
    const auto partner = static_cast<std::size_t>(contact.a == body_ ? contact.b : contact.a);
    const double way = at.velocity.norm() * dt;
    if (partner < scene_.spheres.size())
        return -(at.position - scene_.spheres[partner].position).dot(at.velocity) / at.velocity.norm() / way;
    const Plane& plane = scene_.planes[partner - scene_.spheres.size()];
    if (!plane.thickness) return std::numeric_limits<double>::infinity();
    return cell(dt).reach() / (std::abs(plane.normal.dot(at.velocity)) * dt);
}

bool SceneThrows::place(double phase, double dt)
{
    const study::TruthContact& contact = truth_.contacts[contact_];
    const double start = contact.time - phase * dt;
    const std::vector<BodyId> core = movable_of(scene_, contact);
    std::vector<BodyId> near = study::bodies_near(scene_, truth_, core, start, study::longest_case * dt);
    for (const BodyId body : {contact.a, contact.b})  // a fixed partner is no core, but it must be there
        if (static_cast<std::size_t>(body) < scene_.spheres.size() &&
            std::find(near.begin(), near.end(), body) == near.end())
            near.insert(std::lower_bound(near.begin(), near.end(), body), body);
    const auto number = [&](BodyId body) {
        if (static_cast<std::size_t>(body) >= scene_.spheres.size())
            return static_cast<BodyId>(static_cast<std::size_t>(body) - scene_.spheres.size() + near.size());
        return static_cast<BodyId>(std::lower_bound(near.begin(), near.end(), body) - near.begin());
    };
    throw_.scene.spheres.clear();
    for (const BodyId body : near) {
        const study::TruthState state = truth_.state(body, start);
        Sphere& sphere = throw_.scene.spheres.emplace_back(scene_.spheres[static_cast<std::size_t>(body)]);
        sphere.position = state.position;
        sphere.velocity = state.velocity;
    }
    throw_.body = number(body_);
    throw_.partner = number(contact.a == body_ ? contact.b : contact.a);
    throw_.contact_time = contact.time - start;
    throw_.speed_change = contact.speed_change;
    const study::TruthState after = truth_.state(body_, start + study::audited_steps * dt);
    throw_.position = after.position;
    throw_.velocity = after.velocity;
    throw_.steps_to_pass = closing_steps(dt);
    return !is_crowded(start, dt);
}

}  // namespace carom::tunnel
