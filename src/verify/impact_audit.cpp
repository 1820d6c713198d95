#include "verify/impact_audit.hpp"

#include "verify/gaps.hpp"

#include <algorithm>

namespace carom::verification {

namespace {

/// A speed that could lift a ball by no more than a persistent contact may be open.
double slow(double gravity, double radius)
{
    return std::sqrt(2 * gravity * contact_slack * radius);
}

/// Of the radius: what cannot be the error of a numeric step.
constexpr double largest_numeric_jump = 1e-2;

}  // namespace

ImpactAudit::ImpactAudit(const RunData& data, const Flights& flights, Coverage& coverage, Findings& findings)
    : data_(data),
      flights_(flights),
      coverage_(coverage),
      findings_(findings),
      bodies_(data, flights),
      contacts_(data, flights, coverage, findings)
{
}

void ImpactAudit::begin(std::span<const Event> events, std::span<const FlightRecord> flights, const EpochTime& now)
{
    events_ = events;
    bodies_.begin(events, flights, now);
}

/// While something happens, who was close by may begin a new flight, too: its place and speed are looked at all the
/// same.
bool ImpactAudit::is_excused(const Before& b) const
{
    return b.series || b.path.mode == Mode::numeric || bodies_.is_stirred();
}

void ImpactAudit::change(BodyId body)
{
    Before* b = bodies_.find(body);
    const Path after = flights_.path(body);
    const std::string who = "sphere " + std::to_string(body);
    if (b != nullptr && b->changed && after.guarded) return;  // the guard takes over what has just begun
    if (b == nullptr || b->changed) return fail(who + " changes its flight twice at one instant", body);
    b->changed = true;
    if (!b->named && !is_excused(*b)) return fail(who + " changes its flight without an event", body);
    if (data_.sphere(body).fixed) return fail(who + " is fixed and moves", body);
    if (!b->follows) return;
    check_place(*b, after);
    check_speed(*b, after);
}

/// A flight begins where the one before ended. A coordinate that did not move must agree to the bit.
void ImpactAudit::check_place(const Before& b, const Path& after)
{
    const double span = between<double>(b.path.start, bodies_.now()) + 1;
    const Vec3 way = longest_way(b.path, data_.acceleration(b.path), span);
    const bool is_numeric = b.path.mode == Mode::numeric;
    // Who leaves free flight, or meets several at once, goes on from a place in doubles, also in certified runs.
    const double* const low = after.local_low;
    const bool is_plain = low[0] == 0 && low[1] == 0 && low[2] == 0;
    for (int k = 0; k < 3; ++k) {
        const auto cells = static_cast<double>(after.cell[k] - b.path.cell[k]);
        const DoubleDouble x = DoubleDouble(cells) + joined<DoubleDouble>(after.local[k], after.local_low[k]);
        const double jump = std::abs((x - component(b.place, k)).high);
        double allowed = b.speed_size[k] > 0 ? (is_plain ? 16 * u : tolerance()) * (2 + way[k]) : 0;
        if (b.series) {
            const SeriesRecord& s = *b.series;
            const double rise = s.normal_speed * (s.normal_speed / s.gravity);
            // The verifier adds bounces one by one; a rounding each.
            allowed = 1e-9 * (rise + span * (std::abs(s.velocity[k]) + span * std::abs(s.acceleration[k]))) + 64 * u;
        }
        if (b.rests) {
            const Path& p = after.support >= 0 ? after : b.path;
            if (p.support >= 0)
                allowed += contact_slack * data_.radius(b.body) * std::abs(data_.wall(p.support).normal[k]) +
                           (data_.wall(p.support).normal[k] != 0 ? 16 * u : 0);
        }
        if (is_numeric) allowed += largest_numeric_jump * data_.radius(b.body);
        if (jump > allowed)
            return fail("sphere " + std::to_string(b.body) + " jumps by " + figure(jump * data_.units.length), b.body);
        if (is_numeric)
            Findings::keep_largest(findings_.out.largest_numeric_jump, jump * data_.units.length);
        else if (allowed > 0)
            Findings::keep_largest(findings_.out.largest_jump, jump / allowed);
    }
}

void ImpactAudit::check_speed(const Before& b, const Path& after)
{
    const double mass = data_.sphere(b.body).mass, radius = data_.radius(b.body);
    const double span = between<double>(b.path.start, bodies_.now()) + 1;
    double attenuation = 1;
    if (events_.size() == 1 && events_[0].kind == EventKind::impact)
        attenuation = data_.law(events_[0].a, events_[0].b).attenuation;
    const int support = after.support >= 0 ? after.support : b.path.support;
    const bool several = b.path.support == several_supports || after.support == several_supports;
    Vec3 unexplained;
    Vec3 allowed;
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble v = joined<DoubleDouble>(after.velocity[k], after.velocity_low[k]);
        const double push = b.impulse[k] / mass;
        DoubleDouble expected = component(b.speed, k) + DoubleDouble(push);
        allowed[k] = 8 * u * (b.speed_size[k] + std::abs(v.high) + std::abs(push));
        if (b.series) {
            const double g = data_.gravity[k];
            if (b.sums_bounces)  // and together they balance gravity
                expected = DoubleDouble(b.path.velocity[k]) + DoubleDouble(span - 1) * DoubleDouble(g) + push;
            allowed[k] += 1e-9 * (std::abs(b.path.velocity[k]) + std::abs(g) * span);
        }
        unexplained[k] = (v - DoubleDouble(attenuation) * expected).high;
        // What is resolved together, if only for being slow, knows no attenuation.
        if (const double without = (v - expected).high; several && std::abs(without) < std::abs(unexplained[k]))
            unexplained[k] = without;
    }
    // Where no closed form stood for what happened, and where the guard's straight line does, speeds jump.
    if (b.path.mode == Mode::numeric || after.guarded) {
        const double kick = unexplained.norm() * data_.units.length / data_.units.time;
        return Findings::keep_largest(findings_.out.largest_numeric_kick, kick);
    }
    // What rounding leaves along a normal may be put right: that nothing closes further, that a contact persists.
    Vec3 along = Vec3::Zero();
    for (const Event& event : events_)
        if (event.a == b.body || event.b == b.body) along += event.normal.cwiseAbs();
    allowed += 16 * u * bodies_.speeds() * along;
    // A solver has found them, if not here then where the scene begins with contacts that are closed.
    const bool begins = bodies_.now() == EpochTime{};
    if (bodies_.knows_several_contacts() || begins || several)
        allowed.array() += hidden * (b.pushes / mass + bodies_.speeds());
    if (several || bodies_.has_several_contacts()) allowed.array() += bodies_.settling();
    if (support >= 0) {
        const Vec3& n = data_.wall(support).normal;
        const double absorbed = data_.is_lossy && bodies_.has_several_contacts() ? data_.closing_speed : 0;
        allowed += (slow(data_.gravity.norm(), radius) + absorbed + 16 * u * bodies_.speeds()) * n.cwiseAbs();
    }
    const auto is_explained = [&] { return (unexplained.array().abs() <= allowed.array()).all(); };
    // Contacts that closed without an impulse worth an event, seldom: the others are only then looked for.
    if (!is_explained() && unexplained.cwiseAbs().maxCoeff() <= 64 * u * bodies_.speeds())
        for (const Vec3& n : coverage_.closed_normals(b.body, bodies_.now()))
            allowed += 16 * u * bodies_.speeds() * n.cwiseAbs();
    for (int k = 0; k < 3; ++k)
        if (!(std::abs(unexplained[k]) <= allowed[k]))
            return fail("the speed of sphere " + std::to_string(b.body) + " changes by " +
                            figure(unexplained[k] * data_.units.length / data_.units.time) + " beside its impulses",
                        b.body);
    if (several)
        Findings::keep_largest(findings_.out.largest_absorbed,
                               unexplained.norm() * data_.units.length / data_.units.time);
    if (support >= 0 || several || b.series) return;  // residues of persistent contacts are not roundings
    if (bodies_.speeds() > 0)
        Findings::keep_largest(findings_.out.largest_impulse_error,
                               unexplained.cwiseAbs().maxCoeff() / bodies_.speeds());
}

void ImpactAudit::end()
{
    for (const Before& b : bodies_.all()) {
        if (!b.named || b.changed || data_.sphere(b.body).fixed) continue;
        // Who rests on, in the same contacts, needs no new flight: the impulses balance.
        if (b.path.mode == Mode::resting && b.path.support == several_supports)
            check_speed(b, b.path);
        else
            fail("sphere " + std::to_string(b.body) + " has an event and no new flight", b.body);
    }
    bodies_.connect(events_);
    contacts_.check(bodies_, events_);
}

}  // namespace carom::verification
