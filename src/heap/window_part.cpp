#include "heap/window_part.hpp"

#include "gather/tolerances.hpp"
#include "heap/landing_course.hpp"
#include "heap/resting_part.hpp"
#include "heap/tolerances.hpp"
#include "heap/window_past.hpp"
#include "window/contact_geometry.hpp"
#include "window/window.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

class PartWindow {
public:
    PartWindow(const State& state, const EpochTime& now, const WindowBodies& all, const std::vector<int>& part,
               const WindowHistory& history, EventOutcome& out)
        : state_(state),
          now_(now),
          all_(all),
          part_(part),
          history_(history),
          out_(out),
          gravity_(state.gravity().norm())
    {
    }

    PartOutcome take()
    {
        enter();
        const std::vector<BodyId> ids = ids_of_problem();
        forces_ = forces_before(state_, problem_, ids, history_);
        heat_ = heat_of(problem_, forces_, part_.size());
        const WindowPast past = past_of(std::span(ids).first(part_.size()), history_);
        has_past_ = past.exists;
        wait_ = past.wait;
        course_ = past.course;
        if (course_) return follow_course();
        options_ = hot();
        if (is_calm()) {
            if (all_.list->skin < calm_skin * all_.list->smallest) {
                PartOutcome longer;
                longer.next = PartOutcome::Next::lists;
                longer.skin = calm_skin * all_.list->smallest;
                return longer;
            }
            if (may_land()) {
                if (land_now()) {
                    if (const auto other = carrier_to_wake()) return wakes(*other);
                    return follow_course();
                }
            }
            options_.solver = WindowSolver::exact;
            const double longest = part_.size() <= quick_landing ? longest_calm_of_few : longest_calm;
            options_.length =
                std::clamp(calm_way * all_.list->smallest / std::max(heat_.fastest_held, least_calm_speed()),
                           shortest_calm * all_.hot, longest * all_.hot);
        }
        return take_ordinary();
    }

private:
    BodyId id(int local) const { return all_.list->bodies[at(local)]; }
    /// The scene's name of a pair's partner.
    Partner partner_id(Partner b) const { return b.is_plane() ? b : Partner::sphere(id(b.index)); }

    void enter()
    {
        number_.assign(all_.list->bodies.size(), -1);
        problem_.planes = all_.planes;
        for (const int i : part_) {
            number_[at(i)] = static_cast<int>(problem_.bodies.size());
            problem_.bodies.push_back(all_.bodies[at(i)]);
            local_.push_back(i);
        }
        for (std::size_t k = 0; k < all_.list->pairs.size(); ++k) {
            NearPair pair = all_.list->pairs[k];
            // It may have come to rest since the list was made.
            if (all_.still[at(pair.a)] && pair.b.is_sphere()) pair = {pair.b.index, Partner::sphere(pair.a)};
            if (all_.still[at(pair.a)] || number_[at(pair.a)] < 0) continue;
            Partner b = pair.b;
            if (b.is_sphere()) {
                int& number = number_[at(b.index)];
                if (number < 0 && !all_.still[at(b.index)]) continue;  // of another part: they meet by roots
                if (number < 0) {
                    number = static_cast<int>(problem_.bodies.size());
                    problem_.bodies.push_back(all_.bodies[at(b.index)]);
                    local_.push_back(b.index);
                }
                b.index = number;
            }
            problem_.contacts.push_back(
                {number_[at(pair.a)], b, state_.law(id(pair.a), partner_id(pair.b)).restitution, 0});
        }
    }

    Partner contact_partner(const WindowContact& c) const
    {
        return c.b.is_plane() ? c.b : Partner::sphere(id(local_[at(c.b.index)]));
    }

