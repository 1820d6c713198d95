#include "stepping/damped_turns.hpp"

#include "stepping/bracket.hpp"
#include "stepping/damped_times.hpp"
#include "stepping/tolerances.hpp"

#include <cmath>

namespace carom::stepping {

namespace {

double length(const Vec3& v)
{
    return std::sqrt(v.squaredNorm());
}

/// Rate of half the square of a distance in a damped relative motion, d/dt |r|^2 / 2 = r.r', and where it turns.
class DistanceRate {
public:
    DistanceRate(const Vec3& place, const Vec3& velocity, const Vec3& acceleration, double drag)
        : place_(place), velocity_(velocity), acceleration_(acceleration), drag_(drag)
    {
    }

    double operator()(double t) const
    {
        const DampedTimes times = damped_times(drag_, t);
        return place_after(times, place_, velocity_, acceleration_)
            .dot(velocity_after(times, drag_, velocity_, acceleration_));
    }

    /// Appends sign changes in (begin, end), halving it at most so often.
    void find(double begin, double end, int halvings, std::int64_t& evaluations, std::vector<double>& found) const
    {
        ++evaluations;
        const double half = (end - begin) / 2, middle = begin + half;
        const Vec3 at_begin = velocity_after(damped_times(drag_, begin), drag_, velocity_, acceleration_);
        const DampedTimes times = damped_times(drag_, middle);
        const Vec3 r = place_after(times, place_, velocity_, acceleration_);
        const Vec3 v = velocity_after(times, drag_, velocity_, acceleration_);
        const double value = r.dot(v), slope = v.squaredNorm() + r.dot(acceleration_ - drag_ * v);
        // Accelerations are largest at the begin, and fade with the drag.
        const double most_a = length(acceleration_ - drag_ * at_begin), most_v = length(at_begin) + 2 * half * most_a;
        const double most_curvature = most_a * (3 * most_v + drag_ * (length(r) + half * most_v));
        if (std::abs(value) > (std::abs(slope) + most_curvature * half / 2) * half) return;
        if (std::abs(slope) > most_curvature * half) {
            const bool was_negative = (*this)(begin) < 0;
            if (was_negative == ((*this)(end) < 0)) return;
            found.push_back(bisect(
                                begin, end, [&](double t) { return ((*this)(t) < 0) != was_negative; }, evaluations)
                                .after);
        } else if (halvings > 0) {
            find(begin, middle, halvings - 1, evaluations, found);
            find(middle, end, halvings - 1, evaluations, found);
        }
    }

private:
    Vec3 place_, velocity_, acceleration_;
    double drag_;
};

}  // namespace

std::vector<double> damped_turns(System& system, const PathContacts& contacts, BodyId a, BodyId b, double now)
{
    const StepPaths& paths = contacts.paths;
    const double left = paths.length() - now;
    std::int64_t& evaluations = system.detector.tests;
    std::vector<double> found;
    const auto find_one = [&](const auto& rate) {
        const bool was_negative = rate(0.0) < 0;
        if (was_negative == (rate(left) < 0)) return;
        found.push_back(bisect(
                            0.0, left, [&](double t) { return (rate(t) < 0) != was_negative; }, evaluations)
                            .after);
    };
    const Vec3 v = paths.velocity(system.bodies, a, now);
    if (system.detector.is_wall(b)) {
        const Vec3& n = system.detector.wall(b).normal;
        find_one([&](double t) {
            return n.dot(velocity_after(damped_times(paths.drag(), t), paths.drag(), v, paths.bend(a)));
        });
        return found;
    }
    const Vec3 acceleration = paths.bend(a) - paths.bend(b);
    const DistanceRate rate(paths.place(system.bodies, a, now) - paths.place(system.bodies, b, now),
                            v - paths.velocity(system.bodies, b, now), acceleration, paths.drag());
    if (acceleration == Vec3::Zero())
        find_one(rate);
    else
        rate.find(0, left, most_turn_halvings, evaluations, found);
    return found;
}

}  // namespace carom::stepping
