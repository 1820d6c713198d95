#include "verify/instant_bodies.hpp"

#include <algorithm>

namespace carom::verification {

namespace {

/// So many are found faster one by one.
constexpr std::size_t few = 8;

bool is_coupled(const Path& path)
{
    return path.support == several_supports || path.mode == Mode::numeric;
}

}  // namespace

Before* InstantBodies::find(BodyId body)
{
    if (bodies_.size() > few) {
        const auto found = places_.find(body);
        return found == places_.end() ? nullptr : &bodies_[found->second];
    }
    for (Before& b : bodies_)
        if (b.body == body) return &b;
    return nullptr;
}

Before& InstantBodies::before(BodyId body)
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
    stirred_ = stirred_ || b.path.mode == Mode::numeric;
    coupled_ = coupled_ || is_coupled(b.path);
    speeds_ += b.speed_size.norm();
    bodies_.push_back(b);
    if (bodies_.size() == few + 1)
        for (std::size_t i = 0; i < few; ++i) places_[bodies_[i].body] = i;
    if (bodies_.size() > few) places_[body] = bodies_.size() - 1;
    return bodies_.back();
}

void InstantBodies::begin(std::span<const Event> events, std::span<const FlightRecord> flights, const EpochTime& now)
{
    now_ = now;
    bodies_.clear();
    places_.clear();
    groups_.clear();
    speeds_ = 0;
    stirred_ = !events.empty() || now == EpochTime{};  // contacts of the start persist without a word
    coupled_ = events.size() > 1;
    for (const Event& event : events) take(event);
    for (const FlightRecord& flight : flights) {
        // Of a contact that is resolved with the others the impulse may be too small for an event.
        if (!before(flight.body).named && !events.empty()) coupled_ = true;
    }
    seen_ = seen_ || coupled_;
}

void InstantBodies::take(const Event& event)
{
    const Vec3 impulse = event.impulse / data_.units.length * data_.units.time;
    const auto add = [&](BodyId body, const Vec3& push) {
        Before& b = before(body);
        b.named = true;
        if (event.kind == EventKind::rest) {
            b.rests = true;
            b.sums_bounces = b.sums_bounces || !push.isZero(0);
        }
        b.impulse += push;
        b.pushes += push.norm();
        b.impulses += !push.isZero(0);
    };
    add(event.a, impulse);
    if (event.b >= 0 && event.b < data_.spheres()) add(event.b, -impulse);
}

std::size_t InstantBodies::root(std::size_t i)
{
    while (bodies_[i].group != i) i = bodies_[i].group = bodies_[bodies_[i].group].group;
    return i;
}

void InstantBodies::connect(std::span<const Event> events)
{
    for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].group = i;
    const auto place = [&](BodyId body) { return static_cast<std::size_t>(find(body) - bodies_.data()); };
    const auto moves = [&](BodyId body) { return body >= 0 && inverse_mass(body) > 0; };
    for (const Event& e : events)
        if (!e.impulse.isZero(0) && moves(e.a) && moves(e.b)) {
            const std::size_t a = root(place(e.a)), b = root(place(e.b));
            bodies_[std::max(a, b)].group = std::min(a, b);
        }
    groups_.assign(bodies_.size(), {});
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        Before& b = bodies_[i];
        b.group = root(i);
        Group& group = groups_[b.group];
        group.speeds += b.speed_size.norm();
        const Path after = flights_.path(b.body);
        group.coupled = group.coupled || is_coupled(b.path) || is_coupled(after);
        group.loose = group.loose || b.series || !b.follows || b.path.mode == Mode::numeric || after.guarded;
    }
    for (const Event& e : events) {
        if (e.impulse.isZero(0) || (e.kind != EventKind::impact && e.kind != EventKind::settle)) continue;
        Group& group = groups_[bodies_[place(moves(e.a) ? e.a : e.b)].group];
        if (e.kind == EventKind::settle) {
            ++group.settles;
            group.coupled = true;
            continue;
        }
        if (group.impulses++ == 0) {
            group.first = e.a;
            group.second = e.b;
        }
        group.coupled = group.coupled || group.impulses > 1;
    }
}

double InstantBodies::inverse_mass(BodyId body) const
{
    return body >= data_.spheres() || data_.sphere(body).fixed ? 0 : 1 / data_.sphere(body).mass;
}

Vec3 InstantBodies::speed_before(BodyId body)
{
    const Before* b = find(body);
    return b == nullptr ? Vec3(Vec3::Zero()) : high(b->speed);
}

Vec3 InstantBodies::speed_after(BodyId body) const
{
    return body >= data_.spheres() ? Vec3(Vec3::Zero()) : flights_.path(body).velocity;
}

}  // namespace carom::verification