    double calm_speed() const { return std::sqrt(2 * gravity_ * calm_rise * all_.list->smallest); }
    double least_calm_speed() const { return least_calm_part * calm_speed(); }
    bool is_calm() const
    {
        return has_past_ && heat_.rms_held > 0 && heat_.rms_held < calm_speed() / 4 &&
               heat_.fastest_held < 4 * calm_speed();
    }
    bool may_land() const { return wait_.hot_windows <= 0 || heat_.rms_held < slower_than_failed * wait_.failed_speed; }

    WindowOptions hot() const
    {
        WindowOptions out;
        out.length = all_.hot;
        out.closing_speed = gravity_ * all_.hot;
        out.speed_tolerance = speed_left * gravity_ * all_.hot;
        out.margin = margin_of_radius * all_.list->smallest *
                     std::clamp(heat_.fastest / (margin_speed * calm_speed()), least_margin, 1.0);
        return out;
    }

    bool land_now()
    {
        LandingOptions options;
        options.speed = calm_speed();
        options.way = landing_way * all_.list->smallest;
        for (std::size_t i = 0; i < part_.size(); ++i) {
            const WindowBody& body = problem_.bodies[i];
            if (body.velocity.norm() <= options.speed)
                options.most_energy += body.velocity.squaredNorm() / (2 * body.inverse_mass);
        }
        const std::vector<BodyId> ids = ids_of_problem();
        const auto course = find_course(problem_, ids, options);
        if (!course) {
            wait_.failed_speed = heat_.rms_held;
            wait_.after_failure =
                std::clamp(2 * wait_.after_failure, first_wait_between_landings, longest_wait_between_landings);
            wait_.hot_windows = part_.size() <= quick_landing ? 0 : wait_.after_failure;
            return false;
        }
        wait_.after_failure = 0;
        course_ = LandingStage{course, 0};
        return true;
    }

    /// A body at rest that would carry more, once the part has landed, than the bodies at rest with it bear.
    std::optional<BodyId> carrier_to_wake() const
    {
        const std::vector<Load>& loads = course_->course->loads;
        if (loads.empty() || history_.bear(loads)) return {};
        for (const Load& load : loads)
            if (!state_.is_fixed(load.body)) return load.body;
        return {};
    }

    static PartOutcome wakes(BodyId body)
    {
        PartOutcome out;
        out.next = PartOutcome::Next::wakes;
        out.woken = body;
        return out;
    }

    std::vector<BodyId> ids_of_problem() const
    {
        std::vector<BodyId> out;
        for (const int i : local_) out.push_back(id(i));
        return out;
    }

    /// One move of a landing. Others of the part go on beside it.
    PartOutcome follow_course()
    {
        const LandingCourse& course = *course_->course;
        const std::vector<Vec3>& move = course.moves[course_->move];
        double way = 0;
        for (const Vec3& d : move) way = std::max(way, d.norm());
        options_ = hot();
        options_.length = std::max(all_.hot, way / (landing_speed * calm_speed()));
        if (options_.length > 2 * all_.hot) options_.solver = WindowSolver::exact;
        WindowProblem problem = problem_;
        const double left = course.left[course_->move];
        std::vector<int> lands(part_.size(), -1);
        for (std::size_t i = 0; i < part_.size(); ++i) {
            const auto found = std::lower_bound(course.bodies.begin(), course.bodies.end(), id(part_[i]));
            if (found == course.bodies.end() || *found != id(part_[i])) continue;
            lands[i] = static_cast<int>(found - course.bodies.begin());
            problem.bodies[i].inverse_mass = 0;
            problem.bodies[i].velocity = move[at(lands[i])] / options_.length;
        }
        set_guesses(problem);
        const WindowOutcome solved = take_window(problem, options_);
        if (solved.status != WindowStatus::complete || part_that_fits(solved) < 1) return give_up_landing();
        WindowOutcome outcome = solved;
        for (std::size_t i = 0; i < part_.size(); ++i)
            if (lands[i] >= 0) outcome.motions[i].end_velocity = left * course.velocities[at(lands[i])];
        if (const std::optional<PartOutcome> other = other_first(outcome)) return *other;
        return commit(outcome);
    }

