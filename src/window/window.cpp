#include "window/window.hpp"

#include "core/expect.hpp"
#include "window/contact_geometry.hpp"
#include "window/project_rows.hpp"
#include "window/restitution.hpp"
#include "window/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

class Window {
public:
    Window(const WindowProblem& problem, const WindowOptions& options)
        : problem_(problem),
          options_(options),
          h_(options.length),
          fixed_(static_cast<int>(problem.bodies.size())),
          row_of_(problem.contacts.size(), -1)
    {
        for (const WindowBody& body : problem.bodies) {
            goal_.push_back(body.inverse_mass > 0 ? Vec3(body.velocity + h_ * body.acceleration) : body.velocity);
            inverse_masses_.push_back(body.inverse_mass);
        }
        goal_.emplace_back(Vec3::Zero());
        inverse_masses_.push_back(0);
        for (const WindowContact& contact : problem.contacts) geometry_.push_back(geometry(problem, contact));
    }

    WindowOutcome take()
    {
        for (std::size_t i = 0; i < geometry_.size(); ++i)
            if (geometry_[i].gap < reach_of(i)) join(i);
        if (options_.solver == WindowSolver::relaxation) {
            const double part = solve(WindowSolver::relaxation);
            if (part >= least_part) return outcome(part);
        }
        const double part = solve(WindowSolver::exact);
        return part >= least_part_of_all ? outcome(part) : nothing();
    }

private:
    int partner(const WindowContact& contact) const { return contact.b.is_plane() ? fixed_ : contact.b.index; }
    double inverse_mass(int body) const { return inverse_masses_[at(body)]; }
    Vec3 velocity(int body) const { return body == fixed_ ? Vec3::Zero() : problem_.bodies[at(body)].velocity; }
    double floor_of(std::size_t i) const
    {
        return std::min(geometry_[i].gap, -overlap_of_rounding * radius_of(problem_, problem_.contacts[i]));
    }

    double reach_of(std::size_t i) const
    {
        const WindowContact& contact = problem_.contacts[i];
        if (options_.solver == WindowSolver::exact)
            return exact_reach_of_speed * h_ * (velocity(contact.a) - velocity(partner(contact))).norm() +
                   exact_reach * radius_of(problem_, contact);
        const double fall = h_ * problem_.bodies[at(contact.a)].acceleration.norm();
        return h_ * ((velocity(contact.a) - velocity(partner(contact))).norm() + reach_of_fall * fall) +
               reach_of_margin * options_.margin;
    }

    void join(std::size_t i)
    {
        const WindowContact& contact = problem_.contacts[i];
        RelaxationRow row;
        row.a = contact.a;
        row.b = partner(contact);
        row.normal = geometry_[i].normal;
        row.weight_a = inverse_mass(row.a);
        row.weight_b = inverse_mass(row.b);
        if (!(row.weight_a + row.weight_b > 0)) return;
        row.multiplier = contact.impulse;
        row.least = -(geometry_[i].gap - floor_of(i)) / h_;
        row_of_[i] = static_cast<int>(rows_.size());
        rows_.push_back(row);
        contact_of_.push_back(i);
    }

    /// \returns the part of the window in which nothing overlaps and energy does not grow, 0 where there is none
    double solve(WindowSolver solver)
    {
        for (int round = 0; round < most_added_rounds; ++round) {
            if (solver == WindowSolver::exact)
                project_exactly();
            else
                relax_rows();
            put_pushes();
            if (add_missed()) continue;
            find_free();
            return std::min(feasible_part(), energy_part());
        }
        return 0;
    }

