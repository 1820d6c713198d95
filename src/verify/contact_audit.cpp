#include "verify/contact_audit.hpp"

#include "verify/gaps.hpp"

#include <algorithm>

namespace carom::verification {

namespace {

/// Of the speeds of the bodies that impulses connect: what a solver may leave.
constexpr double solved = 1e-9;

bool is_push(const Event& event)
{
    return event.kind == EventKind::impact || event.kind == EventKind::settle;
}

std::uint64_t pair_key(BodyId a, BodyId b)
{
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32 | static_cast<std::uint32_t>(b);
}

}  // namespace

ContactAudit::ContactAudit(const RunData& data, const Flights& flights, Coverage& coverage, Findings& findings)
    : data_(data), flights_(flights), coverage_(coverage), findings_(findings)
{
}

void ContactAudit::check(InstantBodies& bodies, std::span<const Event> events)
{
    bodies_ = &bodies;
    events_ = events;
    several_ = std::count_if(events.begin(), events.end(),
                             [](const Event& event) { return event.kind == EventKind::impact; }) > 1;
    largest_restitution_ = data_.is_micro() ? 1 : 0;
    if (several_)
        for (const Event& event : events)
            if (event.kind == EventKind::impact)
                largest_restitution_ = std::max(largest_restitution_, data_.law(event.a, event.b).restitution);
    holds_ =
        std::any_of(events.begin(), events.end(), [](const Event& event) { return event.kind == EventKind::settle; });
    closes_ = holds_ && std::any_of(events.begin(), events.end(), [&](const Event& event) {
                  const Vec3 relative = bodies.speed_before(event.a) - bodies.speed_before(event.b);
                  return is_push(event) && event.normal.dot(relative) < -bodies.settling();
              });
    for (const Event& event : events) {
        count(event);
        if (is_push(event) || (event.kind != EventKind::guard && event.b < data_.spheres())) check_event(event);
    }
    for (const Before& b : bodies.all()) add_up(b);
    const Event* alone = events.size() == 1 && events[0].kind == EventKind::impact ? &events[0] : nullptr;
    Group all;
    for (const Group& group : bodies.groups()) {
        if (group.impulses > 0 && !group.loose) check_group(group, alone);
        all.loose = all.loose || group.loose;
        all.supported = all.supported || group.supported;
        all.change += group.change;
        all.energy += group.energy;
    }
    // What persistence takes beside the impulses it takes from the energy of all.
    if (all.supported && !all.loose && !(all.change <= solved * all.energy))
        fail("an instant gains energy, " + figure(all.change / all.energy), events.empty() ? no_body : events[0].a);
    for (const Event& event : events)
        if (event.kind == EventKind::impact) remember(event);
}

void ContactAudit::count(const Event& event)
{
    Certificate& out = findings_.out;
    out.impulses += !event.impulse.isZero(0);
    const bool spheres = event.b >= 0 && event.b < data_.spheres();
    out.rests_on_spheres += event.kind == EventKind::rest && spheres;
    out.releases_of_spheres += event.kind == EventKind::release && spheres;
    out.guards += event.kind == EventKind::guard;
    out.settles += event.kind == EventKind::settle;
}

ContactAudit::Geometry ContactAudit::geometry(const Event& event)
{
    const Before& a = *bodies_->find(event.a);
    Geometry out;
    out.travel = flown(a);
    out.size = data_.radius(event.a);
    if (event.b >= data_.spheres()) {
        const Wall& wall = data_.wall(event.b - data_.spheres());
        const double side = side_of(wall, a.path);
        out.normal = side * wall.normal;
        const Vec3 acceleration = data_.acceleration(a.path);
        const WallSegment s{a.path, acceleration, wall, side, bodies_->now(), bodies_->now(), out.size, nullptr};
        out.gap = a.series ? 0 : height(s, bodies_->now()).high;
        return out;
    }
    const Before& b = *bodies_->find(event.b);
    out.travel = std::max(out.travel, flown(b));
    Vector<DoubleDouble> r{};
    DoubleDouble* const parts[] = {&r.x, &r.y, &r.z};
    for (int k = 0; k < 3; ++k)
        *parts[k] = DoubleDouble(static_cast<double>(a.path.cell[k] - b.path.cell[k])) +
                    (component(a.place, k) - component(b.place, k));
    const DoubleDouble distance = sqrt(dot(r, r));
    out.size += data_.radius(event.b);
    out.gap = (distance - joined<DoubleDouble>(data_.radius(event.a), 0) - DoubleDouble(data_.radius(event.b))).high;
    out.normal = high(r) / distance.high;
    out.shake = (2 + out.travel) / out.size;
    return out;
}

/// Way of the flight that ends, at most [cells].
double ContactAudit::flown(const Before& b) const
{
    const double time = between<double>(b.path.start, bodies_->now());
    if (!(b.path.drag > 0)) return time * b.speed_size.norm();
    return longest_way(b.path, data_.acceleration(b.path), time).norm();
}

double ContactAudit::smaller_radius(const Event& event) const
{
    const double radius = data_.radius(event.a);
    return event.b < data_.spheres() ? std::min(radius, data_.radius(event.b)) : radius;
}

/// Where it happens: the spheres touch, and the normal is the line of their centres.
void ContactAudit::check_event(const Event& event)
{
    const Geometry at = geometry(event);
    const Before& a = *bodies_->find(event.a);
    const Before* b = event.b < data_.spheres() ? bodies_->find(event.b) : nullptr;
    const Group& group = bodies_->group_of(bodies_->inverse_mass(event.a) > 0 || b == nullptr ? a : *b);
    const double radius = smaller_radius(event);
    const bool precise =
        data_.run.certified && event.kind == EventKind::impact && group.impulses == 1 && !group.coupled;
    const bool numeric = a.path.mode == Mode::numeric || (b && b->path.mode == Mode::numeric);
    const bool was_numeric = coverage_.was_numeric(event.a) || (b && coverage_.was_numeric(event.b));
    // What closes next is pushed with what has closed: open by a tie, never overlapping by one.
    const double closed = is_push(event) && at.gap > 0 ? std::max(contact_slack, data_.run.tie) : contact_slack;
    double allowed = precise ? 64 * u * std::max(at.travel, at.size)
                             : (numeric || (was_numeric && at.gap < 0) ? deepest_numeric : closed) * radius;
    // Within the height of the rebounds that count as none.
    if (is_push(event) && !data_.run.certified && closed_a_moment_ago(event))
        allowed += data_.closing_speed * data_.window / 4;
    const std::string who = "sphere " + std::to_string(event.a);
    if (!(std::abs(at.gap) <= allowed))
        fail(who + " is pushed at a gap of " + figure(at.gap * data_.units.length), event.a, event.b);
    if (!numeric && !(was_numeric && at.gap < 0))
        Findings::keep_largest(findings_.out.largest_impact_gap, std::abs(at.gap) * data_.units.length);
    if (!((at.normal - event.normal).cwiseAbs().maxCoeff() <= (numeric ? 1e-2 : 32 * u * (1 + at.shake))))
        fail(who + " is pushed along a wrong normal", event.a, event.b);
    if (event.kind == EventKind::impact) check_impulse(event, at, group);
    if (event.kind == EventKind::settle) check_hold(event, at, group);
}

/// A contact that is pulled opened slower than v_c and persists. (Unless a contact of the instant closed: what it
/// pushed may have made others slower. Its own impulse may be a pull in the end, all in all.)
void ContactAudit::check_hold(const Event& event, const Geometry& at, const Group& group)
{
    const std::string who = "sphere " + std::to_string(event.a);
    const Vec3& n = group.loose ? event.normal : at.normal;
    const double before = n.dot(bodies_->speed_before(event.a) - bodies_->speed_before(event.b));
    const double after = n.dot(bodies_->speed_after(event.a) - bodies_->speed_after(event.b));
    const double slack =
        (64 * u * (1 + at.shake) + (group.loose ? 1e-2 : solved)) * bodies_->speeds() + bodies_->settling();
    if (!closes_ && !(before <= data_.closing_speed + slack))
        fail(who + " is held though it leaves at " + figure(before * data_.units.length / data_.units.time), event.a,
             event.b);
    const auto is_released = [&] {  // at the same instant: it was found to open at once
        return std::any_of(events_.begin(), events_.end(), [&](const Event& e) {
            return e.kind == EventKind::release && e.a == event.a && e.b == event.b;
        });
    };
    if (!(std::abs(after) <= slack) && !(after > 0 && is_released()))
        fail(who + " is held and moves on nevertheless", event.a, event.b);
}

void ContactAudit::check_impulse(const Event& event, const Geometry& at, const Group& group)
{
    const std::string who = "sphere " + std::to_string(event.a);
    const Vec3& n = group.loose ? event.normal : at.normal;  // where it was is known roughly only
    const double w = n.dot(bodies_->speed_before(event.a) - bodies_->speed_before(event.b));
    const double after = n.dot(bodies_->speed_after(event.a) - bodies_->speed_after(event.b));
    const double strict = 64 * u * bodies_->speeds() * (1 + at.shake);
    const double slack = group.coupled ? strict + solved * bodies_->speeds() + bodies_->settling() : strict;
    if (!group.coupled && !group.loose && !event.impulse.isZero(0) && !(w <= slack))
        fail(who + " is pushed though it was not closing", event.a, event.b);
    // Open by the height of a slow rebound, a contact may go on to close where jammed bodies are in its way.
    const bool is_open =
        data_.is_lossy && at.gap > contact_slack * smaller_radius(event) && -after <= data_.closing_speed;
    if (!(after >= -slack) && !(group.settles > 0 && is_open))
        fail(who + " closes further after its impact", event.a, event.b);
    if (!(event.impulse.dot(event.normal) >= -64 * u * event.impulse.norm()) && group.coupled)
        fail(who + " is pulled", event.a, event.b);
    if (group.impulses + group.settles <= 1 && !group.loose) restitution_ = check_law(event, at.normal, group);
}

/// The impulse of a contact alone: -(1 + e) m w n - (1 - alpha) m v_t, m the reduced mass (docs/impacts.md, section 1).
double ContactAudit::check_law(const Event& event, const Vec3& normal, const Group& group)
{
    const ContactLaw law = data_.law(event.a, event.b);
    const double mass = 1 / (bodies_->inverse_mass(event.a) + bodies_->inverse_mass(event.b));
    const Vec3 relative = bodies_->speed_before(event.a) - bodies_->speed_before(event.b);
    const double w = relative.dot(normal) / normal.squaredNorm(), speeds = bodies_->speeds();
    const Vec3 impulse = event.impulse / data_.units.length * data_.units.time;
    // So slow a closing may be none.
    if (group.coupled && -w <= bodies_->settling() && impulse.norm() <= 4 * mass * bodies_->settling())
        return law.restitution;
    const auto error = [&](double restitution) {
        Vec3 expected = -mass * ((1 + restitution) * std::min(w, 0.0) * normal);
        if (w < 0) expected -= mass * (1 - law.tangential) * (relative - w * normal);
        return (impulse - expected).cwiseAbs().maxCoeff();
    };
    double shake = 1;
    if (event.b < data_.spheres()) {
        const Before &a = *bodies_->find(event.a), &b = *bodies_->find(event.b);
        shake += (2 + std::max(flown(a), flown(b))) / (data_.radius(event.a) + data_.radius(event.b));
    }
    constexpr double margin = 1 + 1e-9;
    double used = law.restitution, found = error(used);
    // Below a minimal speed the bounces of the rest policy micro lose nothing.
    if (data_.is_micro() && -w < margin * data_.closing_speed &&
        (margin * -w < data_.closing_speed || error(1) < found)) {
        used = 1;
        found = error(1);
    }
    if (may_be_inelastic(event, -w) && error(0) < found) {
        found = error(0);
        used = 0;
    }
    // A rebound slower than v_c may be held, all of it or in part. (A sphere alone on a plane sums its bounces: it
    // rests without an impact at that instant.)
    const auto is_held = [&](BodyId body) {
        const int support = body < data_.spheres() ? flights_.path(body).support : -1;
        const Before* before = support >= 0 ? bodies_->find(body) : nullptr;
        return support == several_supports || (before && (group.coupled || before->rests));
    };
    const auto is_supported = [&](BodyId body) {
        return body < data_.spheres() && bodies_->find(body)->path.support != -1;
    };
    const bool slow = -law.restitution * w <= margin * data_.closing_speed;
    // And impacts of one instant, which contacts without an impulse may connect, share one restitution.
    const auto allow_less = [&] {
        const double measured = -impulse.dot(normal) / (mass * w * normal.squaredNorm()) - 1;
        const double within = std::clamp(measured, 0.0, std::max(law.restitution, largest_restitution_));
        if (!(error(within) < found)) return;
        found = error(within);
        used = within;
    };
    if (data_.is_lossy && w < 0 && (several_ || (slow && (is_held(event.a) || is_held(event.b))))) allow_less();
    const double scale = mass * speeds;
    double allowed = 64 * u * shake * scale;
    if (group.coupled) allowed += solved * scale + mass * bodies_->settling();
    // A solver may have found it, for contacts beside it that got no impulse worth an event.
    else if (data_.is_lossy && bodies_->knows_several_contacts())
        allowed += solved * scale + (is_supported(event.a) || is_supported(event.b) ? mass * bodies_->settling() : 0);
    // Who is jammed cannot rebound, though others get no impulse.
    if (!(found <= allowed) && w < 0 && (is_jammed(event.a, normal) || is_jammed(event.b, -normal))) allow_less();
    if (!(found <= allowed))
        fail("an impulse on sphere " + std::to_string(event.a) + " is not that of its contact, by " +
                 figure(found / scale),
             event.a, event.b);
    if (scale > 0) Findings::keep_largest(findings_.out.largest_law_error, found / scale);
    return used;
}

/// Is something in the way of a sphere that is pushed so?
bool ContactAudit::is_jammed(BodyId body, const Vec3& push)
{
    constexpr double against = -1e-8;  // narrow wedges take many rounds of an operator, which then meets its bound
    if (body >= data_.spheres()) return false;
    const double rebound = data_.is_lossy ? data_.closing_speed * data_.window / 4 : 0;
    const std::vector<Vec3> normals = coverage_.closed_normals(body, bodies_->now(), rebound);
    return std::any_of(normals.begin(), normals.end(), [&](const Vec3& n) { return n.dot(push) < against; });
}

/// Inelastic impacts (docs/impacts.md, section 4): slow closings, and those of contacts that closed a moment ago,
/// unless all e = 1.
bool ContactAudit::may_be_inelastic(const Event& event, double closing) const
{
    constexpr double margin = 1 + 1e-9;
    if (!data_.is_lossy || data_.is_micro()) return false;
    return closing <= margin * data_.closing_speed || closed_a_moment_ago(event);
}

bool ContactAudit::closed_a_moment_ago(const Event& event) const
{
    constexpr double margin = 1 + 1e-9;
    const auto last = closed_.find(pair_key(event.a, event.b));
    return last != closed_.end() && between<double>(last->second, bodies_->now()) <= margin * data_.window;
}

void ContactAudit::remember(const Event& event)
{
    if (!data_.is_lossy || !(data_.window > 0)) return;
    if (closed_.size() >= most_closed_) {
        std::erase_if(closed_, [&](const auto& entry) {
            return between<double>(entry.second, bodies_->now()) > 2 * data_.window;
        });
        most_closed_ = std::max(most_closed_, 2 * closed_.size());
    }
    closed_[pair_key(event.a, event.b)] = bodies_->now();
}

/// What is left over in the sums over all bodies of a group.
void ContactAudit::add_up(const Before& b)
{
    Group& group = bodies_->group_of(b);
    if (group.loose || !b.changed) return;
    const Path after = flights_.path(b.body);
    const double m = data_.sphere(b.body).mass;
    const Vec3 v0 = high(b.speed), v1 = after.velocity;
    DoubleDouble twice(0.0);
    Vec3 left;
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble w = joined<DoubleDouble>(after.velocity[k], after.velocity_low[k]);
        const DoubleDouble difference = w - component(b.speed, k);
        twice = twice + difference * (w + component(b.speed, k));
        left[k] = difference.high - b.impulse[k] / m;
    }
    group.momentum += m * left;
    group.mass += m;
    group.change += m * twice.high / 2;
    group.energy += m * (v0.squaredNorm() + v1.squaredNorm() + b.speed_size.squaredNorm()) / 2;
    group.momenta += m * (v0.norm() + v1.norm() + b.speed_size.norm()) + b.pushes;
    // What persistent contacts take beside the impulses was looked at body by body; it may add to the energy of none.
    if (after.support == -1 && b.path.support == -1) return;
    group.supported = true;
    group.swallowed += m * left.norm() * (v0.norm() + v1.norm());
}

