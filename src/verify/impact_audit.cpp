#include "verify/impact_audit.hpp"

#include <algorithm>

namespace carom::verification {

namespace {

constexpr double contact_slack = 1e-9;  ///< of the radius, for runs in doubles and for persistent contacts

Vec3 high(const Vector<DoubleDouble>& a)
{
    return {a.x.high, a.y.high, a.z.high};
}

DoubleDouble component(const Vector<DoubleDouble>& a, int k)
{
    return k == 0 ? a.x : k == 1 ? a.y : a.z;
}

/// A speed that could lift a ball by no more than a persistent contact may be open.
double slow(double gravity, double radius)
{
    return std::sqrt(2 * gravity * contact_slack * radius);
}

}  // namespace

ImpactAudit::ImpactAudit(const RunData& data, const Flights& flights, Findings& findings)
    : data_(data), flights_(flights), findings_(findings)
{
}

void ImpactAudit::fail(const std::string& what, BodyId a, BodyId b)
{
    findings_.violation(what, now_, a, b);
}

Before* ImpactAudit::find(BodyId body)
{
    for (Before& b : bodies_)
        if (b.body == body) return &b;
    return nullptr;
}

Before& ImpactAudit::before(BodyId body)
{
    if (Before* known = find(body)) return *known;
    Before b;
    b.body = body;
    b.path = flights_.path(body);
    const Moving<DoubleDouble> m = moving<DoubleDouble>(b.path, data_.acceleration(b.path), b.path.cell, now_);
    b.place = m.place;
    b.speed = m.speed;
    b.place_size = m.place_size;
    b.speed_size = m.speed_size;
    if (b.path.mode == Mode::series) {
        const SeriesRecord& s = flights_.series.at(body);
        b.series = s;
        const Wall& wall = data_.wall(b.path.support);
        const auto now = inside(s, side_of(wall, b.path) * wall.normal, between<double>(b.path.start, now_));
        b.follows = now.has_value();
        if (now) {
            b.place = {DoubleDouble(b.path.local[0]) + now->shift.x(), DoubleDouble(b.path.local[1]) + now->shift.y(),
                       DoubleDouble(b.path.local[2]) + now->shift.z()};
            b.speed = {now->velocity.x(), now->velocity.y(), now->velocity.z()};
        }
    }
    speeds_ += b.speed_size.norm();
    bodies_.push_back(b);
    return bodies_.back();
}

void ImpactAudit::begin(std::span<const Event> events, std::span<const FlightRecord> flights, const EpochTime& now)
{
    now_ = now;
    events_ = events;
    bodies_.clear();
    speeds_ = support_energy_ = 0;
    for (const Event& event : events) take(event);
    for (const FlightRecord& flight : flights) before(flight.body);
}

void ImpactAudit::take(const Event& event)
{
    const Vec3 impulse = event.impulse / data_.units.length * data_.units.time;
    const bool pushes = !event.impulse.isZero(0);
    Before& a = before(event.a);
    a.named = true;
    if (event.kind == EventKind::rest) a.rests = true;
    a.impulse += impulse;
    a.impulses += pushes;
    if (event.b >= data_.spheres()) return;
    Before& b = before(event.b);
    b.named = true;
    b.impulse -= impulse;
    b.impulses += pushes;
}

double ImpactAudit::inverse_mass(BodyId body) const
{
    return body >= data_.spheres() || data_.sphere(body).fixed ? 0 : 1 / data_.sphere(body).mass;
}

void ImpactAudit::change(BodyId body)
{
    Before* b = find(body);
    const Path& after = flights_.path(body);
    if (b == nullptr || b->changed) {
        fail("sphere " + std::to_string(body) + " changes its flight twice at one instant", body);
        return;
    }
    b->changed = true;
    if (!b->named && !b->series) {
        fail("sphere " + std::to_string(body) + " changes its flight without an event", body);
        return;
    }
    if (data_.sphere(body).fixed) {
        fail("sphere " + std::to_string(body) + " is fixed and moves", body);
        return;
    }
    if (!b->follows) return;
    check_place(*b, after);
    check_speed(*b, after);
}

/// A flight begins where the one before ended. A coordinate that did not move must agree to the bit.
void ImpactAudit::check_place(const Before& b, const Path& after)
{
    const double span = between<double>(b.path.start, now_) + 1;
    const bool settles = b.rests || (b.series && b.rests);
    for (int k = 0; k < 3; ++k) {
        const auto cells = static_cast<double>(after.cell[k] - b.path.cell[k]);
        const DoubleDouble x = DoubleDouble(cells) + joined<DoubleDouble>(after.local[k], after.local_low[k]);
        const double jump = std::abs((x - component(b.place, k)).high);
        double allowed = b.speed_size[k] > 0 ? tolerance() * (2 + span * b.speed_size[k]) : 0;
        if (b.series) {
            const SeriesRecord& s = *b.series;
            const double rise = s.normal_speed * (s.normal_speed / s.gravity);
            // The verifier adds bounces one by one; a rounding each.
            allowed = 1e-9 * (rise + span * (std::abs(s.velocity[k]) + span * std::abs(s.acceleration[k]))) + 64 * u;
        }
        if (settles) {
            const Path& p = after.support >= 0 ? after : b.path;
            if (p.support >= 0)
                allowed += contact_slack * data_.radius(b.body) * std::abs(data_.wall(p.support).normal[k]) +
                           (data_.wall(p.support).normal[k] != 0 ? 16 * u : 0);
        }
        if (jump > allowed) {
            fail("sphere " + std::to_string(b.body) + " jumps by " + figure(jump * data_.units.length), b.body);
            return;
        }
        if (allowed > 0) findings_.keep_largest(findings_.out.largest_jump, jump / allowed);
    }
}

void ImpactAudit::check_speed(Before& b, const Path& after)
{
    const double mass = data_.sphere(b.body).mass, radius = data_.radius(b.body);
    const double span = between<double>(b.path.start, now_) + 1;
    double attenuation = 1;
    if (events_.size() == 1 && events_[0].kind == EventKind::impact)
        attenuation = data_.law(events_[0].a, events_[0].b).attenuation;
    const int support = after.support >= 0 ? after.support : b.path.support;
    const double gravity = data_.gravity.norm();
    Vec3 unexplained;
    Vec3 allowed;
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble v = joined<DoubleDouble>(after.velocity[k], after.velocity_low[k]);
        const double push = b.impulse[k] / mass;
        DoubleDouble expected = component(b.speed, k) + DoubleDouble(push);
        allowed[k] = 8 * u * (b.speed_size[k] + std::abs(v.high) + std::abs(push));
        if (b.series) {
            const double g = data_.gravity[k];
            if (b.rests)  // the impulses of all bounces together balance gravity
                expected = DoubleDouble(b.path.velocity[k]) + DoubleDouble(span - 1) * DoubleDouble(g) + push;
            allowed[k] += 1e-9 * (std::abs(b.path.velocity[k]) + std::abs(g) * span);
        }
        unexplained[k] = (v - DoubleDouble(attenuation) * expected).high;
    }
    // What rounding leaves along a normal may be put right: that nothing closes further, that a contact persists.
    Vec3 along = Vec3::Zero();
    for (const Event& event : events_)
        if (event.a == b.body || event.b == b.body) along += event.normal.cwiseAbs();
    allowed += 16 * u * speeds_ * along;
    if (support >= 0) {
        const double lift = slow(gravity, radius);
        allowed += (lift + 16 * u * speeds_) * data_.wall(support).normal.cwiseAbs();
        const Vec3& n = data_.wall(support).normal;
        support_energy_ += mass * std::abs(unexplained.dot(n)) * speeds_;
    }
    for (int k = 0; k < 3; ++k) {
        if (std::abs(unexplained[k]) <= allowed[k]) continue;
        fail("the speed of sphere " + std::to_string(b.body) + " changes by " +
                 figure(unexplained[k] * data_.units.length / data_.units.time) + " beside its impulses",
             b.body);
        return;
    }
    if (support >= 0 || b.series) return;  // residues of persistent contacts are not roundings
    if (speeds_ > 0)
        findings_.keep_largest(findings_.out.largest_impulse_error, unexplained.cwiseAbs().maxCoeff() / speeds_);
}

