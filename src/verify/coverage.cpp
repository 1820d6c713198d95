#include "verify/coverage.hpp"

#include "verify/cone.hpp"

#include <algorithm>

namespace carom::verification {

namespace {

std::vector<double> radii_of(const RunData& data)
{
    std::vector<double> radii;
    radii.reserve(data.run.spheres.size());
    for (BodyId i = 0; i < data.spheres(); ++i) radii.push_back(data.radius(i));
    return radii;
}

}  // namespace

Coverage::Coverage(const RunData& data, const Flights& flights, Findings& findings, Patience& patience, bool all_pairs)
    : data_(data),
      flights_(flights),
      findings_(findings),
      patience_(patience),
      gaps_(data, flights, findings),
      all_pairs_(all_pairs || data.spheres() <= all_pairs_up_to)
{
    if (!all_pairs_) cells_.emplace(radii_of(data));
    const std::int64_t n = data.spheres();
    findings.out.pairs = n * (n - 1) / 2 + n * data.planes();
}

void Coverage::pair(BodyId a, BodyId b, const EpochTime& from, const EpochTime& to)
{
    const Quick &qa = quick_[static_cast<std::size_t>(a)], &qb = quick_[static_cast<std::size_t>(b)];
    ++findings_.out.segments;
    patience_.lasts_for(1);
    const bool comparable = qa.acceleration == qb.acceleration && qa.acceleration >= 0;
    if (comparable) {
        const double t0 = std::max({between<double>(reference_, from), qa.start, qb.start});
        const double t1 = between<double>(reference_, to), contact = data_.radius(a) + data_.radius(b);
        if (is_far(qa, qb, t0, t1, contact, interesting(contact))) return;
    }
    const EpochTime begin = std::max({from, flights_.start(a), flights_.start(b)});
    if (begin < to) gaps_.pair(a, b, begin, to, comparable);
}

void Coverage::planes(BodyId body, const EpochTime& to)
{
    const Path path = flights_.path(body);
    if (path.mode == Mode::fixed) return;
    const Quick& quick = quick_[static_cast<std::size_t>(body)];
    for (int p = 0; p < data_.planes(); ++p) {
        ++findings_.out.segments;
        const Wall& wall = data_.wall(p);
        if (p != path.support && quick.acceleration >= 0 && !wall.is_plate &&
            is_far(quick, data_.acceleration(path), wall.normal, wall.offset, between<double>(reference_, to),
                   data_.radius(body), std::max(0.0, gaps_.smallest())))
            continue;
        gaps_.plane(body, p, to);
    }
}

template <class Visit>
void Coverage::visit(BodyId body, const EpochTime& from, const EpochTime& to, const Visit& visit)
{
    if (all_pairs_) {
        for (BodyId other = 0; other < data_.spheres(); ++other)
            if (other != body) visit(other);
        return;
    }
    double radius = 0;
    const Box swept_box = box(body, from, to, radius);
    cells_->visit(swept_box, radius, [&](BodyId other) {
        if (other != body) visit(other);
    });
}

void Coverage::close(BodyId body, const EpochTime& now)
{
    const EpochTime& start = flights_.start(body);
    note_step(body, now);
    if (start < now) {
        const EpochTime from = all_pairs_ ? start : std::max(start, slab_begin_);
        visit(body, from, now, [&](BodyId other) { pair(body, other, from, now); });
        planes(body, now);
        check_support(body, now, Edge::ends);
    }
    gaps_.count(body, now);
}

void Coverage::note_step(BodyId body, const EpochTime& now)
{
    if (flights_.path(body).mode != Mode::numeric) return;
    longest_step_ = std::max(longest_step_, between<double>(flights_.start(body), now));
}

void Coverage::check_support(BodyId body, const EpochTime& now, Edge edge)
{
    const Path path = flights_.path(body);
    if (!is_held_by_several(path)) return;
    const Vec3 acceleration = data_.acceleration(path), push = acceleration - data_.gravity;
    const double pull = data_.gravity.norm();
    double enough = no_push * pull;
    if (push.norm() <= enough) return;
    std::vector<Vec3> normals;
    const auto add = [&](const Vec3& r, double sum, double gap, double size) {
        const double distance = r.norm();
        if (distance - sum > gap + touch_rounding * size) return false;
        normals.push_back(r / distance);
        return true;
    };
    visit(body, now, now, [&](BodyId other) {
        const Path theirs = flights_.path(other);
        const Relative<double> r = relative<double>(path, acceleration, theirs, data_.acceleration(theirs), now);
        const double ra = data_.radius(body), rb = data_.radius(other);
        const bool rough = path.mode == Mode::numeric || theirs.mode == Mode::numeric;
        const double slack = rough ? deepest_numeric : 2 * contact_slack;
        const bool touches = add(rounded(r.r), ra + rb, slack * std::min(ra, rb), r.r_error.sum() / rounding<double>);
        if (touches && rough && edge == Edge::ends) {
            const double turns = rounded(r.v).norm() * longest_step_ / (ra + rb);
            enough = std::max(enough, (turned_in_a_step + turns) * pull);
        }
    });
    for (int p = 0; p < data_.planes(); ++p) {
        const Wall& wall = data_.wall(p);
        const double side = side_of(wall, path), radius = data_.radius(body);
        const WallSegment s{path, acceleration, wall, side, now, now, radius, nullptr};
        const double slack = path.mode == Mode::numeric ? deepest_numeric : 2 * contact_slack;
        if (height(s, now).high <= slack * radius) normals.push_back(side * wall.normal);
    }
    if (!is_in_cone(normals, push, enough))
        findings_.violation("sphere " + std::to_string(body) + " is held by contacts that cannot push it so", now,
                            body);
}

std::vector<Vec3> Coverage::closed_normals(BodyId body, const EpochTime& now, double gap)
{
    const Path path = flights_.path(body);
    const Vec3 acceleration = data_.acceleration(path);
    const double radius = data_.radius(body);
    std::vector<Vec3> out;
    visit(body, now, now, [&](BodyId other) {
        const Path theirs = flights_.path(other);
        const Vec3 r = rounded(relative<double>(path, acceleration, theirs, data_.acceleration(theirs), now).r);
        const double reach = radius + data_.radius(other), distance = r.norm();
        if (std::abs(distance - reach) <= gap + contact_slack * std::min(radius, data_.radius(other)))
            out.push_back(r / distance);
    });
    for (int p = 0; p < data_.planes(); ++p) {
        const Wall& wall = data_.wall(p);
        const double side = side_of(wall, path);
        const WallSegment s{path, acceleration, wall, side, now, now, radius, nullptr};
        if (std::abs(height(s, now).high) <= gap + contact_slack * radius) out.push_back(side * wall.normal);
    }
    return out;
}

void Coverage::open(BodyId body, const EpochTime& now)
{
    const Path path = flights_.path(body);
    quick_[static_cast<std::size_t>(body)] = quick_look_at(path, data_.acceleration(path), reference_);
    if (all_pairs_) {
        // A straight path loses precision with the distance from its reference.
        if (++opened_ > flights_a_reference * quick_.size()) set_reference(now);
        return;
    }
    double radius = 0;
    const Box swept_box = box(body, now, slab_end_, radius);
    cells_->enter(body, swept_box, radius);
}

/// Box that the centre sweeps: between its ends, and as far beyond as an arc leaves its chord.
Box Coverage::box(BodyId body, const EpochTime& from, const EpochTime& to, double& radius) const
{
    static constexpr std::int64_t origin[3] = {0, 0, 0};
    const Ball ball = ball_of(data_, flights_, body);
    radius = ball.radius;
    const Moving<double> begin = moving<double>(ball.path, ball.acceleration, origin, from);
    const Moving<double> end = moving<double>(ball.path, ball.acceleration, origin, to);
    const Vec3 a = rounded(begin.place), b = rounded(end.place);
    const double t = between<double>(from, to);
    const Vec3 beyond = (arc_over_chord * t * t) * largest_bend(ball.path, ball.acceleration, rounded(begin.speed)) +
                        rounding<double> * (begin.place_size + end.place_size);
    return {a.cwiseMin(b) - beyond, a.cwiseMax(b) + beyond};
}

void Coverage::begin()
{
    quick_.resize(data_.run.spheres.size());
    find_initial_overlaps();
    if (all_pairs_) return set_reference({});
    choose_duration();
    begin_slab({});
}

void Coverage::finish(const EpochTime& end)
{
    advance(end);
    if (all_pairs_) {
        for (BodyId a = 0; a < data_.spheres() && patience_.lasts(a); ++a)
            for (BodyId b = a + 1; b < data_.spheres() && !patience_.ended(); ++b) pair(a, b, {}, end);
    } else {
        end_slab(end);
    }
    for (BodyId i = 0; i < data_.spheres(); ++i) note_step(i, end);
    for (BodyId i = 0; i < data_.spheres() && patience_.lasts_for(1); ++i) {
        if (flights_.start(i) < end) planes(i, end);
        check_support(i, end, Edge::ends);
        gaps_.count(i, std::max(end, flights_.start(i)));
    }
}

EpochTime Coverage::leave()
{
    // Pairs: each slab that is over; without slabs each flight that is over, against everybody.
    EpochTime until = slab_begin_;
    if (all_pairs_) {
        until = flights_.start(0);
        for (BodyId i = 1; i < data_.spheres(); ++i) until = std::min(until, flights_.start(i));
    }
    for (BodyId i = 0; i < data_.spheres(); ++i)
        if (flights_.start(i) < until) planes(i, until);
    return until;
}

void Coverage::find_initial_overlaps()
{
    const BodyId n = data_.spheres();
    patience_.begin("initial overlaps", static_cast<double>(n), "spheres");
    if (!all_pairs_)
        for (BodyId i = 0; i < n; ++i) {
            double radius = 0;
            const Box place = box(i, {}, {}, radius);
            cells_->enter(i, place, radius);
        }
    for (BodyId i = 0; i < n && patience_.lasts(i); ++i) {
        visit(i, {}, {}, [&](BodyId other) {
            if (other > i) gaps_.note_overlap(i, other);
        });
        for (int p = 0; p < data_.planes(); ++p) gaps_.note_overlap_with_plane(i, p);
        check_support(i, {}, Edge::begins);
    }
}

}  // namespace carom::verification
