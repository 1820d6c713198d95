#include "window/landing.hpp"

#include "window/contact_geometry.hpp"
#include "window/interior_point.hpp"
#include "window/statics.hpp"
#include "window/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

class Landing {
public:
    Landing(const WindowProblem& problem, const LandingOptions& options)
        : start_(problem), now_(problem), options_(options), radius_(std::numeric_limits<double>::infinity())
    {
        for (const WindowBody& body : problem.bodies) {
            out_.rests.push_back(body.inverse_mass > 0 && body.acceleration.squaredNorm() > 0 &&
                                 body.velocity.norm() <= options.speed);
            if (!out_.rests.back()) continue;
            ++candidates_;
            radius_ = std::min(radius_, body.radius);
            fall_ = std::max(fall_, body.acceleration.norm());
        }
    }

    LandingOutcome take()
    {
        out_.forces.assign(start_.contacts.size(), 0);
        out_.status = candidates_ > 0 && descend() ? close_gaps() : failure_;
        if (out_.status != LandingStatus::rests) {
            std::fill(out_.rests.begin(), out_.rests.end(), char{0});
            std::fill(out_.forces.begin(), out_.forces.end(), 0.0);
            out_.moves.clear();
        }
        return out_;
    }

private:
    bool rests(int body) const { return out_.rests[at(body)]; }
    bool moves_by_itself(const Partner& b) const
    {
        return b.is_sphere() && now_.bodies[at(b.index)].inverse_mass > 0 && !rests(b.index);
    }
    bool concerns(const WindowContact& c) const { return rests(c.a) || (c.b.is_sphere() && rests(c.b.index)); }

    void number_bodies()
    {
        number_.assign(now_.bodies.size(), -1);
        inverse_masses_.clear();
        accelerations_.clear();
        for (std::size_t i = 0; i < now_.bodies.size(); ++i) {
            if (!out_.rests[i]) continue;
            number_[i] = static_cast<int>(inverse_masses_.size());
            inverse_masses_.push_back(now_.bodies[i].inverse_mass);
            accelerations_.push_back(now_.bodies[i].acceleration);
        }
    }

    /// \pre one of its bodies rests
    HalfSpace half_space(const WindowContact& contact) const
    {
        const ContactGeometry geometric = geometry(now_, contact);
        HalfSpace out{number_[at(contact.a)], {}, geometric.normal, geometric.gap};
        const bool b_rests = contact.b.is_sphere() && rests(contact.b.index);
        if (!rests(contact.a)) {
            out.a = number_[at(contact.b.index)];
            out.normal = -out.normal;
        } else if (b_rests)
            out.b = number_[at(contact.b.index)];
        return out;
    }

    /// Falls step by step to the lowest place. Where a body is left out the fall begins anew, from the places of the
    /// start: what is left out stays there.
    bool descend()
    {
        int begun = 0, left_out = 0;
        double first_square = 0;
        for (int step = 0; step < most_descents; ++step) {
            fall();
            const int before = resting_;
            if (resting_ > 0) leave_out();
            if (resting_ == 0 || resting_ < candidates_ * least_resting) return fail(LandingStatus::unbalanced);
            if (resting_ < before) {
                if (++left_out > most_left_out) return fail(LandingStatus::unbalanced);
                begin_anew();
                begun = step + 1;
                continue;
            }
            double way = 0, square = 0;
            for (const Vec3& d : displacement_) {
                way = std::max(way, d.norm());
                square += d.squaredNorm();
            }
            if (step == begun) first_square = square;
            if (step >= begun + steps_to_converge && square > landing_converges * landing_converges * first_square &&
                resting_ > patient_landing)
                return fail(LandingStatus::too_far);
            if (move(displacement_)) {
                if (way < newton_converges * radius_) return true;
                continue;
            }
            // A shorter fall leaves smaller errors, and the bounds of contacts that touch are kept.
            fall_of_step_ *= shorter_fall;
            if (failure_ != LandingStatus::overlaps || fall_of_step_ < least_descent_of_fall) return false;
        }
        return fail(LandingStatus::too_far);
    }

