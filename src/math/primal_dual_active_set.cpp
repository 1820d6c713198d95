#include "math/primal_dual_active_set.hpp"

#include <cmath>

namespace carom {

namespace {

constexpr int most_rounds = 8;
constexpr int refinements = 2;
/// Pivots of the matrix of unit normals; smaller ones leave too few digits for the refinements to mend.
constexpr double least_pivot = 1e-8;

class PrimalDualActiveSet {
public:
    PrimalDualActiveSet(const ProjectionProblem& problem, std::span<const double> guess) : problem_(problem)
    {
        for (const HalfSpace& h : problem.half_spaces) length_.push_back(std::sqrt(normal_length2(h, problem.w)));
        for (const double multiplier : guess) is_active_.push_back(multiplier > 0);
        out_.multipliers.assign(length_.size(), 0);
        out_.complete = false;
    }

    Projection solve()
    {
        for (out_.steps = 1; out_.steps <= most_rounds; ++out_.steps) {
            list_active();
            if (!factor()) break;
            find_multipliers();
            if (!change_active()) {
                out_.complete = is_tight();
                break;
            }
        }
        return std::move(out_);
    }

private:
    std::size_t count() const { return active_.size(); }
    const HalfSpace& half_space(std::size_t k) const { return problem_.half_spaces[active_[k]]; }

    void list_active()
    {
        active_.clear();
        for (std::size_t i = 0; i < is_active_.size(); ++i)
            if (is_active_[i]) active_.push_back(i);
    }

    /// Of two different normals, made unit.
    double product(std::size_t k, std::size_t l) const
    {
        const HalfSpace &x = half_space(k), &y = half_space(l);
        double along = 0;
        const auto add = [&](int v, double sign) { along += sign * problem_.w[static_cast<std::size_t>(v)]; };
        if (x.a == y.a) add(x.a, 1);
        if (x.b >= 0 && x.b == y.b) add(x.b, 1);
        if (x.a == y.b) add(x.a, -1);
        if (x.b >= 0 && x.b == y.a) add(x.b, -1);
        return along == 0 ? 0 : along * x.normal.dot(y.normal) / (length_[active_[k]] * length_[active_[l]]);
    }

    /// L D L^T of the products, column by column. \returns false where normals depend on each other
    bool factor()
    {
        const std::size_t n = count();
        factor_.assign(n * n, 0);
        for (std::size_t j = 0; j < n; ++j) {
            factor_[j * n + j] = 1;
            for (std::size_t i = j + 1; i < n; ++i) factor_[j * n + i] = product(i, j);
        }
        for (std::size_t j = 0; j < n; ++j) {
            const double pivot = factor_[j * n + j];
            if (!(pivot > least_pivot)) return false;
            const double* column = &factor_[j * n];
            for (std::size_t k = j + 1; k < n; ++k) {
                if (column[k] == 0) continue;
                const double ratio = column[k] / pivot;
                double* below = &factor_[k * n];
                for (std::size_t i = k; i < n; ++i) below[i] -= ratio * column[i];
            }
        }
        return true;
    }

    /// With what factor() leaves: columns of L times D.
    void solve_factored(std::vector<double>& x) const
    {
        const std::size_t n = count();
        for (std::size_t j = 0; j < n; ++j) {
            const double* column = &factor_[j * n];
            x[j] /= column[j];
            for (std::size_t i = j + 1; i < n; ++i) x[i] -= column[i] * x[j];
        }
        for (std::size_t j = n; j-- > 0;) {
            const double* column = &factor_[j * n];
            double sum = 0;
            for (std::size_t i = j + 1; i < n; ++i) sum += column[i] * x[i];
            x[j] -= sum / column[j];
        }
    }

    /// That leave no slack, by the slacks that the point really has.
    void find_multipliers()
    {
        out_.multipliers.assign(length_.size(), 0);
        for (int round = 0; round <= refinements; ++round) {
            place_point();
            std::vector<double> missing;
            for (std::size_t k = 0; k < count(); ++k)
                missing.push_back(-slack(half_space(k), out_.point) / length_[active_[k]]);
            solve_factored(missing);
            for (std::size_t k = 0; k < count(); ++k)
                out_.multipliers[active_[k]] += missing[k] / length_[active_[k]];
        }
        place_point();
    }

    void place_point()
    {
        out_.point = problem_.start;
        for (std::size_t k = 0; k < count(); ++k)
            push(half_space(k), problem_.w, out_.multipliers[active_[k]], out_.point);
    }

    bool change_active()
    {
        bool some = false;
        for (std::size_t i = 0; i < is_active_.size(); ++i) {
            const bool wrong = is_active_[i] ? out_.multipliers[i] < 0
                                             : slack(problem_.half_spaces[i], out_.point) < -problem_.tolerance;
            if (!wrong) continue;
            is_active_[i] = !is_active_[i];
            some = true;
        }
        return some;
    }

    bool is_tight() const
    {
        for (std::size_t k = 0; k < count(); ++k)
            if (!(std::abs(slack(half_space(k), out_.point)) <= problem_.tolerance)) return false;
        return true;
    }

    const ProjectionProblem& problem_;
    std::vector<double> length_;      ///< of the normals in the metric, by half-space
    std::vector<char> is_active_;     ///< by half-space
    std::vector<std::size_t> active_;
    std::vector<double> factor_;      ///< lower triangle by columns
    Projection out_;
};

}  // namespace

Projection primal_dual_active_set(const ProjectionProblem& problem, std::span<const double> guess)
{
    return PrimalDualActiveSet(problem, guess).solve();
}

}  // namespace carom