void ContactAudit::check_group(const Group& group, const Event* alone)
{
    findings_.out.clusters += group.impulses > 1;
    const bool plain = !group.supported && !group.coupled && group.impulses == 1 && alone != nullptr;
    const ContactLaw law = alone != nullptr ? data_.law(alone->a, alone->b) : ContactLaw{};
    if (law.attenuation != 1) return;
    // Slow changes of speed may have no impulse that connects them with whoever made them.
    const double slow = group.coupled ? bodies_->settling() : 0;
    const double slack = 64 * u * group.energy + group.swallowed + (group.coupled ? hidden * group.energy : 0) +
                         group.mass * slow * slow;
    double expected = 0;
    // Where contacts are held, what connects a group with others may be pulled back as it was pushed, without an event:
    // there the energy of all is looked at.
    if (plain) {
        const Vec3 relative = bodies_->speed_before(alone->a) - bodies_->speed_before(alone->b);
        const Vec3& n = alone->normal;
        const double w = std::min(0.0, relative.dot(n)), t = w < 0 ? (relative - relative.dot(n) * n).squaredNorm() : 0;
        const double mass = 1 / (bodies_->inverse_mass(alone->a) + bodies_->inverse_mass(alone->b));
        expected = -mass / 2 * ((1 - restitution_ * restitution_) * w * w + (1 - law.tangential * law.tangential) * t);
        if (!(std::abs(group.change - expected) <= slack))
            fail("the energy of an impact does not balance, by " + figure((group.change - expected) / group.energy),
                 group.first, group.second);
        if (group.energy > 0)
            Findings::keep_largest(findings_.out.largest_energy_error,
                                   std::abs(group.change - expected) / group.energy);
    } else if (!holds_ && !(group.change <= slack)) {
        fail("impacts at one instant gain energy, " + figure(group.change / group.energy), group.first, group.second);
    }
    if (group.supported || group.coupled) return;  // of each body by itself: check_speed
    const double left = group.momentum.cwiseAbs().maxCoeff();
    // A solver that has several impulses to find leaves out those that are nothing beside the others.
    double allowed = 64 * u * group.momenta;
    const auto touches_others = [&] { return coverage_.closed_normals(group.first, bodies_->now()).size() > 1; };
    if (several_ || (left > allowed && touches_others())) allowed += hidden * group.mass * bodies_->speeds();
    if (!(left <= allowed))
        fail("the momentum of an impact does not balance, by " + figure(left / group.momenta), group.first,
             group.second);
    if (group.momenta > 0) Findings::keep_largest(findings_.out.largest_momentum_error, left / group.momenta);
}

}  // namespace carom::verification
