#include "hold/persistence.hpp"

#include "contact/contact_forces.hpp"
#include "contact/contact_problem.hpp"
#include "hold/tolerances.hpp"
#include "math/disjoint_sets.hpp"
#include "math/length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

double fastest(const ContactComponent& component)
{
    double largest = 0;
    for (const ContactBody& b : component.problem.bodies) largest = std::max(largest, b.velocity.squaredNorm());
    return std::sqrt(largest);
}

}  // namespace

Persistence::Persistence(const State& state, ContactComponent component)
    : state_(state),
      component_(std::move(component)),
      slow_(state.tolerances.slow(fastest(component_))),
      soft_(state.tolerances.acceleration),
      released_(component_.problem.contacts.size(), 0),
      impulses_(component_.problem.contacts.size(), 0)
{
    choose_candidates();
    find_forces();
    if (project_velocities()) {  // normals turn at other rates now
        find_forces();
        project_velocities();
    }
}

bool Persistence::rests(std::size_t body) const
{
    return problem().bodies[body].velocity.isZero(0) && acceleration_[body].isZero(0);
}

bool Persistence::turns(std::size_t contact) const
{
    if (problem().contacts[contact].partner.is_plane()) return false;
    const Vec3& of_a = acceleration_[static_cast<std::size_t>(a(contact))];
    const Vec3 relative = !b(contact) ? of_a : Vec3(of_a - acceleration_[static_cast<std::size_t>(*b(contact))]);
    return length(relative_velocity(contact)) > slow_ || length(relative) > same_;
}

void Persistence::release(const std::vector<std::size_t>& contacts)
{
    for (const std::size_t i : contacts) {
        persists_[i] = 0;
        released_[i] = 1;
    }
    project_velocities();
}

Vec3 Persistence::relative_velocity(std::size_t contact) const
{
    const Vec3& v = problem().bodies[static_cast<std::size_t>(a(contact))].velocity;
    return b(contact) ? Vec3(v - problem().bodies[static_cast<std::size_t>(*b(contact))].velocity) : v;
}

double Persistence::rate(std::size_t contact) const
{
    return problem().contacts[contact].normal.dot(relative_velocity(contact));
}

bool Persistence::is_closed(std::size_t contact) const
{
    const Contact& c = problem().contacts[contact];
    return c.gap <= persistence_gap(state_, id_of_a(c), c.partner);
}

/// Contacts that are closed and have no rate to speak of.
void Persistence::choose_candidates()
{
    const bool loses = state_.scene.rest.policy == RestPolicy::contact &&
                       std::any_of(problem().contacts.begin(), problem().contacts.end(),
                                   [](const Contact& c) { return c.restitution < 1; });
    for (std::size_t i = 0; i < count(); ++i)
        persists_.push_back(is_closed(i) && rate(i) <= (loses ? std::max(slow_, lowest_rebound(i)) : slow_));
}

/// The speed below which a contact that forces press comes back without a rebound, so that it persists at once: v_c in
/// heaps, elsewhere that of a bounce that rounding ends.
double Persistence::lowest_rebound(std::size_t contact) const
{
    if (component_.is_heap) return state_.rest.closing_speed;
    const Contact& c = problem().contacts[contact];
    const double radius = state_.smaller_radius(id_of_a(c), c.partner);
    return std::sqrt(2 * length(state_.gravity()) * state_.lowest_bounce(radius));
}

/// Forces in what persists; what they do not keep closed persists no more.
void Persistence::find_forces()
{
    ContactProblem forced{problem().bodies, {}};
    for (ContactBody& body : forced.bodies) body.velocity = state_.gravity();
    std::vector<double> curvature, before;
    for (std::size_t i = 0; i < count(); ++i) {
        if (!persists_[i]) continue;
        const Contact& c = problem().contacts[i];
        forced.contacts.push_back(c);
        curvature.push_back(turning(i));
        before.push_back(state_.bodies.contacts().force(id_of_a(c), c.partner));
    }
    const ContactForces forces = solve_contact_forces(forced, curvature, before);
    acceleration_ = forces.accelerations;
    force_.assign(count(), 0);
    for (std::size_t i = 0, k = 0; i < count(); ++i) {
        if (!persists_[i]) continue;
        force_[i] = forces.forces[k];
        persists_[i] = force_[i] > 0 || (rate(i) <= slow_ && forces.gap_rates[k] <= softest(i));
        ++k;
    }
}

/// |w_t|^2 / (r_a + r_b), 0 at planes.
double Persistence::turning(std::size_t contact) const
{
    const Contact& c = problem().contacts[contact];
    if (c.partner.is_plane()) return 0;
    const Vec3 w = relative_velocity(contact);
    return (w - w.dot(c.normal) * c.normal).squaredNorm() /
           (state_.radius(id_of_a(c)) + state_.radius(c.partner.index));
}