    void begin_anew()
    {
        now_ = start_;
        out_.moves.clear();
        out_.lifted = 0;
    }

    void fall()
    {
        number_bodies();
        resting_ = static_cast<int>(inverse_masses_.size());
        const double square_time = fall_of_step_ * radius_ / fall_;
        ProjectionProblem projection;
        projection.w = inverse_masses_;
        double scale = 0;
        for (std::size_t k = 0; k < accelerations_.size(); ++k) {
            projection.start.emplace_back(square_time * accelerations_[k]);
            scale = std::max(scale, projection.start[k].squaredNorm() / inverse_masses_[k]);
        }
        listed_.clear();
        for (std::size_t i = 0; i < now_.contacts.size(); ++i) {
            if (!concerns(now_.contacts[i])) continue;
            HalfSpace h = half_space(now_.contacts[i]);
            if (h.offset > 2 * options_.way) continue;
            h.offset -= std::clamp(h.offset, 0.0, landing_margin * radius_of(now_, now_.contacts[i]));
            projection.half_spaces.push_back(h);
            listed_.push_back(i);
        }
        if (resting_ == 0) return;
        const Projection solved = interior_point(projection, std::sqrt(scale));
        out_.factorisations += solved.steps;
        std::fill(out_.forces.begin(), out_.forces.end(), 0.0);
        for (std::size_t k = 0; k < listed_.size(); ++k)
            out_.forces[listed_[k]] = carries(projection, solved, k) ? solved.multipliers[k] / square_time : 0;
        displacement_ = solved.point;
    }

    /// Whether a half-space's multiplier is more than what its slack makes of rounding.
    static bool carries(const ProjectionProblem& projection, const Projection& solved, std::size_t k)
    {
        const HalfSpace& h = projection.half_spaces[k];
        return solved.multipliers[k] * normal_length2(h, projection.w) > std::abs(slack(h, solved.point));
    }

