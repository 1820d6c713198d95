#include "projection/dual_active_set.hpp"

#include "linear_algebra/thin_qr.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

/// The dual method on unit normals; numbers of steps and names are those of the paper. y is the way from the start in
/// the metric's own coordinates x_k / sqrt(w_k).
class DualActiveSet {
public:
    DualActiveSet(const ProjectionProblem& problem, const DualActiveSetOptions& options)
        : problem_(problem),
          options_(options),
          qr_(3 * static_cast<int>(problem.start.size())),
          y_(static_cast<std::size_t>(qr_.rows()), 0.0)
    {
        for (const HalfSpace& h : problem.half_spaces) {
            length_.push_back(std::sqrt(normal_length2(h, problem.w)));
            start_slack_.push_back(slack(h, problem.start) / length_.back());
        }
        for (const double w : problem.w) root_.push_back(std::sqrt(w));
        multiplier_.assign(length_.size(), 0);
        skipped_.assign(length_.size(), 0);
        steps_left_ = dual_steps + dual_steps_each * static_cast<int>(length_.size());
    }

    DualActiveSetResult solve()
    {
        for (std::size_t i = 0; i < count(); ++i)
            if (is_equality(i)) activate(static_cast<int>(i));
        for (int polishes = 0;; ++polishes) {
            for (auto p = most_violated(); p && out_.conflict.empty(); p = most_violated()) activate(*p);
            refine();
            if (polishes == dual_refinements || !out_.conflict.empty() || !most_violated()) break;
        }
        out_.projection.complete = out_.projection.complete && !most_violated();
        return std::move(out_);
    }

private:
    std::size_t count() const { return length_.size(); }
    bool is_equality(std::size_t i) const { return problem_.half_spaces[i].is_equality; }

    /// The half-space's normal in the metric's coordinates, of length 1.
    std::vector<double> unit_normal(int i) const
    {
        const HalfSpace& h = problem_.half_spaces[static_cast<std::size_t>(i)];
        const double length = length_[static_cast<std::size_t>(i)];
        std::vector<double> out(y_.size(), 0.0);
        for (int k = 0; k < 3; ++k) {
            out[static_cast<std::size_t>(3 * h.a + k)] = root_[static_cast<std::size_t>(h.a)] / length * h.normal[k];
            if (h.b)
                out[static_cast<std::size_t>(3 * *h.b + k)] =
                    -root_[static_cast<std::size_t>(*h.b)] / length * h.normal[k];
        }
        return out;
    }

    double unit_slack(int i) const
    {
        const HalfSpace& h = problem_.half_spaces[static_cast<std::size_t>(i)];
        double a = 0, b = 0;
        for (int k = 0; k < 3; ++k) {
            a += h.normal[k] * y_[static_cast<std::size_t>(3 * h.a + k)];
            if (h.b) b += h.normal[k] * y_[static_cast<std::size_t>(3 * *h.b + k)];
        }
        double moved = root_[static_cast<std::size_t>(h.a)] * a;
        if (h.b) moved -= root_[static_cast<std::size_t>(*h.b)] * b;
        return start_slack_[static_cast<std::size_t>(i)] + moved / length_[static_cast<std::size_t>(i)];
    }

    /// Step 1: the half-space to become active.
    std::optional<int> most_violated() const
    {
        std::optional<int> worst;
        double lowest = 0;
        for (std::size_t i = 0; i < count(); ++i) {
            if (skipped_[i] || is_equality(i)) continue;
            const double s = unit_slack(static_cast<int>(i));
            if (s < lowest && !is_satisfied(s, i, 1, 1)) {
                lowest = s;
                worst = static_cast<int>(i);
            }
        }
        return worst;
    }

