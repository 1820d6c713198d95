#include "study/audit/run.hpp"

#include "core/expect.hpp"
#include "scene/without_bodies.hpp"
#include "study/tolerances.hpp"

#include <algorithm>
#include <limits>

namespace carom::study {

CaseRunner::CaseRunner(const Scene& scene, const Truth& truth)
    : scene_(scene), truth_(truth), case_(without_bodies(scene))
{
    case_.planes = scene.planes;
}

void CaseRunner::place(const std::vector<BodyId>& bodies, double start)
{
    case_.spheres.clear();
    for (const BodyId body : bodies) {
        const TruthState state = truth_.state(body, start);
        Sphere& sphere = case_.spheres.emplace_back(scene_.spheres[static_cast<std::size_t>(body)]);
        sphere.position = state.position;
        sphere.velocity = state.velocity;
    }
}

BodyId CaseRunner::number_in_case(const std::vector<BodyId>& bodies, BodyId body) const
{
    const auto spheres = static_cast<BodyId>(scene_.spheres.size());
    if (body >= spheres) return case_.plane_body(static_cast<std::size_t>(body - spheres));
    return static_cast<BodyId>(std::lower_bound(bodies.begin(), bodies.end(), body) - bodies.begin());
}

bool CaseRunner::is_right(const ContactCase& contact, double end, const std::vector<BodyState>& after) const
{
    const auto is_right_of = [&](BodyId body) {
        if (static_cast<std::size_t>(body) >= scene_.spheres.size()) return true;
        const auto k = static_cast<std::size_t>(number_in_case(contact.bodies, body));
        return (after[k].velocity - truth_.state(body, end).velocity).norm() <=
               right_velocity * contact.contact.speed_change;
    };
    return is_right_of(contact.contact.a) && is_right_of(contact.contact.b);
}

ContactAnswer CaseRunner::ask(const ContactCase& contact, const Method& method)
{
    const double dt = step_options(method)->dt;
    place(contact.bodies, contact.start);
    const BodyId a = number_in_case(contact.bodies, contact.contact.a);
    const BodyId b = number_in_case(contact.bodies, contact.contact.b);
    double answered = std::numeric_limits<double>::infinity();
    std::vector<BodyState> after;
    Observer observer;
    observer.sample_times = {audited_steps * dt};
    observer.on_event = [&](const Event& event) {
        if (event.a == a && event.b == b) answered = std::min(answered, event.time);
    };
    observer.on_sample = [&](std::size_t, double, std::span<const BodyState> states) {
        after.assign(states.begin(), states.end());
    };
    simulate(case_, method, {.until = longest_case * dt}, observer);
    if (!(answered <= audited_steps * dt)) return {};
    const double delay = (answered - (contact.contact.time - contact.start)) / dt;
    if (answered > dt) return {Answer::late, delay};
    const bool right = !after.empty() && is_right(contact, contact.start + audited_steps * dt, after);
    return {right ? Answer::found : Answer::wrong, delay};
}

bool CaseRunner::invents(const QuietCase& quiet, const Method& method)
{
    const double dt = step_options(method)->dt;
    place(quiet.bodies, quiet.start);
    const BodyId body = number_in_case(quiet.bodies, quiet.body);
    bool answered = false;
    Observer observer;
    observer.on_event = [&](const Event& event) {
        if ((event.a == body || event.b == body) && event.time <= audited_steps * dt) answered = true;
    };
    simulate(case_, method, {.until = longest_case * dt}, observer);
    return answered;
}

}  // namespace carom::study