    PartOutcome give_up_landing()
    {
        course_.reset();
        wait_.failed_speed = heat_.rms_held;
        wait_.hot_windows = first_wait_between_landings;
        options_ = hot();
        return take_ordinary();
    }

    /// Guesses of the window's impulses, from the forces of the last one.
    void set_guesses(WindowProblem& problem) const
    {
        for (std::size_t k = 0; k < forces_.size(); ++k) problem.contacts[k].impulse = forces_[k] * options_.length;
    }

    PartOutcome take_ordinary()
    {
        for (int round = 0; round < most_shorter_windows; ++round) {
            set_guesses(problem_);
            WindowOutcome outcome = take_window(problem_, options_);
            if (outcome.status == WindowStatus::infeasible) {
                options_.solver = WindowSolver::exact;
                options_.length *= shorter_window;
                continue;
            }
            const double fits = part_that_fits(outcome);
            if (fits <= least_part_of_list && has_moved()) return longer_list(outcome);
            cut(outcome, fits);
            if (const std::optional<PartOutcome> other = other_first(outcome)) return *other;
            return commit(outcome);
        }
        options_ = hot();
        loads_.clear();
        return commit(all_stop());
    }

    /// Whether a body at rest is to be woken before: its part does not bear the mean forces of the window, and they
    /// are no small change of speed.
    std::optional<PartOutcome> other_first(const WindowOutcome& outcome)
    {
        loads_.clear();
        std::optional<BodyId> pushed;
        for (std::size_t k = 0; k < problem_.contacts.size(); ++k) {
            const WindowContact& c = problem_.contacts[k];
            if (!(outcome.impulses[k] > 0) || !c.b.is_sphere() || at(c.b.index) < part_.size()) continue;
            const BodyId other = id(local_[at(c.b.index)]);
            if (state_.is_fixed(other)) continue;
            loads_.push_back({other, -(outcome.impulses[k] / outcome.length) * geometry(problem_, c).normal});
            if (outcome.impulses[k] * problem_.bodies[at(c.a)].inverse_mass > state_.rest.closing_speed) pushed = other;
        }
        if (loads_.empty() || history_.bear(loads_)) return {};
        if (pushed) return wakes(*pushed);
        loads_.clear();
        return {};
    }

    /// The part of a window in which nobody leaves the list behind.
    double part_that_fits(const WindowOutcome& outcome) const
    {
        double fits = 1;
        for (std::size_t i = 0; i < part_.size(); ++i) {
            const double way = displacement(outcome, i).norm(), room = all_.list->skin / 2 - all_.moved[at(part_[i])];
            if (way > room) fits = std::min(fits, part_of_the_room * std::max(room, 0.0) / way);
        }
        return fits;
    }

    bool has_moved() const
    {
        return std::any_of(part_.begin(), part_.end(), [&](int i) { return all_.moved[at(i)] > 0; });
    }

    PartOutcome longer_list(const WindowOutcome& outcome) const
    {
        PartOutcome out;
        out.next = PartOutcome::Next::lists;
        for (std::size_t i = 0; i < part_.size(); ++i)
            out.skin = std::max(out.skin, 2 * displacement(outcome, i).norm());
        return out;
    }

    /// The first part of a window: all bounds are linear, momentum is kept, and energy is a convex function.
    void cut(WindowOutcome& outcome, double part) const
    {
        if (!(part < 1)) return;
        outcome.length *= part;
        for (double& impulse : outcome.impulses) impulse *= part;
        for (std::size_t i = 0; i < part_.size(); ++i) {
            Vec3& end = outcome.motions[i].end_velocity;
            end = problem_.bodies[i].velocity + part * (end - problem_.bodies[i].velocity);
        }
    }

    /// The last resort: everybody stands still for a window.
    WindowOutcome all_stop() const
    {
        WindowOutcome out;
        out.length = all_.hot;
        out.impulses.assign(problem_.contacts.size(), 0);
        out.guess = out.impulses;
        out.motions.resize(problem_.bodies.size());
        return out;
    }