/// Acceleration [length/time^2] that opens a contact by no more than its tolerance until it is asked again: at the end
/// of the run without gravity, after a step where a new one turns that meets a numeric piece. (The parabola that stands
/// for such a piece may close what its step opens.)
double Persistence::softest(std::size_t contact) const
{
    const Contact& c = problem().contacts[contact];
    double time = std::numeric_limits<double>::infinity();
    if (!(length(state_.gravity()) > 0)) time = state_.scene.end_time;
    const bool meets_piece =
        state_.bodies.is_in_piece(id_of_a(c)) || (c.partner.is_sphere() && state_.bodies.is_in_piece(c.partner.index));
    if (!c.persistent && turns(contact) && meets_piece) time = std::min(time, state_.rest.numeric_step);
    return std::max(soft_, 2 * persistence_gap(state_, id_of_a(c), c.partner) / time / time);
}

/// Takes the velocities nearest to the present ones with rate 0 in contacts that persist, and a margin above 0 in those
/// that open, so that by rounding they do not look like closing to those who predict. What cannot open, for jammed
/// bodies are in its way, persists: it opens once their motion has made room.
/// \returns whether a velocity changed by more than slow_
bool Persistence::project_velocities()
{
    const std::vector<Vec3> before = velocities_before(problem());
    std::vector<char> left(count(), 0);
    while (!take_nearest(left)) {
    }
    const std::vector<Vec3> after = velocities_before(problem());
    energy_taken_ += kinetic_energy(problem(), before) - kinetic_energy(problem(), after);
    bring_to_rest();
    for (std::size_t i = 0; i < count(); ++i)
        if (!released_[i] && is_closed(i) && rate(i) < 0) persists_[i] = 1;
    for (std::size_t k = 0; k < before.size(); ++k)
        if (length(after[k] - before[k]) > slow_) return true;
    return false;
}

/// \param left by contact: may close, for it is no contact yet, or was released and cannot open
/// \returns false where a contact cannot open, and that persists or is left alone: nothing else is changed
bool Persistence::take_nearest(std::vector<char>& left)
{
    const double scale = std::max(fastest(component_), slow_), margin = 2 * opening_speed * scale;
    ProjectionProblem nearest = projection_problem(problem());
    nearest.tolerance = opening_speed / 2 * scale;
    nearest.dependent = known_normal;
    std::vector<int> rows;
    std::vector<double> guess;
    for (std::size_t i = 0; i < count(); ++i) {
        HalfSpace& row = nearest.half_spaces[i];
        row.is_equality = persists_[i] != 0;
        if (!row.is_equality) row.offset = -margin;
        guess.push_back(slack(row, nearest.start) < 0 ? 1 : 0);
        if (!left[i]) rows.push_back(static_cast<int>(i));
    }
    const Projection found = project(nearest, rows, guess);
    std::vector<char> stuck(count(), 0);
    for (const int i : found.bound) stuck[static_cast<std::size_t>(i)] = 1;
    bool all_open = true;
    for (std::size_t i = 0; i < count(); ++i) {
        if (persists_[i] || left[i]) continue;
        if (!stuck[i] && slack(nearest.half_spaces[i], found.point) + margin > opening_speed * scale) continue;
        (is_closed(i) && !released_[i] ? persists_ : left)[i] = 1;
        all_open = false;
    }
    if (!all_open) return false;
    for (std::size_t k = 0; k < found.point.size(); ++k) velocity(k) = found.point[k];
    for (std::size_t i = 0; i < count(); ++i) impulses_[i] += found.multipliers[i];
    return true;
}

/// Speeds and accelerations that are no more than what solving leaves of 0, where contacts hold a body. (Outside heaps
/// one that a single plane holds slides on, however slowly: no solving was needed.)
void Persistence::bring_to_rest()
{
    std::vector<int> holds(problem().bodies.size(), 0);
    std::vector<char> slides(holds.size(), 0);
    for (std::size_t i = 0; i < count(); ++i) {
        if (!persists_[i]) continue;
        const auto k = static_cast<std::size_t>(a(i));
        slides[k] = ++holds[k] == 1 && problem().contacts[i].partner.is_plane() && !component_.is_heap;
        if (!b(i)) continue;
        slides[static_cast<std::size_t>(*b(i))] = 0;
        ++holds[static_cast<std::size_t>(*b(i))];
    }
    for (std::size_t k = 0; k < holds.size(); ++k) {
        if (holds[k] == 0) continue;
        if (length(acceleration_[k]) <= same_) acceleration_[k] = Vec3::Zero();
        if (!slides[k] && acceleration_[k].isZero(0) && length(velocity(k)) <= slow_) velocity(k) = Vec3::Zero();
    }
}

std::vector<Persistence::Part> Persistence::parts() const
{
    const std::size_t n = problem().bodies.size();
    DisjointSets sets(n);
    for (std::size_t i = 0; i < count(); ++i)
        if (persists_[i] && b(i)) sets.join(static_cast<std::size_t>(a(i)), static_cast<std::size_t>(*b(i)));
    std::vector<Part> out, by_smallest(n);
    for (std::size_t k = 0; k < n; ++k) by_smallest[sets.smallest(k)].bodies.push_back(k);
    for (std::size_t i = 0; i < count(); ++i)
        if (persists_[i]) by_smallest[sets.smallest(static_cast<std::size_t>(a(i)))].contacts.push_back(i);
    for (Part& part : by_smallest)
        if (!part.bodies.empty()) out.push_back(std::move(part));
    return out;
}

}  // namespace carom
