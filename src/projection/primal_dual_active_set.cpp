#include "projection/primal_dual_active_set.hpp"

#include "projection/active_factor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

class PrimalDualActiveSet {
public:
    PrimalDualActiveSet(const ProjectionProblem& problem, std::span<const double> guess)
        : problem_(problem),
          normals_(unit_normals(problem)),
          factor_(problem.start.size(), normals_),
          tolerance_(sparse_tolerances * problem.tolerance)
    {
        for (std::size_t i = 0; i < guess.size(); ++i)
            is_active_.push_back(guess[i] > 0 || problem.half_spaces[i].is_equality);
        out_.multipliers.assign(normals_.size(), 0);
        out_.complete = false;
    }

    Projection solve()
    {
        for (out_.steps = 1; out_.steps <= most_set_changes; ++out_.steps) {
            factor_.follow(is_active_);
            find_multipliers();
            if (!change_active()) {
                out_.complete = largest_slack() <= tolerance_;
                break;
            }
        }
        return std::move(out_);
    }

private:
    /// Multipliers that leave no slack, judged by the slacks that the point really has.
    void find_multipliers()
    {
        out_.multipliers.assign(normals_.size(), 0);
        double before = std::numeric_limits<double>::infinity();
        for (int round = 0; round <= sparse_refinements; ++round) {
            place_point();
            const double left = largest_slack();
            if (round > 0 && (left <= refined_enough * problem_.tolerance || left > before / 2)) return;
            before = left;
            std::vector<double> missing(normals_.size(), 0);
            for (std::size_t i = 0; i < missing.size(); ++i)
                if (is_active_[i]) missing[i] = -slack(problem_.half_spaces[i], out_.point) / normals_[i].length;
            const std::vector<double> more = factor_.multipliers(missing);
            for (std::size_t i = 0; i < more.size(); ++i) out_.multipliers[i] += more[i] / normals_[i].length;
        }
        place_point();
    }

    void place_point()
    {
        out_.point = problem_.start;
        for (std::size_t i = 0; i < normals_.size(); ++i)
            if (is_active_[i]) push(problem_.half_spaces[i], problem_.w, out_.multipliers[i], out_.point);
    }

    bool change_active()
    {
        bool some = false;
        for (std::size_t i = 0; i < is_active_.size(); ++i) {
            if (problem_.half_spaces[i].is_equality) continue;
            const bool wrong =
                is_active_[i] ? out_.multipliers[i] < 0 : slack(problem_.half_spaces[i], out_.point) < -tolerance_;
            if (!wrong) continue;
            is_active_[i] = !is_active_[i];
            some = true;
        }
        return some;
    }

    /// The largest slack of the active ones, in either direction.
    double largest_slack() const
    {
        double out = 0;
        for (std::size_t i = 0; i < normals_.size(); ++i) {
            if (!is_active_[i]) continue;
            out = std::max(out, std::abs(slack(problem_.half_spaces[i], out_.point)));
        }
        return out;
    }

    const ProjectionProblem& problem_;
    const std::vector<UnitNormal> normals_;
    ActiveFactor factor_;
    const double tolerance_;       ///< of slacks
    std::vector<char> is_active_;  ///< by half-space
    Projection out_;
};

}  // namespace

Projection primal_dual_active_set(const ProjectionProblem& problem, std::span<const double> guess)
{
    return PrimalDualActiveSet(problem, guess).solve();
}

}  // namespace carom
