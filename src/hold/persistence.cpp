#include "hold/persistence.hpp"

#include "contact/contact_forces.hpp"
#include "contact/contact_problem.hpp"
#include "contact/equalise.hpp"
#include "hold/tolerances.hpp"
#include "impact/operators.hpp"
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
      gravity_(state.gravity()),
      slow_(state.tolerances.slow(fastest(component_))),
      soft_(state.tolerances.acceleration),
      released_(component_.problem.contacts.size(), 0),
      impulses_(component_.problem.contacts.size(), 0)
{
    choose_candidates();
    find_forces();
    std::vector<char> opens(count(), 0);
    let_open(opens);
    if (stop_closing()) {  // normals turn at other rates now
        find_forces();
        let_open(opens);
    }
    push_apart(std::move(opens));
    open_what_closes();
    bring_to_rest();
    hold_pressed();
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

void Persistence::release(std::vector<char> opens)
{
    for (std::size_t i = 0; i < count(); ++i) {
        if (!opens[i]) continue;
        persists_[i] = 0;
        released_[i] = 1;
    }
    push_apart(std::move(opens));
    open_what_closes();
    hold_pressed();
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

void Persistence::choose_candidates()
{
    const bool loses = loses_energy();
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
    return std::sqrt(2 * length(gravity_) * state_.lowest_bounce(radius));
}

/// Whether bounces of the component get lower and lower.
bool Persistence::loses_energy() const
{
    return state_.scene.rest.policy == RestPolicy::contact &&
           std::any_of(problem().contacts.begin(), problem().contacts.end(),
                       [](const Contact& c) { return c.restitution < 1; });
}

/// What persists neither opens nor closes from here on: what is left of its speed goes.
/// \returns whether there was any
bool Persistence::stop_closing()
{
    std::vector<double> wanted(count(), 0);
    bool some = false;
    for (std::size_t i = 0; i < count(); ++i) {
        if (!persists_[i]) continue;
        wanted[i] = -rate(i);
        some = some || std::abs(wanted[i]) > slow_;
    }
    const double before = kinetic_energy();
    equalise(persists_, wanted);
    energy_taken_ += before - kinetic_energy();
    return some;
}

/// Gap rates of some contacts change as wanted, by impulses along their normals.
void Persistence::equalise(const std::vector<char>& which, const std::vector<double>& wanted)
{
    std::vector<double> changes;
    for (std::size_t i = 0; i < count(); ++i)
        if (which[i]) changes.push_back(wanted[i]);
    if (changes.empty()) return;
    const EqualisingChange change = equalising_change(with_contacts(which), changes);
    for (std::size_t k = 0; k < change.change.size(); ++k) velocity(k) += change.change[k];
    for (std::size_t i = 0, n = 0; i < count(); ++i)
        if (which[i]) impulses_[i] += change.impulses[n++];
}

double Persistence::kinetic_energy() const
{
    return carom::kinetic_energy(problem(), velocities_before(problem()));
}

/// The component with some of its contacts.
ContactProblem Persistence::with_contacts(const std::vector<char>& which) const
{
    ContactProblem out{problem().bodies, {}};
    for (std::size_t i = 0; i < count(); ++i)
        if (which[i]) out.contacts.push_back(problem().contacts[i]);
    return out;
}

void Persistence::find_forces()
{
    force_.assign(count(), 0);
    opening_.assign(count(), 0);
    acceleration_.assign(problem().bodies.size(), gravity_);
    ContactProblem forced = with_contacts(persists_);
    if (forced.contacts.empty()) return;
    for (ContactBody& body : forced.bodies) body.velocity = gravity_;
    std::vector<double> curvature;
    for (std::size_t i = 0; i < count(); ++i)
        if (persists_[i]) curvature.push_back(turning(i));
    const ContactForces forces = solve_contact_forces(forced, curvature, forces_before());
    acceleration_ = forces.accelerations;
    for (std::size_t i = 0, k = 0; i < count(); ++i) {
        if (!persists_[i]) continue;
        force_[i] = forces.forces[k];
        opening_[i] = forces.gap_rates[k];
        ++k;
    }
}

/// Of the candidates, as they were when their bodies last changed.
std::vector<double> Persistence::forces_before() const
{
    std::vector<double> out;
    for (std::size_t i = 0; i < count(); ++i) {
        const Contact& c = problem().contacts[i];
        if (persists_[i]) out.push_back(state_.bodies.contacts().force(id_of_a(c), c.partner));
    }
    return out;
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

/// \param opens by contact: it opens, from speed 0
void Persistence::let_open(std::vector<char>& opens)
{
    for (std::size_t i = 0; i < count(); ++i) {
        if (!persists_[i] || force_[i] > 0) continue;
        const bool opens_already = rate(i) > slow_;
        opens[i] = !opens_already && opening_[i] > softest(i);
        if (opens[i] || opens_already) persists_[i] = false;
    }
}

/// What opens a contact less than this does not open it. Without gravity: by less than its tolerance until the end of
/// the run. Where one that has just closed meets a numeric piece, and turns: by less than that within a step, after
/// which it is asked again. (The parabola that stands for such a piece may close what its step opens.)
double Persistence::softest(std::size_t contact) const
{
    const Contact& c = problem().contacts[contact];
    double time = std::numeric_limits<double>::infinity();
    if (!(length(gravity_) > 0)) time = state_.scene.end_time;
    const bool meets_piece =
        state_.bodies.is_in_piece(id_of_a(c)) || (c.partner.is_sphere() && state_.bodies.is_in_piece(c.partner.index));
    if (!c.persistent && turns(contact) && meets_piece) time = std::min(time, state_.rest.numeric_step);
    return std::max(soft_, 2 * persistence_gap(state_, id_of_a(c), c.partner) / time / time);
}

/// Contacts open from speed 0; by rounding that must not look like closing to those who predict. What cannot open,
/// because jammed bodies are in its way, persists: it opens once their motion has made room. If it is open by the
/// height of a slow rebound it may go on to close.
void Persistence::push_apart(std::vector<char> opens)
{
    const double enough = opening_speed * std::max(fastest(component_), slow_);
    std::vector<char> left(count(), 0);
    for (bool goes_on = true; goes_on;) {
        const std::vector<ContactBody> bodies = problem().bodies;
        const std::vector<double> impulses = impulses_;
        if (push(opens, left, enough)) return;
        goes_on = false;
        for (std::size_t i = 0; i < count(); ++i) {
            if (!opens[i] || released_[i] || rate(i) > enough) continue;
            (is_closed(i) ? persists_ : left)[i] = 1;
            opens[i] = 0;
            goes_on = true;
        }
        if (!goes_on) return;
        component_.problem.bodies = bodies;
        impulses_ = impulses;
    }
}

/// \param opens by contact; those that others make close again join, but for those \param left alone
/// \returns whether all open at `enough` or faster
bool Persistence::push(std::vector<char>& opens, const std::vector<char>& left, double enough)
{
    std::vector<char> moved(count(), 0);
    double margin = 2 * enough;
    for (int n = 0; n < most_pushes && margin <= std::max(slow_, 4 * enough); ++n, margin *= 2) {
        bool all_open = true;
        std::vector<double> wanted(count(), 0);
        for (std::size_t i = 0; i < count(); ++i) {
            const double c = rate(i);
            if (!persists_[i] && !left[i] && c < 0) opens[i] = 1;
            moved[i] = opens[i] || persists_[i];
            if (!moved[i]) continue;
            wanted[i] = opens[i] ? std::max(margin - c, 0.0) : -c;
            if (opens[i] && !(c > enough)) all_open = false;
        }
        if (all_open) return true;
        equalise(moved, wanted);
        follow_planes();
    }
    return false;
}

/// By body, the number of contacts that persist.
std::vector<int> Persistence::holds() const
{
    std::vector<int> held(problem().bodies.size(), 0);
    for (std::size_t i = 0; i < count(); ++i) {
        if (!persists_[i]) continue;
        ++held[static_cast<std::size_t>(a(i))];
        if (b(i)) ++held[static_cast<std::size_t>(*b(i))];
    }
    return held;
}

/// Who leans on one plane only goes along it, whatever pushes.
void Persistence::follow_planes()
{
    const std::vector<int> held = holds();
    for (std::size_t i = 0; i < count(); ++i) {
        const Contact& c = problem().contacts[i];
        const auto k = static_cast<std::size_t>(a(i));
        if (!persists_[i] || !c.partner.is_plane() || held[k] > 1) continue;
        Vec3& v = velocity(k);
        if (std::abs(rate(i)) > normal_speed_rounding * length(v)) v -= (rate(i) / c.normal.squaredNorm()) * c.normal;
    }
}

/// Where jammed bodies cannot have the rates that were wanted, some contacts still close: a last inelastic impact.
void Persistence::open_what_closes()
{
    std::vector<char> closed(count(), 0);
    bool some = false;
    for (std::size_t i = 0; i < count(); ++i) {
        closed[i] = is_closed(i);
        some = some || (closed[i] && rate(i) < -slow_);
    }
    if (!some) return;
    const double before = kinetic_energy();
    const ContactProblem cluster = with_contacts(closed);
    const NormalImpact impact = inelastic(cluster);
    std::vector<Vec3> pushes;
    for (std::size_t n = 0; n < cluster.contacts.size(); ++n)
        pushes.push_back(impact.impulses[n] * cluster.contacts[n].normal);
    const std::vector<Vec3> after = velocities_after(cluster, velocities_before(cluster), pushes);
    for (std::size_t k = 0; k < after.size(); ++k) velocity(k) = after[k];
    for (std::size_t i = 0, n = 0; i < count(); ++i) {
        if (!closed[i]) continue;
        impulses_[i] += impact.impulses[n++];
        if (rate(i) > slow_) persists_[i] = 0;
    }
    energy_taken_ += before - kinetic_energy();
}

/// Speeds and accelerations that are no more than what solving leaves of 0, where contacts hold a body. (Outside heaps
/// one that a single plane holds slides on, however slowly: no solving was needed.)
void Persistence::bring_to_rest()
{
    const std::vector<int> held = holds();
    std::vector<char> slides(held.size(), 0);
    for (std::size_t i = 0; i < count() && !component_.is_heap; ++i)
        if (persists_[i] && problem().contacts[i].partner.is_plane())
            slides[static_cast<std::size_t>(a(i))] = held[static_cast<std::size_t>(a(i))] == 1;
    for (std::size_t k = 0; k < held.size(); ++k) {
        if (held[k] == 0) continue;
        Vec3 &v = velocity(k), &acceleration = acceleration_[k];
        if (length(acceleration) <= same_) acceleration = Vec3::Zero();
        if (slides[k]) continue;
        if (acceleration.isZero(0) && length(v) <= slow_) v = Vec3::Zero();
    }
}

/// A closed contact that still closes, slowly: because jammed bodies cannot open it, or by the rounding in the speed of
/// one that has come to rest. It persists, though it carries nothing. (If it were left alone it would close at this
/// very instant, again and again.)
void Persistence::hold_pressed()
{
    for (std::size_t i = 0; i < count(); ++i) {
        const double c = rate(i);
        if (!persists_[i] && !released_[i] && c < 0 && c >= -slow_ && is_closed(i)) persists_[i] = 1;
    }
}

std::vector<std::vector<std::size_t>> Persistence::parts() const
{
    const std::size_t n = problem().bodies.size();
    DisjointSets sets(n);
    for (std::size_t i = 0; i < count(); ++i)
        if (persists_[i] && b(i)) sets.join(static_cast<std::size_t>(a(i)), static_cast<std::size_t>(*b(i)));
    std::vector<std::vector<std::size_t>> out, by_smallest(n);
    for (std::size_t k = 0; k < n; ++k) by_smallest[sets.smallest(k)].push_back(k);
    for (auto& part : by_smallest)
        if (!part.empty()) out.push_back(std::move(part));
    return out;
}

std::vector<std::vector<std::size_t>> Persistence::contacts_of(const std::vector<std::vector<std::size_t>>& parts) const
{
    std::vector<std::size_t> part_of(problem().bodies.size());
    for (std::size_t p = 0; p < parts.size(); ++p)
        for (const std::size_t k : parts[p]) part_of[k] = p;
    std::vector<std::vector<std::size_t>> out(parts.size());
    for (std::size_t i = 0; i < count(); ++i)
        if (persists_[i]) out[part_of[static_cast<std::size_t>(a(i))]].push_back(i);
    return out;
}

}  // namespace carom