    static Vec3 displacement(const WindowOutcome& outcome, std::size_t i)
    {
        const WindowMotion& m = outcome.motions[i];
        return outcome.length * (m.velocity + (outcome.length / 2) * m.acceleration);
    }

    PartOutcome commit(const WindowOutcome& outcome)
    {
        auto piece = std::make_shared<WindowPiece>();
        piece->near = all_.list;
        piece->wait = wait_;
        piece->wait.hot_windows -= outcome.length / all_.hot;
        piece->landing = course_;
        piece->loads = loads_;
        for (const auto& carrier : *history_.carriers)
            if (std::any_of(loads_.begin(), loads_.end(), [&](const Load& l) { return carrier->has(l.body); }))
                piece->carriers.push_back(carrier);
        piece->length = outcome.length;
        piece->end = state_.frame.after(now_, outcome.length);
        std::vector<std::vector<PersistentContact>> carried(part_.size());
        for (std::size_t k = 0; k < problem_.contacts.size(); ++k) {
            const WindowContact& c = problem_.contacts[k];
            if (outcome.guess[k] > 0)
                piece->forces.push_back({id(local_[at(c.a)]), contact_partner(c), outcome.guess[k] / options_.length});
            if (c.b.is_plane() && outcome.impulses[k] > 0)
                carried[at(c.a)].push_back({c.b, outcome.impulses[k] / outcome.length});
        }
        const std::size_t first_change = out_.changes.size();
        for (std::size_t i = 0; i < part_.size(); ++i) {
            const BodyId body = id(part_[i]);
            const WindowMotion& m = outcome.motions[i];
            const Vec3& before = all_.bodies[at(part_[i])].velocity;
            piece->bodies.push_back(body);
            piece->velocities.push_back(before);
            Change change{body, all_.flights[at(part_[i])], Windowed{piece->end, m.end_velocity, nullptr, i},
                          carried[i]};
            change.flight.start = now_;
            change.flight.velocity = m.velocity;
            change.flight.acceleration =
                m.acceleration.squaredNorm() > 0 ? state_.bodies.accelerations().free() : Accelerations::none;
            piece->taken += energy_taken(state_, body, {before, m.end_velocity}, displacement(outcome, i));
            out_.changes.push_back(change);
        }
        out_.taken.window += piece->taken;
        const std::shared_ptr<const WindowPiece> shared = std::move(piece);
        for (std::size_t k = first_change; k < out_.changes.size(); ++k)
            std::get<Windowed>(out_.changes[k].motion).piece = shared;
        out_.events.push_back({EventKind::guard, {}, 0, shared->bodies.front(), no_body, Vec3::Zero(), Vec3::Zero()});
        PartOutcome taken;
        taken.loads = loads_;
        return taken;
    }

    const State& state_;
    const EpochTime now_;
    const WindowBodies& all_;
    const std::vector<int>& part_;
    const WindowHistory& history_;
    EventOutcome& out_;
    const double gravity_;
    WindowProblem problem_;       ///< first the bodies of the part, then those that stand still
    std::vector<int> number_;     ///< by number in the list: in the problem, or -1
    std::vector<int> local_;      ///< by number in the problem: in the list
    std::vector<double> forces_;  ///< by contact: where to begin
    Heat heat_;
    bool has_past_ = false;
    LandingWait wait_;
    std::optional<LandingStage> course_;
    WindowOptions options_;
    std::vector<Load> loads_;  ///< of the window on bodies at rest
};

}  // namespace

PartOutcome take_window_of_part(const State& state, const EpochTime& now, const WindowBodies& bodies,
                                const std::vector<int>& part, const WindowHistory& history, EventOutcome& out)
{
    return PartWindow(state, now, bodies, part, history, out).take();
}

}  // namespace carom
