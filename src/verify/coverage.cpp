#include "verify/coverage.hpp"

#include <algorithm>
#include <array>

namespace carom::verification {

namespace {

/// Up to so many spheres all pairs cost less than looking for neighbours.
constexpr BodyId few = 40;
/// Relative to the radius: how far a persistent contact may be from closed (DESIGN, promise 2).
constexpr double contact_slack = 1e-9;
/// Of the promise for runs in doubles: 16 eps.
constexpr double promised = 16 * 2 * u;

constexpr double shortest = 0x1p-40, longest = 0x1p40;  ///< slabs [epochs]

std::uint64_t pair_key(BodyId a, BodyId b)
{
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32 | static_cast<std::uint32_t>(b);
}

bool held(Mode mode)
{
    return mode == Mode::sliding || mode == Mode::resting;
}

std::string pair_text(const RunData& data, BodyId a, BodyId b)
{
    return "sphere " + std::to_string(a) +
           (b < data.spheres() ? " and sphere " + std::to_string(b)
                               : " and plane " + std::to_string(b - data.spheres()));
}

}  // namespace

Coverage::Coverage(const RunData& data, const Flights& flights, Findings& findings, bool all_pairs)
    : data_(data), flights_(flights), findings_(findings), all_pairs_(all_pairs || data.spheres() <= few)
{
    grades_.assign(data.radii.size(), 0);
    flown_before_.assign(data.radii.size(), 0);
    if (!all_pairs_) cells_.emplace(data.radii);
    const std::int64_t n = data.spheres();
    findings.out.pairs = n * (n - 1) / 2 + n * data.planes();
}

void Coverage::worsen(BodyId body, Grade grade)
{
    std::uint8_t& now = grades_[static_cast<std::size_t>(body)];
    now = std::max(now, static_cast<std::uint8_t>(grade));
}

Coverage::Ball Coverage::ball_of(BodyId body, std::optional<Swept>& room) const
{
    const Path& path = flights_.path(body);
    if (path.mode != Mode::series) return {&path, &data_.acceleration(path), data_.radius(body), false};
    const SeriesRecord& s = flights_.series.at(body);
    const Wall& wall = data_.wall(path.support);
    room = swept(path, data_.radius(body), s, side_of(wall, path) * wall.normal, data_.index_of(s.acceleration),
                 data_.index_of(Vec3::Zero()));
    return {&room->path, &data_.accelerations[static_cast<std::size_t>(room->path.acceleration)], room->radius, true};
}

/// At most so far in this flight, or in the one before [cells].
double Coverage::flown(BodyId body, const Ball& ball, const EpochTime& to) const
{
    const double t = between<double>(ball.path->start, to);
    return std::max(flown_before_[static_cast<std::size_t>(body)],
                    t * (ball.path->velocity.norm() + t * ball.acceleration->norm()));
}

void Coverage::record(const GapFound& found, const EpochTime& from, const EpochTime& to, BodyId a, BodyId b)
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

void Coverage::pair(BodyId a, BodyId b, const EpochTime& from, const EpochTime& to)
{
    const Quick &qa = quick_[static_cast<std::size_t>(a)], &qb = quick_[static_cast<std::size_t>(b)];
    ++findings_.out.segments;
    if (qa.acceleration == qb.acceleration && qa.acceleration >= 0) {
        const double t0 = std::max({between<double>(reference_, from), qa.start, qb.start});
        const double t1 = between<double>(reference_, to), contact = data_.radius(a) + data_.radius(b);
        if (is_far(qa, qb, t0, t1, contact, interesting(contact))) return;
        return look_closer(a, b, std::max({from, flights_.path(a).start, flights_.path(b).start}), to, true);
    }
    look_closer(a, b, std::max({from, flights_.path(a).start, flights_.path(b).start}), to, false);
}

void Coverage::look_closer(BodyId a, BodyId b, const EpochTime& from, const EpochTime& to, bool is_near)
{
    if (!(from < to)) return;
    const Path &pa = flights_.path(a), &pb = flights_.path(b);
    if (pa.mode == Mode::fixed && pb.mode == Mode::fixed) return;
    std::optional<Swept> room_a, room_b;
    const Ball ball_a = ball_of(a, room_a), ball_b = ball_of(b, room_b);
    PairSegment segment{*ball_a.path, *ball_b.path, *ball_a.acceleration, *ball_b.acceleration,
                        from,         to,           ball_a.radius,        ball_b.radius,
                        nullptr,      nullptr};
    if (!overlaps_.empty())
        if (const auto found = overlaps_.find(pair_key(std::min(a, b), std::max(a, b))); found != overlaps_.end()) {
            segment.initial_a = &found->second.first;
            segment.initial_b = &found->second.second;
        }
    if (!is_near && is_clear(segment, smallest_)) return;
    const double allowed =
        promised * std::max({ball_a.radius + ball_b.radius, flown(a, ball_a, to), flown(b, ball_b, to)});
    const bool is_swept = ball_a.is_swept || ball_b.is_swept;
    GapFound found = examine(segment, data_.run.certified && !is_swept ? 0 : allowed);
    if (is_swept) {
        // The ball that a series stays in is larger than the sphere: that it touches shows nothing.
        found.measured = false;
        if (found.grade == Grade::violated) found.grade = Grade::not_certified;
    }
    record(found, from, to, std::min(a, b), std::max(a, b));
}

void Coverage::planes(BodyId body, const EpochTime& to)
{
    const Path& path = flights_.path(body);
    if (path.mode == Mode::fixed) return;
    for (int p = 0; p < data_.planes(); ++p) {
        ++findings_.out.segments;
        if (p == path.support)
            support(body, p, to);
        else
            plane(body, p, to);
    }
}

void Coverage::plane(BodyId body, int p, const EpochTime& to)
{
    const Wall& wall = data_.wall(p);
    const Quick& quick = quick_[static_cast<std::size_t>(body)];
    if (quick.acceleration >= 0 && !wall.is_plate &&
        is_far(quick, data_.acceleration(flights_.path(body)), wall.normal, wall.offset,
               between<double>(reference_, to), data_.radius(body), std::max(0.0, smallest_)))
        return;
    std::optional<Swept> room;
    const Ball ball = ball_of(body, room);
    const BodyId partner = data_.spheres() + p;
    WallSegment segment{*ball.path, *ball.acceleration, wall,   side_of(wall, *ball.path), ball.path->start,
                        to,         ball.radius,        nullptr};
    if (!overlaps_.empty())
        if (const auto found = overlaps_.find(pair_key(body, partner)); found != overlaps_.end())
            segment.initial = &found->second.first;
    if (is_clear(segment, smallest_)) return;
    const double allowed = promised * std::max(ball.radius, flown(body, ball, to));
    GapFound found = examine(segment, data_.run.certified && !ball.is_swept ? 0 : allowed);
    if (ball.is_swept) {
        found.measured = false;
        if (found.grade == Grade::violated) found.grade = Grade::not_certified;
    }
    record(found, ball.path->start, to, body, partner);
}

/// The plane that carries a body: a persistent contact stays closed, and the bounces of a series begin and end there.
void Coverage::support(BodyId body, int p, const EpochTime& to)
{
    const Path& path = flights_.path(body);
    const Wall& wall = data_.wall(p);
    const double radius = data_.radius(body);
    const BodyId partner = data_.spheres() + p;
    WallSegment segment{path, data_.acceleration(path), wall, side_of(wall, path), path.start, to, radius, nullptr};
    if (held(path.mode)) {
        const double distance = largest_distance(segment);
        if (distance > contact_slack * radius)
            findings_.violation(
                pair_text(data_, body, partner) + " are not in contact, gap " + figure(distance * data_.units.length),
                to, body, partner);
        return;
    }
    // In a series the sphere is lowest where it bounces, and it bounces where it began.
    segment.to = path.start;
    record(examine(segment, promised * std::max(radius, 1.0)), path.start, path.start, body, partner);
}

void Coverage::close(BodyId body, const EpochTime& now)
{
    const Path& path = flights_.path(body);
    if (path.start < now) {
        if (all_pairs_) {
            for (BodyId other = 0; other < data_.spheres(); ++other)
                if (other != body) pair(body, other, path.start, now);
        } else {
            const EpochTime from = std::max(path.start, slab_begin_);
            double radius = 0;
            const Box swept_box = box(body, from, now, radius);
            cells_->visit(swept_box, radius, [&](BodyId other) {
                if (other != body) pair(body, other, from, now);
            });
        }
        planes(body, now);
    }
    count(body, now);
}

void Coverage::count(BodyId body, const EpochTime& now)
{
    const Path& path = flights_.path(body);
    std::uint8_t& grade = grades_[static_cast<std::size_t>(body)];
    const double epochs = between<double>(path.start, now), seconds = epochs * data_.units.time;
    flown_before_[static_cast<std::size_t>(body)] =
        epochs * (path.velocity.norm() + epochs * data_.acceleration(path).norm());
    CertifiedSeconds& sum = findings_.out.body_seconds;
    if (path.mode == Mode::numeric) grade = static_cast<std::uint8_t>(Grade::not_certified);
    (grade == static_cast<std::uint8_t>(Grade::exact)     ? sum.exact
     : grade == static_cast<std::uint8_t>(Grade::bounded) ? sum.bounded
                                                          : sum.not_certified) += seconds;
    grade = 0;
}

void Coverage::open(BodyId body, const EpochTime& now)
{
    const Path& path = flights_.path(body);
    quick_[static_cast<std::size_t>(body)] = quick_look_at(path, data_.acceleration(path), reference_);
    if (all_pairs_) {
        // What is straight on from an old reference loses precision.
        constexpr std::size_t often = 8;
        if (++opened_ > often * quick_.size()) set_reference(now);
        return;
    }
    double radius = 0;
    const Box swept_box = box(body, now, slab_end_, radius);
    cells_->enter(body, swept_box, radius);
}

/// What the centre sweeps: between its ends, and as far beyond as an arc leaves its chord.
Box Coverage::box(BodyId body, const EpochTime& from, const EpochTime& to, double& radius) const
{
    static constexpr std::int64_t origin[3] = {0, 0, 0};
    std::optional<Swept> room;
    const Ball ball = ball_of(body, room);
    radius = ball.radius;
    const Moving<double> begin = moving<double>(*ball.path, *ball.acceleration, origin, from);
    const Moving<double> end = moving<double>(*ball.path, *ball.acceleration, origin, to);
    const Vec3 a = rounded(begin.place), b = rounded(end.place);
    const double t = between<double>(from, to);
    const Vec3 beyond =
        (0.126 * t * t) * ball.acceleration->cwiseAbs() + rounding<double> * (begin.place_size + end.place_size);
    return {a.cwiseMin(b) - beyond, a.cwiseMax(b) + beyond};
}

EpochTime Coverage::later(const EpochTime& t, double epochs) const
{
    if (epochs >= 1) return {t.epoch + static_cast<std::int64_t>(epochs), t.offset};
    const double offset = t.offset + epochs;
    return offset < 1 ? EpochTime{t.epoch, offset} : EpochTime{t.epoch + 1, offset - 1};
}

void Coverage::choose_duration()
{
    // At first: as long as it takes most spheres to sweep half a cell.
    double rate = 0;
    for (BodyId i = 0; i < data_.spheres(); ++i) {
        const Path& path = flights_.path(i);
        const double size = cells_->cell_size(i);
        rate += path.velocity.norm() / size + std::sqrt(data_.acceleration(path).norm() / size);
    }
    rate /= data_.spheres();
    int exponent = 0;
    std::frexp(rate > 0 ? 0.5 / rate : 1.0, &exponent);
    slab_ = std::ldexp(1.0, std::clamp(exponent - 1, -40, 40));
}

void Coverage::set_reference(const EpochTime& at)
{
    reference_ = at;
    opened_ = 0;
    for (BodyId i = 0; i < data_.spheres(); ++i) {
        const Path& path = flights_.path(i);
        quick_[static_cast<std::size_t>(i)] = quick_look_at(path, data_.acceleration(path), at);
    }
}

void Coverage::begin()
{
    quick_.resize(data_.radii.size());
    find_initial_overlaps();
    if (all_pairs_) return set_reference({});
    choose_duration();
    begin_slab({});
}

void Coverage::sort_bodies()
{
    std::vector<std::pair<std::array<float, 3>, BodyId>> places;
    places.reserve(order_.size());
    for (BodyId i = 0; i < data_.spheres(); ++i) {
        const Path& p = flights_.path(i);
        const double size = 2 * cells_->cell_size(i);
        std::array<float, 3> place;
        for (std::size_t k = 0; k < 3; ++k)
            place[k] = static_cast<float>(std::floor((static_cast<double>(p.cell[k]) + p.local[k]) / size));
        places.emplace_back(place, i);
    }
    std::sort(places.begin(), places.end());
    order_.clear();
    for (const auto& [place, body] : places) order_.push_back(body);
}

void Coverage::begin_slab(const EpochTime& at)
{
    constexpr std::int64_t often = 16;
    if (slabs_++ % often == 0) sort_bodies();
    slab_begin_ = at;
    slab_end_ = later(at, slab_);
    reference_ = at;
    cells_->clear();
    for (const BodyId i : order_) open(i, std::max(at, flights_.path(i).start));
    entries_at_begin_ = cells_->entries();
}

void Coverage::end_slab(const EpochTime& at)
{
    for (const BodyId i : order_) {
        const EpochTime from = std::max(slab_begin_, flights_.path(i).start);
        double radius = 0;
        const Box swept_box = box(i, from, at, radius);
        cells_->visit(swept_box, radius, [&](BodyId other) {
            if (other > i) pair(i, other, from, at);
        });
    }
}

void Coverage::advance(const EpochTime& now)
{
    if (all_pairs_) return;
    while (!(now < slab_end_)) {
        end_slab(slab_end_);
        adapt();
        begin_slab(slab_end_);
    }
    // In cells a sphere: so many new ones, and a slab has been long enough.
    constexpr double most_new = 2;
    const double fresh = static_cast<double>(cells_->entries()) - static_cast<double>(entries_at_begin_);
    if (fresh > most_new * data_.spheres() && slab_begin_ < now) {
        end_slab(now);
        slab_ = std::max(slab_ / 2, shortest);
        begin_slab(now);
    }
}

/// The next slab is longer if spheres swept few cells in the last one, shorter if many.
void Coverage::adapt()
{
    constexpr double few_cells = 1.5, many_cells = 3;
    // Absurd speeds must not make it endless: there comes a point where slabs only grow.
    constexpr std::int64_t most_slabs = 20'000;
    const double cells = static_cast<double>(entries_at_begin_) / data_.spheres();
    if (cells < few_cells || slabs_ > most_slabs + findings_.out.flights)
        slab_ = std::min(2 * slab_, longest);
    else if (cells > many_cells)
        slab_ = std::max(slab_ / 2, shortest);
}

void Coverage::finish(const EpochTime& end)
{
    advance(end);
    if (all_pairs_) {
        for (BodyId a = 0; a < data_.spheres(); ++a)
            for (BodyId b = a + 1; b < data_.spheres(); ++b) pair(a, b, {}, end);
    } else {
        end_slab(end);
    }
    for (BodyId i = 0; i < data_.spheres(); ++i) {
        if (flights_.path(i).start < end) planes(i, end);
        count(i, std::max(end, flights_.path(i).start));
    }
}

void Coverage::find_initial_overlaps()
{
    const auto overlap = [&](BodyId a, BodyId b) {
        const Path &pa = flights_.path(a), &pb = flights_.path(b);
        const PairSegment s{pa,      pb,     data_.acceleration(pa), data_.acceleration(pb),
                            {},      {},     data_.radius(a),        data_.radius(b),
                            nullptr, nullptr};
        if (is_clear(s, 0)) return;
        const GapFound found = examine(s, 0);
        if (found.grade != Grade::exact) overlaps_.try_emplace(pair_key(a, b), pa, pb);
    };
    const BodyId n = data_.spheres();
    if (all_pairs_) {
        for (BodyId a = 0; a < n; ++a)
            for (BodyId b = a + 1; b < n; ++b) overlap(a, b);
    } else {
        for (BodyId i = 0; i < n; ++i) {
            double radius = 0;
            const Box place = box(i, {}, {}, radius);
            cells_->enter(i, place, radius);
        }
        for (BodyId i = 0; i < n; ++i) {
            double radius = 0;
            const Box place = box(i, {}, {}, radius);
            cells_->visit(place, radius, [&](BodyId other) {
                if (other > i) overlap(i, other);
            });
        }
    }
    for (BodyId i = 0; i < n; ++i)
        for (int p = 0; p < data_.planes(); ++p) {
            const Path& path = flights_.path(i);
            const Wall& wall = data_.wall(p);
            const WallSegment s{path, data_.acceleration(path), wall,   side_of(wall, path), {},
                                {},   data_.radius(i),          nullptr};
            if (!is_clear(s, 0) && examine(s, 0).grade != Grade::exact)
                overlaps_.try_emplace(pair_key(i, n + p), path, path);
        }
}

}  // namespace carom::verification
