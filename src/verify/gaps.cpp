#include "verify/gaps.hpp"

#include <algorithm>

namespace carom::verification {

namespace {

/// Causes that may have left a body in an overlap: Gaps::past_.
enum LeftBy : std::uint8_t { left_by_nothing, left_by_contacts, left_by_numeric };

std::uint64_t pair_key(BodyId a, BodyId b)
{
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32 | static_cast<std::uint32_t>(b);
}

/// Or never moves.
bool flies(const Path& path)
{
    return path.mode == Mode::flying || path.mode == Mode::fixed;
}

}  // namespace

std::string pair_text(const RunData& data, BodyId a, BodyId b)
{
    return "sphere " + std::to_string(a) +
           (b < data.spheres() ? " and sphere " + std::to_string(b)
                               : " and plane " + std::to_string(b - data.spheres()));
}

Gaps::Gaps(const RunData& data, const Flights& flights, Findings& findings)
    : data_(data), flights_(flights), findings_(findings)
{
    grades_.assign(data.run.spheres.size(), 0);
    flown_before_.assign(data.run.spheres.size(), 0);
    past_.assign(data.run.spheres.size(), left_by_nothing);
}

void Gaps::worsen(BodyId body, Grade grade)
{
    std::uint8_t& now = grades_[static_cast<std::size_t>(body)];
    now = std::max(now, static_cast<std::uint8_t>(grade));
}

/// At most so far in this flight, or in the one before [cells].
double Gaps::flown(BodyId body, const Ball& ball, const EpochTime& to) const
{
    const double t = between<double>(ball.path.start, to);
    return std::max(static_cast<double>(flown_before_[static_cast<std::size_t>(body)]),
                    lasting(ball.path, t) * (ball.path.velocity.norm() + t * ball.acceleration.norm()));
}

void Gaps::record(const GapFound& found, const EpochTime& from, const EpochTime& to, BodyId a, BodyId b)
{
    Certificate& out = findings_.out;
    if (found.level == Level::double_double) ++out.needed_double_double;
    if (found.level == Level::exact) ++out.needed_exact;
    const EpochTime& when = found.at_start ? from : to;
    if (found.measured && found.gap < smallest_) {
        smallest_ = found.gap;
        out.smallest_gap = found.gap * data_.units.length;
        out.smallest_gap_time = data_.units.seconds(when);
    }
    if (found.grade == Grade::violated)
        findings_.violation(pair_text(data_, a, b) + " overlap, gap " + figure(found.gap * data_.units.length), when, a,
                            b);
    worsen(a, found.grade);
    if (b < data_.spheres()) worsen(b, found.grade);
}

void Gaps::judge_numeric(GapFound& found, bool guarded, double radius)
{
    if (found.gap < -(guarded ? deepest_guarded : deepest_numeric) * radius) return;
    found.grade = Grade::measured;
    Certificate& out = findings_.out;
    Findings::keep_largest(guarded ? out.guarded_depth : out.numeric_depth, -found.gap * data_.units.length);
}

template <class Again, class Start>
void Gaps::judge(GapFound& found, BodyId a, BodyId b, double radius, const Again& again, const Start& gap_at_start)
{
    if (found.grade <= Grade::bounded || !found.measured) return;
    const Path pa = flights_.path(a), pb = flights_.path(b);
    if (pa.mode == Mode::numeric || pb.mode == Mode::numeric)
        return judge_numeric(found, pa.guarded || pb.guarded, radius);
    const std::uint8_t past = std::max(past_[static_cast<std::size_t>(a)], past_[static_cast<std::size_t>(b)]);
    const bool held = is_held_by_several(pa) || is_held_by_several(pb);
    if (!held && past == left_by_nothing) return;
    const GapFound loose = again(contact_slack * radius);
    // A released contact is as deep as it was held, and goes no deeper.
    const bool deepens = found.gap < gap_at_start() - deepening * radius;
    if (loose.grade <= Grade::bounded && (held || !deepens))
        found.grade = Grade::in_contact;
    else if (past == left_by_numeric && (held || !deepens))
        judge_numeric(found, false, radius);
}

void Gaps::pair(BodyId a, BodyId b, const EpochTime& from, const EpochTime& to, bool is_near)
{
    const Ball ball_a = ball_of(data_, flights_, a), ball_b = ball_of(data_, flights_, b);
    if (ball_a.path.mode == Mode::fixed && ball_b.path.mode == Mode::fixed) return;
    PairSegment segment{ball_a.path, ball_b.path, ball_a.acceleration, ball_b.acceleration,
                        from,        to,          ball_a.radius,       ball_b.radius,
                        nullptr,     nullptr};
    if (!overlaps_.empty())
        if (const auto found = overlaps_.find(pair_key(std::min(a, b), std::max(a, b))); found != overlaps_.end()) {
            segment.initial_a = &found->second.first;
            segment.initial_b = &found->second.second;
        }
    if (!is_near && is_clear(segment, smallest_)) return;
    const double allowed =
        promised * std::max({ball_a.radius + ball_b.radius, flown(a, ball_a, to), flown(b, ball_b, to)});
    const bool is_swept = ball_a.is_swept || ball_b.is_swept;
    // Double-double is for free flight, and for what it has in common with a partner.
    const bool exact =
        data_.run.certified && flies(ball_a.path) && flies(ball_b.path) && ball_a.acceleration == ball_b.acceleration;
    GapFound found = examine(segment, exact ? 0 : allowed);
    if (is_swept) {
        // The ball that a series stays in is larger than the sphere: that it touches shows nothing.
        found.measured = false;
        if (found.grade == Grade::violated) found.grade = Grade::not_certified;
    }
    const auto start = [&] {
        const Relative<DoubleDouble> r =
            relative<DoubleDouble>(ball_a.path, ball_a.acceleration, ball_b.path, ball_b.acceleration, from);
        return (sqrt(dot(r.r, r.r)) - DoubleDouble(ball_a.radius) - DoubleDouble(ball_b.radius)).high;
    };
    judge(
        found, a, b, std::min(ball_a.radius, ball_b.radius), [&](double bound) { return examine(segment, bound); },
        start);
    record(found, from, to, std::min(a, b), std::max(a, b));
}

void Gaps::plane(BodyId body, int p, const EpochTime& to)
{
    const Ball ball = ball_of(data_, flights_, body);
    if (p == ball.path.support) return support(body, flights_.path(body), p, to);
    const Wall& wall = data_.wall(p);
    const BodyId partner = data_.spheres() + p;
    WallSegment segment{ball.path, ball.acceleration, wall,   side_of(wall, ball.path), ball.path.start,
                        to,        ball.radius,       nullptr};
    if (!overlaps_.empty())
        if (const auto found = overlaps_.find(pair_key(body, partner)); found != overlaps_.end())
            segment.initial = &found->second.first;
    if (is_clear(segment, smallest_)) return;
    const double allowed = promised * std::max(ball.radius, flown(body, ball, to));
    GapFound found = examine(segment, data_.run.certified && flies(ball.path) ? 0 : allowed);
    if (ball.is_swept) {
        found.measured = false;
        if (found.grade == Grade::violated) found.grade = Grade::not_certified;
    }
    judge(
        found, body, body, ball.radius, [&](double bound) { return examine(segment, bound); },
        [&] { return height(segment, segment.from).high; });
    record(found, ball.path.start, to, body, partner);
}

/// The plane that carries a body: a persistent contact stays closed, and the bounces of a series begin and end there.
void Gaps::support(BodyId body, const Path& path, int p, const EpochTime& to)
{
    const Wall& wall = data_.wall(p);
    const double radius = data_.radius(body);
    const BodyId partner = data_.spheres() + p;
    const Vec3 acceleration = data_.acceleration(path);
    WallSegment segment{path, acceleration, wall, side_of(wall, path), path.start, to, radius, nullptr};
    if (is_held(path)) {
        const double distance = largest_distance(segment);
        if (was_numeric(body) && distance <= deepest_numeric * radius && height(segment, path.start).high < 0)
            Findings::keep_largest(findings_.out.numeric_depth, distance * data_.units.length);
        else if (distance > contact_slack * radius)
            findings_.violation(
                pair_text(data_, body, partner) + " are not in contact, gap " + figure(distance * data_.units.length),
                to, body, partner);
        return;
    }
    // In a series the sphere is lowest where it bounces, and it bounces where it began.
    segment.to = path.start;
    record(examine(segment, promised * std::max(radius, 1.0)), path.start, path.start, body, partner);
}

void Gaps::count(BodyId body, const EpochTime& now)
{
    const Path path = flights_.path(body);
    const double epochs = between<double>(path.start, now), seconds = epochs * data_.units.time;
    flown_before_[static_cast<std::size_t>(body)] = static_cast<float>(
        lasting(path, epochs) * (path.velocity.norm() + epochs * data_.acceleration(path).norm()) * float_rounded_up);
    std::uint8_t& past = past_[static_cast<std::size_t>(body)];
    if (path.mode == Mode::numeric)
        past = left_by_numeric;
    else if (past == left_by_nothing && is_held(path))
        past = left_by_contacts;
    std::uint8_t& kept = grades_[static_cast<std::size_t>(body)];
    const auto grade = static_cast<Grade>(kept);
    kept = 0;
    CertifiedSeconds& sum = findings_.out.body_seconds;
    if (path.guarded)
        sum.guarded += seconds;
    else if (path.mode == Mode::numeric || grade == Grade::measured)
        sum.numeric += seconds;
    else
        (grade == Grade::exact        ? sum.exact
         : grade == Grade::bounded    ? sum.bounded
         : grade == Grade::in_contact ? sum.in_contact
                                      : sum.not_certified) += seconds;
}

bool Gaps::was_numeric(BodyId body) const
{
    return past_[static_cast<std::size_t>(body)] == left_by_numeric;
}

void Gaps::note_overlap(BodyId a, BodyId b)
{
    const Path pa = flights_.path(a), pb = flights_.path(b);
    const Vec3 acceleration_a = data_.acceleration(pa), acceleration_b = data_.acceleration(pb);
    const PairSegment s{pa,      pb,     acceleration_a, acceleration_b, {}, {}, data_.radius(a), data_.radius(b),
                        nullptr, nullptr};
    if (is_clear(s, 0)) return;
    if (examine(s, 0).grade != Grade::exact) overlaps_.try_emplace(pair_key(a, b), pa, pb);
}

void Gaps::note_overlap_with_plane(BodyId body, int p)
{
    const Path path = flights_.path(body);
    const Wall& wall = data_.wall(p);
    const Vec3 acceleration = data_.acceleration(path);
    const WallSegment s{path, acceleration, wall, side_of(wall, path), {}, {}, data_.radius(body), nullptr};
    if (!is_clear(s, 0) && examine(s, 0).grade != Grade::exact)
        overlaps_.try_emplace(pair_key(body, data_.spheres() + p), path, path);
}

}  // namespace carom::verification