    /// Leaves out bodies that go too far, that nothing carries, those that what is left out holds up, and those that
    /// pushed on what was out before the fall. What carried a body that leaves stays: the next fall is without its
    /// weight.
    void leave_out()
    {
        const std::vector<char> in_fall = out_.rests;
        std::vector<char> carried(now_.bodies.size(), 0);
        for (std::size_t i = 0; i < now_.contacts.size(); ++i) {
            if (!(out_.forces[i] > 0)) continue;
            carried[at(now_.contacts[i].a)] = 1;
            if (now_.contacts[i].b.is_sphere()) carried[at(now_.contacts[i].b.index)] = 1;
        }
        const auto leave = [&](int body) {
            out_.rests[at(body)] = 0;
            --resting_;
        };
        for (std::size_t i = 0; i < now_.bodies.size(); ++i) {
            if (!out_.rests[i]) continue;
            const Vec3 way = now_.bodies[i].place + displacement_[at(number_[i])] - start_.bodies[i].place;
            if (!carried[i] || way.norm() > options_.way) leave(static_cast<int>(i));
        }
        const auto leans = [&](int body, int other, const Vec3& towards_body) {
            if (!rests(body) || !moves_by_itself(Partner::sphere(other))) return false;
            return !in_fall[at(other)] || towards_body.dot(now_.bodies[at(body)].acceleration) < 0;
        };
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t i = 0; i < now_.contacts.size(); ++i) {
                const WindowContact& c = now_.contacts[i];
                if (!(out_.forces[i] > 0) || !c.b.is_sphere()) continue;
                const Vec3 normal = geometry(now_, c).normal;
                if (leans(c.a, c.b.index, normal))
                    leave(c.a);
                else if (leans(c.b.index, c.a, -normal))
                    leave(c.b.index);
                else
                    continue;
                changed = true;
            }
        }
    }

    /// Moves what rests, or goes the part of the way that keeps the linear bounds of all gaps.
    bool move(const std::vector<Vec3>& displacement)
    {
        std::vector<Vec3> shift(now_.bodies.size(), Vec3::Zero());
        for (std::size_t i = 0; i < shift.size(); ++i)
            if (out_.rests[i]) shift[i] = displacement[at(number_[i])];
        double part = 1;
        for (const WindowContact& contact : now_.contacts) {
            if (!concerns(contact)) continue;
            const ContactGeometry g = geometry(now_, contact);
            Vec3 apart = shift[at(contact.a)];
            if (contact.b.is_sphere()) apart -= shift[at(contact.b.index)];
            const double change = g.normal.dot(apart), floor = -overlap_of_rounding * radius_of(now_, contact);
            if (g.gap + change < std::min(g.gap, floor))
                part = std::min(part, part_of_the_way * std::max(0.0, g.gap) / -change);
        }
        if (part < least_part) return fail(LandingStatus::overlaps);
        for (std::size_t i = 0; i < shift.size(); ++i) {
            if (!out_.rests[i]) continue;
            WindowBody& body = now_.bodies[i];
            shift[i] *= part;
            body.place += shift[i];
            out_.lifted -= shift[i].dot(body.acceleration) / body.inverse_mass;
            if ((body.place - start_.bodies[i].place).norm() > options_.way) return fail(LandingStatus::too_far);
        }
        out_.moves.push_back(std::move(shift));
        return true;
    }

    LandingStatus close_gaps()
    {
        for (int step = 0; step < most_newton_steps_of_landing; ++step) {
            number_bodies();
            std::vector<HalfSpace> carrying;
            listed_.clear();
            out_.largest_gap = 0;
            for (std::size_t i = 0; i < now_.contacts.size(); ++i) {
                if (!(out_.forces[i] > 0)) continue;
                carrying.push_back(half_space(now_.contacts[i]));
                listed_.push_back(i);
                out_.largest_gap = std::max(out_.largest_gap, std::abs(carrying.back().offset));
            }
            ++out_.factorisations;
            const std::optional<Statics> solved = statics(carrying, accelerations_, inverse_masses_);
            if (!solved) return LandingStatus::unbalanced;
            const bool pulls = take_forces(solved->forces);
            out_.residual = solved->residual;
            if (pulls) continue;
            if (out_.largest_gap < gap_at_rest * radius_) {
                if (!(out_.residual < acceleration_at_rest * fall_)) return LandingStatus::unbalanced;
                return out_.lifted > options_.most_energy ? LandingStatus::too_far : LandingStatus::rests;
            }
            if (!move(solved->displacement)) return failure_;
        }
        return LandingStatus::unbalanced;
    }

    /// Takes the forces of the contacts that are listed; those that pull most no longer carry. Not all that pull: where
    /// the worst is gone others push. \returns whether some pulled, or bore rounding alone
    bool take_forces(const std::vector<double>& forces)
    {
        double largest = 0, least = 0;
        for (const double force : forces) {
            largest = std::max(largest, force);
            least = std::min(least, force);
        }
        const double rounding = least_force * largest, bound = -least > rounding ? least / 2 : rounding;
        bool out = false;
        for (std::size_t k = 0; k < listed_.size(); ++k) {
            const bool carries = forces[k] > bound;
            out = out || !carries;
            // One that pulls a little is asked again.
            out_.forces[listed_[k]] = carries ? std::max(forces[k], rounding) : 0;
        }
        return out;
    }

    bool fail(LandingStatus status)
    {
        failure_ = status;
        return false;
    }

    const WindowProblem& start_;
    WindowProblem now_;
    const LandingOptions& options_;
    double radius_, fall_ = 0;               ///< the smallest radius, the largest acceleration
    double fall_of_step_ = descent_of_fall;  ///< [smallest radius]
    int candidates_ = 0, resting_ = 0;
    std::vector<int> number_;  ///< by body, among those that rest
    std::vector<double> inverse_masses_;
    std::vector<Vec3> accelerations_, displacement_;
    std::vector<std::size_t> listed_;  ///< contacts of the last half-spaces
    LandingStatus failure_ = LandingStatus::unbalanced;
    LandingOutcome out_;
};

}  // namespace

LandingOutcome land(const WindowProblem& problem, const LandingOptions& options)
{
    return Landing(problem, options).take();
}

}  // namespace carom