    /// Step 2: half-space p becomes active, others may leave.
    void activate(int p)
    {
        double entering = multiplier_[static_cast<std::size_t>(p)];
        // One that is active and violated only by rounding is left to the refinement.
        if (std::find(active_.begin(), active_.end(), p) != active_.end()) return skip(p);
        const std::vector<double> normal = unit_normal(p);
        while (steps_left_-- > 0) {
            const ThinQr::Split split = qr_.split(normal);
            const bool is_dependent = split.residual_norm2 <= problem_.dependent * problem_.dependent;
            // A coefficient that rounding leaves of a zero must not block, for a normal that depends on the active
            // ones.
            double least = 0;
            if (is_dependent)
                for (const double c : split.coefficients)
                    least = std::max({least, problem_.dependent, problem_.dependent * std::abs(c)});
            std::optional<std::size_t> blocking;
            double dual_step = 0;
            for (std::size_t j = 0; j < active_.size(); ++j) {
                if (split.coefficients[j] <= least || is_equality(static_cast<std::size_t>(active_[j]))) continue;
                const double step = multiplier_[static_cast<std::size_t>(active_[j])] / split.coefficients[j];
                if (!blocking || step < dual_step) {
                    blocking = j;
                    dual_step = step;
                }
            }
            if (is_dependent && !blocking) return found_conflict(p, split.coefficients);
            const double missing = -unit_slack(p);
            const double primal_step =
                is_dependent ? 0
                             : (is_equality(static_cast<std::size_t>(p)) ? missing : std::max(0.0, missing)) /
                                   split.residual_norm2;
            const bool whole = !is_dependent && (!blocking || primal_step <= dual_step);
            const double step = whole ? primal_step : dual_step;
            entering += step;
            for (std::size_t j = 0; j < active_.size(); ++j) {
                const auto k = static_cast<std::size_t>(active_[j]);
                multiplier_[k] = allowed(k, multiplier_[k] - step * split.coefficients[j]);
            }
            if (!is_dependent)
                for (std::size_t i = 0; i < y_.size(); ++i) y_[i] += step * split.residual[i];
            if (whole) {
                multiplier_[static_cast<std::size_t>(p)] = entering;
                active_.push_back(p);
                ++out_.projection.steps;
                qr_.append(split);
                return too_far();
            }
            multiplier_[static_cast<std::size_t>(active_[*blocking])] = 0;
            active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(*blocking));
            qr_.remove(static_cast<int>(*blocking));
        }
        skip(p);
        out_.projection.complete = false;
    }

    double allowed(std::size_t i, double multiplier) const
    {
        return is_equality(i) ? multiplier : std::max(0.0, multiplier);
    }

    void skip(int p) { skipped_[static_cast<std::size_t>(p)] = 1; }

    void found_conflict(int p, const std::vector<double>& coefficients)
    {
        // Rounding, if the half-spaces are a cone: such a normal is minus a sum of active ones, its slack minus that of
        // their zeros.
        skip(p);
        if (is_equality(static_cast<std::size_t>(p))) return;
        std::vector<int> bound{p};
        for (std::size_t j = 0; j < active_.size(); ++j)
            if (coefficients[j] < -problem_.dependent && !is_equality(static_cast<std::size_t>(active_[j])))
                bound.push_back(active_[j]);
        out_.projection.bound.insert(out_.projection.bound.end(), bound.begin(), bound.end());
        if (is_satisfied(unit_slack(p), static_cast<std::size_t>(p), missed_by_dependent, missed_units_by_dependent))
            return;
        out_.conflict = std::move(bound);
        out_.projection.complete = false;
    }

    bool is_satisfied(double unit_slack, std::size_t i, double tolerances, double unit_tolerances) const
    {
        return unit_slack >=
               -std::max(tolerances * problem_.tolerance / length_[i], unit_tolerances * options_.unit_tolerance);
    }

    void too_far()
    {
        double distance2 = 0;
        for (const double value : y_) distance2 += value * value;
        if (distance2 <= options_.largest_distance * options_.largest_distance) return;
        double largest = 0;
        for (const int i : active_) largest = std::max(largest, multiplier_[static_cast<std::size_t>(i)]);
        for (const int i : active_)
            if (multiplier_[static_cast<std::size_t>(i)] > problem_.dependent * largest) out_.conflict.push_back(i);
        out_.projection.complete = false;
    }

    /// Computes the point anew from the multipliers, and corrects these until the slacks that it really has are zero.
    void refine()
    {
        Projection& result = out_.projection;
        for (int round = 0;; ++round) {
            result.point = problem_.start;
            result.multipliers.assign(count(), 0);
            for (const int i : active_) {
                const auto k = static_cast<std::size_t>(i);
                result.multipliers[k] = multiplier_[k] / length_[k];
                push(problem_.half_spaces[k], problem_.w, result.multipliers[k], result.point);
            }
            if (round == dual_refinements || active_.empty()) break;
            std::vector<double> missing;
            for (const int i : active_) {
                const auto k = static_cast<std::size_t>(i);
                missing.push_back(-slack(problem_.half_spaces[k], result.point) / length_[k]);
            }
            const std::vector<double> correction = qr_.solve_normal(missing);
            for (std::size_t j = 0; j < active_.size(); ++j) {
                const auto k = static_cast<std::size_t>(active_[j]);
                multiplier_[k] = allowed(k, multiplier_[k] + correction[j]);
            }
        }
        for (std::size_t k = 0; k < root_.size(); ++k)
            for (int c = 0; c < 3; ++c)
                y_[3 * k + static_cast<std::size_t>(c)] = (result.point[k][c] - problem_.start[k][c]) / root_[k];
    }

    const ProjectionProblem& problem_;
    DualActiveSetOptions options_;
    ThinQr qr_;                                 ///< of the active unit normals
    std::vector<double> y_, root_;              ///< sqrt(w)
    std::vector<double> length_, start_slack_;  ///< by half-space
    std::vector<double> multiplier_;            ///< of unit normals
    std::vector<char> skipped_;
    std::vector<int> active_;
    int steps_left_ = 0;
    DualActiveSetResult out_;
};

}  // namespace

DualActiveSetResult dual_active_set(const ProjectionProblem& problem, const DualActiveSetOptions& options)
{
    return DualActiveSet(problem, options).solve();
}

}  // namespace carom