Vec3 ImpactAudit::speed_before(BodyId body)
{
    const Before* b = find(body);
    return b == nullptr ? Vec3(Vec3::Zero()) : high(b->speed);
}

Vec3 ImpactAudit::speed_after(BodyId body) const
{
    return body >= data_.spheres() ? Vec3(Vec3::Zero()) : flights_.path(body).velocity;
}

/// Where it happens: the spheres touch, and the normal is the line of their centres.
void ImpactAudit::check_contact(const Event& event)
{
    const Before& a = *find(event.a);
    Vec3 normal;
    double gap = 0, size = 1, travel = 0, shake = 0;
    const double span_a = between<double>(a.path.start, now_);
    travel = span_a * a.speed_size.norm();
    const double radius =
        event.b < data_.spheres() ? std::min(data_.radius(event.a), data_.radius(event.b)) : data_.radius(event.a);
    if (event.b >= data_.spheres()) {
        const int p = event.b - data_.spheres();
        const Wall& wall = data_.wall(p);
        const double side = side_of(wall, a.path);
        normal = side * wall.normal;
        const WallSegment s{a.path, data_.acceleration(a.path), wall, side, now_, now_, data_.radius(event.a), nullptr};
        gap = a.series ? 0 : height(s, now_).high;
        size = data_.radius(event.a);
    } else {
        const Before& b = *find(event.b);
        travel = std::max(travel, between<double>(b.path.start, now_) * b.speed_size.norm());
        Vector<DoubleDouble> r{};
        DoubleDouble* const parts[] = {&r.x, &r.y, &r.z};
        for (int k = 0; k < 3; ++k)
            *parts[k] = DoubleDouble(static_cast<double>(a.path.cell[k] - b.path.cell[k])) +
                        (component(a.place, k) - component(b.place, k));
        const DoubleDouble distance = sqrt(dot(r, r));
        size = data_.radius(event.a) + data_.radius(event.b);
        gap = (distance - joined<DoubleDouble>(data_.radius(event.a), 0) - DoubleDouble(data_.radius(event.b))).high;
        normal = high(r) / distance.high;
        shake = (2 + travel) / size;
    }
    const bool precise = data_.run.certified && event.kind == EventKind::impact && events_.size() == 1;
    const double allowed = precise ? 64 * u * std::max(travel, size) : contact_slack * radius;
    const std::string who = "sphere " + std::to_string(event.a);
    if (!(std::abs(gap) <= allowed))
        fail(who + " is pushed at a gap of " + figure(gap * data_.units.length), event.a, event.b);
    findings_.keep_largest(findings_.out.largest_impact_gap, std::abs(gap) * data_.units.length);
    if (!((normal - event.normal).cwiseAbs().maxCoeff() <= 32 * u * (1 + shake)))
        fail(who + " is pushed along a wrong normal", event.a, event.b);
    if (event.kind != EventKind::impact) return;
    const double w = normal.dot(speed_before(event.a) - speed_before(event.b));
    const double after = normal.dot(speed_after(event.a) - speed_after(event.b));
    const double slack = 64 * u * speeds_ * (1 + shake);
    if (!event.impulse.isZero(0) && !(w <= slack)) fail(who + " is pushed though it was not closing", event.a, event.b);
    if (!(after >= -slack)) fail(who + " closes further after its impact", event.a, event.b);
    const int impulses = std::max(a.impulses, event.b < data_.spheres() ? find(event.b)->impulses : 0);
    if (impulses <= 1 && !a.series) check_law(event, normal, data_.law(event.a, event.b));
}

