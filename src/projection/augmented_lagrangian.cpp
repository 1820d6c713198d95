#include "projection/augmented_lagrangian.hpp"

#include "projection/active_factor.hpp"
#include "projection/line_search.hpp"
#include "projection/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

class AugmentedLagrangian {
public:
    explicit AugmentedLagrangian(const ProjectionProblem& problem)
        : problem_(problem),
          normals_(unit_normals(problem)),
          factor_(problem.start.size(), normals_),
          slack_(normals_.size())
    {
        factor_.take_epsilon(first_epsilon);
    }

    AugmentedLagrangianResult solve(std::span<const double> guess)
    {
        for (std::size_t i = 0; i < normals_.size(); ++i)
            multiplier_.push_back(std::max(0.0, guess[i] * normals_[i].length));
        place_point();
        double error = largest_error();
        bool improves = true;
        for (int round = 0; round < most_penalty_rounds && out_.newton_steps < most_newton_steps; ++round) {
            // Once good enough, further rounds cost a solve each; go on as long as they pay.
            if (is_solved(1) || (is_solved(sparse_tolerances) && !improves)) break;
            const int before = out_.newton_steps;
            const bool converged = minimise();
            const bool was_easy = converged && out_.newton_steps - before <= easy_round;
            place_point();
            const double left = largest_error();
            if (was_easy && left > good_round * error && factor_.epsilon() > small_epsilon)
                factor_.take_epsilon(std::max(small_epsilon, epsilon_factor * factor_.epsilon()));
            improves = left < error / 2;
            error = left;
        }
        out_.projection.steps = out_.newton_steps;
        out_.projection.complete = is_solved(sparse_tolerances);
        out_.factorisations = factor_.factorisations();
        out_.updates = factor_.updates();
        return std::move(out_);
    }

private:
    /// The point that the multipliers give, and the slacks that it really has. Half a tolerance is granted to all, so
    /// that what only touches does not come and go with rounding.
    void place_point()
    {
        Projection& result = out_.projection;
        result.point = problem_.start;
        result.multipliers.assign(normals_.size(), 0);
        for (std::size_t i = 0; i < normals_.size(); ++i) {
            if (multiplier_[i] == 0) continue;
            result.multipliers[i] = multiplier_[i] / normals_[i].length;
            push(problem_.half_spaces[i], problem_.w, result.multipliers[i], result.point);
        }
        for (std::size_t i = 0; i < normals_.size(); ++i)
            slack_[i] = (slack(problem_.half_spaces[i], result.point) + problem_.tolerance / 2) / normals_[i].length;
    }

    double error(std::size_t i) const { return multiplier_[i] > 0 ? std::abs(slack_[i]) : -slack_[i]; }

    double largest_error() const
    {
        double out = 0;
        for (std::size_t i = 0; i < normals_.size(); ++i) out = std::max(out, error(i));
        return out;
    }

    bool is_solved(double within) const
    {
        for (std::size_t i = 0; i < normals_.size(); ++i)
            if (error(i) * normals_[i].length > within * problem_.tolerance) return false;
        return true;
    }

    /// min over y of |y|^2 / 2 + epsilon/2 sum max(0, t_i)^2, t_i = multiplier_i - slack_i / epsilon; multipliers <-
    /// the positive t_i. \returns whether the minimum was reached
    bool minimise()
    {
        const double epsilon = factor_.epsilon();
        UnitVectors y(problem_.start.size(), BlockCholesky::Vector{});
        std::vector<double> t(normals_.size()), rate(normals_.size());
        for (std::size_t i = 0; i < normals_.size(); ++i) {
            if (multiplier_[i] > 0) normals_[i].add_to(y, multiplier_[i]);
            t[i] = multiplier_[i] - slack_[i] / epsilon;
        }
        bool whole_step = false, converged = false;
        for (int step = 0; step < most_newton_steps_a_round && !converged; ++step) {
            UnitVectors gradient = y;
            double size = 0;
            std::vector<char> active(normals_.size(), 0);
            for (std::size_t i = 0; i < normals_.size(); ++i) {
                if (t[i] <= 0) continue;
                active[i] = 1;
                normals_[i].add_to(gradient, -t[i]);
                size = std::max(size, t[i]);
            }
            const bool same_set = factor_.is_of(active);
            converged = step > 0 && ((same_set && whole_step) || largest(gradient) <= gradient_rounding * size);
            if (converged) break;
            factor_.follow(active);
            factor_.solve(gradient);
            for (BlockCholesky::Vector& d : gradient)
                for (double& x : d) x = -x;
            const UnitVectors& direction = gradient;
            for (std::size_t i = 0; i < normals_.size(); ++i) rate[i] = normals_[i].dot(direction);
            const double tau = line_search(y, direction, t, rate, epsilon);
            whole_step = std::abs(tau - 1) < whole_step_rounding;
            for (std::size_t k = 0; k < y.size(); ++k)
                for (std::size_t c = 0; c < 3; ++c) y[k][c] += tau * direction[k][c];
            for (std::size_t i = 0; i < normals_.size(); ++i) {
                slack_[i] += tau * rate[i];
                t[i] = multiplier_[i] - slack_[i] / epsilon;
            }
            ++out_.newton_steps;
        }
        for (std::size_t i = 0; i < normals_.size(); ++i) multiplier_[i] = std::max(0.0, t[i]);
        return converged;
    }

    static double largest(const UnitVectors& vectors)
    {
        double out = 0;
        for (const BlockCholesky::Vector& v : vectors)
            for (const double x : v) out = std::max(out, std::abs(x));
        return out;
    }

    const ProjectionProblem& problem_;
    const std::vector<UnitNormal> normals_;
    ActiveFactor factor_;
    std::vector<double> multiplier_, slack_;  ///< of unit normals
    AugmentedLagrangianResult out_;
};

}  // namespace

AugmentedLagrangianResult augmented_lagrangian(const ProjectionProblem& problem, std::span<const double> guess)
{
    return AugmentedLagrangian(problem).solve(guess);
}

}  // namespace carom
