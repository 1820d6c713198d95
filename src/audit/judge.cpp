#include "audit/judge.hpp"

#include "audit/impossible.hpp"
#include "audit/tolerances.hpp"

#include <algorithm>
#include <limits>

namespace carom::audit {

namespace {

Begin begin_of(const Interval& interval, BodyId body)
{
    const Parabola& flight = *interval.motions[static_cast<std::size_t>(body)].before;
    return {body, flight.place_at(interval.begin), flight.velocity_at(interval.begin)};
}

}  // namespace

Judge::Judge(const Scene& scene)
    : scene_(scene),
      overlaps_(scene),
      told_until_(scene.spheres.size(), -std::numeric_limits<double>::infinity()),
      uneasy_(scene.spheres.size()),
      told_(scene.spheres.size())
{
}

void Judge::keep(Finding finding)
{
    std::int64_t* const counts[] = {&report_.touches.missed, &report_.touches.late, &report_.touches.early,
                                    &report_.invented, &report_.overlaps};
    finding.number = (*counts[static_cast<std::size_t>(finding.kind)])++;
    if (finding.kind == FindingKind::overlap) report_.deepest = std::max(report_.deepest, finding.depth);
    if (finding.number < static_cast<std::int64_t>(most_listed)) report_.findings.push_back(std::move(finding));
}

bool Judge::was_told(const Interval& interval, BodyId body) const
{
    const auto i = static_cast<std::size_t>(body);
    if (i >= interval.motions.size() || interval.motions[i].course != Course::changed) return false;
    const std::optional<Turn> turn = turn_of(interval.motions[i]);
    return (turn ? turn->time - turn->error : interval.begin) <= told_until_[i];
}

void Judge::note_turn(const Interval& interval, BodyId body)
{
    const auto i = static_cast<std::size_t>(body);
    if (i >= interval.motions.size() || interval.motions[i].course != Course::changed) return;
    told_[i] = 1;
    if (const std::optional<Turn> turn = turn_of(interval.motions[i])) told_until_[i] = turn->time + turn->error;
}

void Judge::open_touches(const Interval& interval)
{
    for (const Touch& touch : interval.touches) {
        if (touch.grazes) ++report_.grazing;
        if (!touch.is_certain || was_told(interval, touch.a) || was_told(interval, touch.b)) continue;
        Waiting waiting{touch, 0, {}};
        Finding& draft = waiting.draft;
        draft.time = touch.time;
        draft.time_error = std::max(touch.latest - touch.time, touch.time - touch.earliest);
        draft.a = touch.a;
        draft.b = touch.b;
        draft.depth = touch.depth;
        draft.begin = interval.begin;
        draft.span = (1 + scene_margin) * (interval.end - interval.begin);
        draft.bodies.push_back(begin_of(interval, touch.a));
        if (touch.b < static_cast<BodyId>(interval.motions.size())) draft.bodies.push_back(begin_of(interval, touch.b));
        if (waiting_.try_emplace({touch.a, touch.b}, waiting).second) ++report_.touches.all;
    }
}

bool Judge::enter(Waiting& waiting, const Answer& answer, const Interval& interval, const SeenFrame& to)
{
    Finding finding = waiting.draft;
    finding.by = answer.by;
    finding.at_least = answer.at_least;
    const auto tell = [&](FindingKind kind) {
        finding.kind = kind;
        keep(finding);
    };
    const Touch& touch = waiting.touch;
    const bool is_sphere = touch.b < static_cast<BodyId>(to.places.size());
    const auto depth_at = [&](double time) {
        const Parabola& a = *interval.motions[static_cast<std::size_t>(touch.a)].before;
        const Vec3 b =
            is_sphere ? interval.motions[static_cast<std::size_t>(touch.b)].before->place_at(time) : Vec3(Vec3::Zero());
        return std::max(0.0, -gap(scene_, touch.a, a.place_at(time), touch.b, b));
    };
    switch (answer.verdict) {
        case Verdict::waits:
            waiting.draft.depth = std::max(waiting.draft.depth, depth_at(interval.end));
            return true;
        case Verdict::missed:
            tell(FindingKind::missed);
            inside_plates_.insert({touch.a, touch.b});
            break;
        case Verdict::found:
            ++report_.touches.found;
            break;
        case Verdict::late:
            finding.depth = depth_at(answer.time);
            tell(FindingKind::late);
            break;
        case Verdict::early:
            finding.depth = 0;
            tell(FindingKind::early);
            break;
        case Verdict::several:
            ++report_.touches.several;
            break;
        case Verdict::unsettled:
            ++report_.touches.unsettled;
            break;
    }
    note_turn(interval, touch.a);
    note_turn(interval, touch.b);
    return false;
}

void Judge::hear_answers(const Interval& interval, const SeenFrame& from, const SeenFrame& to, const Around& around)
{
    for (auto each = waiting_.begin(); each != waiting_.end();) {
        Waiting& waiting = each->second;
        const Answer answer = answer_to(scene_, waiting.touch, waiting.intervals, interval, from, to, around);
        ++waiting.intervals;
        each = enter(waiting, answer, interval, to) ? std::next(each) : waiting_.erase(each);
    }
}

bool Judge::is_known_miss(const Pair& pair)
{
    return waiting_.contains(pair) || inside_plates_.erase(pair) > 0;
}

void Judge::notice_sides(const Interval& interval, const SeenFrame& from, const SeenFrame& to)
{
    for (std::size_t p = 0; p < scene_.planes.size(); ++p) {
        const Plane& plane = scene_.planes[p];
        for (std::size_t i = 0; i < to.places.size() && plane.thickness; ++i) {
            const Pair pair{static_cast<BodyId>(i), scene_.plane_body(p)};
            if (is_behind(plane, from.places[i]) == is_behind(plane, to.places[i]) || is_known_miss(pair)) continue;
            // No flight has said so before: the time is that at which the straight way crosses the middle.
            const double above = plane.normal.dot(from.places[i]) - plane.offset;
            const double beyond = plane.offset - plane.normal.dot(to.places[i]);
            const double span = interval.end - interval.begin;
            Finding finding;
            finding.kind = FindingKind::missed;
            finding.time = interval.begin + span * above / (above + beyond);
            finding.time_error = span;
            finding.a = pair.first;
            finding.b = pair.second;
            finding.depth = scene_.spheres[i].radius + *plane.thickness / 2;
            finding.begin = interval.begin;
            finding.span = (1 + scene_margin) * span;
            const Vec3 mean = (to.places[i] - from.places[i]) / span;
            const Vec3 velocity = mean - span / 2 * (scene_.gravity - scene_.drag * mean);
            finding.bodies.push_back({pair.first, from.places[i], velocity});
            ++report_.touches.all;
            keep(finding);
        }
    }
}

void Judge::tell_invented(const Interval& interval, std::size_t sphere)
{
    const auto body = static_cast<BodyId>(sphere);
    Finding finding;
    finding.kind = FindingKind::invented;
    finding.a = body;
    finding.time = interval.end;
    finding.time_error = interval.end - interval.begin;
    if (const std::optional<Turn> turn = turn_of(interval.motions[sphere])) {
        finding.time = std::clamp(turn->time, interval.begin, interval.end);
        finding.time_error = turn->error;
        finding.change = turn->change.norm();
    }
    finding.begin = interval.begin;
    finding.span = interval.end - interval.begin;
    finding.bodies.push_back(begin_of(interval, body));
    for (const auto& [a, b] : interval.near) {
        if (a != body && b != body) continue;
        const BodyId other = a == body ? b : a;
        if (interval.motions[static_cast<std::size_t>(other)].before)
            finding.bodies.push_back(begin_of(interval, other));
    }
    keep(std::move(finding));
    note_turn(interval, body);
}

void Judge::notice_impossible(const Interval& interval, const Around& around)
{
    for (std::size_t i = 0; i < interval.motions.size(); ++i) {
        const BodyMotion& motion = interval.motions[i];
        if (motion.course != Course::changed || !motion.after || motion.from_scene || around.disturbed[i] > 0) continue;
        const auto body = static_cast<BodyId>(i);
        if (was_told(interval, body) || is_coarse(scene_, interval, i) || may_end_a_step(motion)) continue;
        if (has_jumped(scene_, interval, i, around) || is_pulled_back(scene_, interval, i, around))
            tell_invented(interval, i);
    }
}

bool Judge::is_invention(const Interval& interval, std::size_t sphere, const Around& around) const
{
    if (around.contacts[sphere] > 0 || around.disturbed[sphere] > 0) return false;
    const BodyMotion& motion = interval.motions[sphere];
    // How a scene begins says little of the engine's first frames until a flight behind them is known.
    if (motion.from_scene && !motion.after && motion.before->bend(interval.begin, interval.begin) > 0) return false;
    const std::optional<Turn> turn = turn_of(motion);
    if (may_end_a_step(motion)) return false;
    // A change at the end is seen again in the next interval, with what happens there; one at the begin may be that of
    // a contact before, too small for the three frames to show it.
    if (turn && turn->time + turn->error > interval.end) return false;
    return uneasy_[sphere] == 0 || (turn && turn->time - turn->error > interval.begin);
}

void Judge::count_bodies(const Interval& interval, const Around& around)
{
    BodyIntervals& count = report_.bodies;
    for (std::size_t i = 0; i < interval.motions.size(); ++i) {
        const BodyMotion& motion = interval.motions[i];
        if (scene_.spheres[i].fixed) continue;
        ++count.all;
        if (motion.course == Course::unknown) {
            ++(motion.bend == Bend::straight ? count.straight : count.without_flight);
        } else if (is_coarse(scene_, interval, i)) {
            ++count.coarse;
        } else if (motion.course != Course::changed || told_[i] != 0 || was_told(interval, static_cast<BodyId>(i))) {
            ++count.decided;
        } else if (is_invention(interval, i, around)) {
            tell_invented(interval, i);
            ++count.decided;
        } else {
            const bool is_free = around.contacts[i] == 0 && around.disturbed[i] == 0;
            ++(is_free && may_end_a_step(motion) ? count.straight : count.several);
        }
        if (around.contacts[i] > 0 || around.disturbed[i] > 0)
            uneasy_[i] = fitted_frames;
        else if (uneasy_[i] > 0)
            --uneasy_[i];
    }
}

void Judge::judge(const Interval& interval, const SeenFrame& from, const SeenFrame& to)
{
    if (first_)
        for (Finding& each : overlaps_.look(from, from, interval.near)) keep(std::move(each));
    first_ = false;
    std::fill(told_.begin(), told_.end(), char{0});
    open_touches(interval);
    Pairs pairs = overlaps_.pairs();
    for (const auto& [pair, waiting] : waiting_) pairs.insert(pair);
    notice_sides(interval, from, to);
    const Around about = around(scene_, interval, std::move(pairs));
    notice_impossible(interval, about);
    hear_answers(interval, from, to, about);
    count_bodies(interval, about);
    for (Finding& each : overlaps_.look(from, to, interval.near)) keep(std::move(each));
    std::erase_if(inside_plates_, [&, inside = overlaps_.pairs()](const Pair& pair) { return !inside.contains(pair); });
}

void Judge::finish()
{
    report_.touches.unsettled += static_cast<std::int64_t>(waiting_.size());
    waiting_.clear();
    for (Finding& each : overlaps_.rest()) keep(std::move(each));
}

}  // namespace carom::audit