/// The impulse of a contact alone: -(1 + e) m w n - (1 - alpha) m v_t, m the reduced mass (course handout).
void ImpactAudit::check_law(const Event& event, const Vec3& normal, const ContactLaw& law)
{
    const double mass = 1 / (inverse_mass(event.a) + inverse_mass(event.b));
    const Vec3 relative = speed_before(event.a) - speed_before(event.b);
    const double w = relative.dot(normal) / normal.squaredNorm();
    const Vec3 along = relative - w * normal;
    Vec3 expected = -mass * ((1 + law.restitution) * std::min(w, 0.0) * normal);
    if (w < 0) expected -= mass * (1 - law.tangential) * along;
    const Vec3 impulse = event.impulse / data_.units.length * data_.units.time;
    const Before& a = *find(event.a);
    double shake = 1;
    if (event.b < data_.spheres()) {
        const double size = data_.radius(event.a) + data_.radius(event.b);
        const double spans =
            std::max(between<double>(a.path.start, now_) * a.speed_size.norm(),
                     between<double>(find(event.b)->path.start, now_) * find(event.b)->speed_size.norm());
        shake += (2 + spans) / size;
    }
    const double error = (impulse - expected).cwiseAbs().maxCoeff(), scale = mass * speeds_;
    if (!(error <= 64 * u * shake * scale))
        fail("an impulse on sphere " + std::to_string(event.a) + " is not that of its contact, by " +
                 figure(error / scale),
             event.a, event.b);
    if (scale > 0) findings_.keep_largest(findings_.out.largest_law_error, error / scale);
}