    void relax_rows()
    {
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const double above = geometry_[contact_of_[k]].gap - options_.margin;
            rows_[k].wanted = std::max(rows_[k].least, (above < 0 ? -margin_made_good * above : -above) / h_);
        }
        put_pushes();
        const RelaxationReport done = relax(rows_, u_, {options_.speed_tolerance, most_window_sweeps});
        work_.sweeps += done.sweeps;
        work_.relaxations += done.relaxations;
    }

    void project_exactly()
    {
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const std::size_t i = contact_of_[k];
            // No push: bodies that just fit between others have no room for a margin.
            const double margin = exact_margin * radius_of(problem_, problem_.contacts[i]), gap = geometry_[i].gap;
            rows_[k].wanted = (std::clamp(gap, 0.0, margin) - gap) / h_;
        }
        double change = 0;
        for (int i = 0; i < fixed_; ++i)
            if (inverse_mass(i) > 0)
                change = std::max(change, (goal_[at(i)] - velocity(i)).norm() / std::sqrt(inverse_mass(i)));
        work_.interior_steps += project_rows(rows_, goal_, inverse_masses_, change);
    }

    /// Velocities from multipliers, so that momentum is theirs to rounding.
    void put_pushes()
    {
        u_ = goal_;
        for (const RelaxationRow& row : rows_) {
            u_[at(row.a)] += (row.multiplier * row.weight_a) * row.normal;
            u_[at(row.b)] -= (row.multiplier * row.weight_b) * row.normal;
        }
    }

    bool add_missed()
    {
        const std::size_t before = rows_.size();
        for (std::size_t i = 0; i < geometry_.size(); ++i) {
            if (row_of_[i] >= 0) continue;
            const WindowContact& contact = problem_.contacts[i];
            const Vec3 apart = u_[at(contact.a)] - u_[at(partner(contact))];
            if (geometry_[i].gap + h_ * geometry_[i].normal.dot(apart) < 0) join(i);
        }
        return rows_.size() > before;
    }

    /// Finds the bodies that fly: nothing pushes them, and their parabolas keep the bounds of all contacts. Two that
    /// fly have the straight relative motion that the projection gave them.
    void find_free()
    {
        free_.assign(at(fixed_) + 1, 0);
        for (int i = 0; i < fixed_; ++i) free_[at(i)] = inverse_mass(i) > 0;
        for (const RelaxationRow& row : rows_)
            if (row.multiplier > 0) free_[at(row.a)] = free_[at(row.b)] = 0;
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t i = 0; i < geometry_.size(); ++i) {
                const WindowContact& contact = problem_.contacts[i];
                const int a = contact.a, b = partner(contact);
                if ((!free_[at(a)] && !free_[at(b)]) || keeps_bound(i, a, b)) continue;
                free_[at(a)] = free_[at(b)] = 0;
                changed = true;
            }
        }
    }

    /// Whether the linear bound of the gap is kept at every time of the window.
    bool keeps_bound(std::size_t i, int a, int b) const
    {
        const Vec3& n = geometry_[i].normal;
        const double first = n.dot(begin_velocity(a) - begin_velocity(b));
        const double second = n.dot(begin_acceleration(a) - begin_acceleration(b));
        const double gap = geometry_[i].gap, least = floor_of(i);
        if (gap + h_ * (first + h_ * second / 2) < least) return false;
        const bool turns = second > 0 && first < 0 && -first < h_ * second;
        return !turns || gap - first * first / (2 * second) >= least;
    }

    Vec3 begin_velocity(int i) const { return free_[at(i)] ? velocity(i) : u_[at(i)]; }
    Vec3 begin_acceleration(int i) const { return free_[at(i)] ? problem_.bodies[at(i)].acceleration : Vec3::Zero(); }

    /// The part of the window in which nothing overlaps.
    double feasible_part() const
    {
        double part = 1;
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const double now = rate(rows_[k], u_), gap = geometry_[contact_of_[k]].gap;
            if (now < rows_[k].least) part = std::min(part, part_of_the_way * std::max(0.0, gap) / (-h_ * now));
        }
        return part;
    }

    /// The part of the window up to which energy does not grow: with D = sum multiplier rate and Q = |u - v|^2 / 2 a
    /// part s changes it by s (D - (2 - s) Q).
    double energy_part()
    {
        double lift = 0;
        work_done_ = turned_ = 0;
        for (const RelaxationRow& row : rows_) work_done_ += row.multiplier * rate(row, u_);
        for (int i = 0; i < fixed_; ++i) {
            if (free_[at(i)] || !(inverse_mass(i) > 0)) continue;
            turned_ += (u_[at(i)] - velocity(i)).squaredNorm() / (2 * inverse_mass(i));
            lift += problem_.bodies[at(i)].acceleration.norm() * problem_.bodies[at(i)].radius / inverse_mass(i);
        }
        if (work_done_ <= turned_ + energy_of_rounding * lift) return 1;
        return turned_ > 0 ? 2 - work_done_ / turned_ : 0;
    }

    WindowOutcome outcome(double part)
    {
        WindowOutcome out = work_;
        out.status = part < 1 ? WindowStatus::shortened : WindowStatus::complete;
        out.length = part * h_;
        out.taken_by_window = part * ((2 - part) * turned_ - work_done_);
        out.impulses.assign(problem_.contacts.size(), 0);
        out.guess = out.impulses;
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            out.guess[contact_of_[k]] = rows_[k].multiplier;
            out.impulses[contact_of_[k]] = part * rows_[k].multiplier;
        }
        for (int i = 0; i < fixed_; ++i)
            out.motions.push_back({begin_velocity(i), begin_acceleration(i), Vec3::Zero()});
        rebound_from(part, out);
        return out;
    }

    /// Adds rebounds to the outcome of a part of the window.
    void rebound_from(double part, WindowOutcome& out) const
    {
        std::vector<Rebound> rebounds;
        bool any = false;
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const RelaxationRow& row = rows_[k];
            if (!(row.multiplier > 0)) continue;
            const double closing = -row.normal.dot(velocity(row.a) - velocity(row.b));
            const bool fast = closing > options_.closing_speed;
            const double e = problem_.contacts[contact_of_[k]].restitution;
            rebounds.push_back({static_cast<int>(k), fast ? e * closing : 0, 0, fast});
            any = any || fast;
        }
        ReboundProblem end;
        for (int i = 0; i <= fixed_; ++i) end.velocities.push_back(velocity(i) + part * (u_[at(i)] - velocity(i)));
        end.inverse_masses = inverse_masses_;
        end.most_energy = std::max(0.0, out.taken_by_window);
        end.speed_tolerance = rebound_tolerance * options_.closing_speed;
        if (any) out.taken_by_restitution = -rebound(rows_, rebounds, end);
        for (const Rebound& each : rebounds) out.impulses[contact_of_[at(each.row)]] += each.impulse;
        for (int i = 0; i < fixed_; ++i) out.motions[at(i)].end_velocity = end.velocities[at(i)];
    }

    WindowOutcome nothing() const
    {
        WindowOutcome out = work_;
        out.status = WindowStatus::infeasible;
        out.impulses.assign(problem_.contacts.size(), 0);
        out.guess = out.impulses;
        for (const WindowBody& body : problem_.bodies)
            out.motions.push_back({body.velocity, Vec3::Zero(), body.velocity});
        return out;
    }

    const WindowProblem& problem_;
    const WindowOptions& options_;
    const double h_;
    const int fixed_;  ///< number of the body that stands for all planes
    std::vector<Vec3> goal_, u_;
    std::vector<double> inverse_masses_;
    std::vector<ContactGeometry> geometry_;
    std::vector<int> row_of_;
    std::vector<RelaxationRow> rows_;
    std::vector<std::size_t> contact_of_;  ///< by row
    std::vector<char> free_;
    double work_done_ = 0, turned_ = 0;
    WindowOutcome work_;
};

}  // namespace

WindowOutcome take_window(const WindowProblem& problem, const WindowOptions& options)
{
    CAROM_EXPECT(options.length > 0);
    return Window(problem, options).take();
}

}  // namespace carom