/// What is left over in the sums over all bodies of the instant.
void ImpactAudit::check_energy()
{
    double change = 0, energy = 0, momenta = 0, expected = 0;
    Vec3 momentum = Vec3::Zero();
    bool single = events_.size() == 1 && events_[0].kind == EventKind::impact, plain = true;
    for (const Before& b : bodies_) {
        if (!b.changed || b.series || !b.follows) {
            plain = plain && b.path.mode == Mode::fixed;
            continue;
        }
        const Path& after = flights_.path(b.body);
        const double m = data_.sphere(b.body).mass;
        const Vec3 v0 = high(b.speed), v1 = after.velocity;
        DoubleDouble twice(0.0);
        for (int k = 0; k < 3; ++k) {
            const DoubleDouble w = joined<DoubleDouble>(after.velocity[k], after.velocity_low[k]);
            const DoubleDouble difference = w - component(b.speed, k);
            twice = twice + difference * (w + component(b.speed, k));
            momentum[k] += m * (difference.high - b.impulse[k] / m);
        }
        change += m * twice.high / 2;
        energy += m * (v0.squaredNorm() + v1.squaredNorm() + b.speed_size.squaredNorm()) / 2;
        momenta += m * (v0.norm() + v1.norm() + b.speed_size.norm());
        if (after.support >= 0 || b.path.support >= 0) plain = false;
    }
    if (!plain || events_.empty()) return;
    const ContactLaw law = single ? data_.law(events_[0].a, events_[0].b) : ContactLaw{};
    if (law.attenuation != 1) return;
    const double slack = 64 * u * energy + support_energy_;
    if (single) {
        const Vec3 relative = speed_before(events_[0].a) - speed_before(events_[0].b);
        const Vec3& n = events_[0].normal;
        const double w = std::min(0.0, relative.dot(n)), t = w < 0 ? (relative - relative.dot(n) * n).squaredNorm() : 0;
        const double mass = 1 / (inverse_mass(events_[0].a) + inverse_mass(events_[0].b));
        expected =
            -mass / 2 * ((1 - law.restitution * law.restitution) * w * w + (1 - law.tangential * law.tangential) * t);
        if (!(std::abs(change - expected) <= slack))
            fail("the energy of an impact does not balance, by " + figure((change - expected) / energy), events_[0].a,
                 events_[0].b);
        if (energy > 0)
            findings_.keep_largest(findings_.out.largest_energy_error, std::abs(change - expected) / energy);
    } else if (!(change <= slack)) {
        fail("impacts at one instant gain energy, " + figure(change / energy), events_[0].a, events_[0].b);
    }
    const double left = momentum.cwiseAbs().maxCoeff();
    if (!(left <= 64 * u * momenta))
        fail("the momentum of an impact does not balance, by " + figure(left / momenta), events_[0].a, events_[0].b);
    if (momenta > 0) findings_.keep_largest(findings_.out.largest_momentum_error, left / momenta);
}

void ImpactAudit::end()
{
    for (const Before& b : bodies_)
        if (b.named && !b.changed && !data_.sphere(b.body).fixed)
            fail("sphere " + std::to_string(b.body) + " has an event and no new flight", b.body);
    for (const Event& event : events_) {
        findings_.out.impulses += !event.impulse.isZero(0);
        if (event.kind == EventKind::impact) check_contact(event);
    }
    check_energy();
}

}  // namespace carom::verification
