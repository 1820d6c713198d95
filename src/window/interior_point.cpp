#include "window/interior_point.hpp"

#include "projection/unit_normals.hpp"
#include "window/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

using Vector = BlockCholesky::Vector;
using Scalars = std::vector<double>;

std::vector<std::pair<int, int>> edges_of(const ProjectionProblem& problem)
{
    std::vector<std::pair<int, int>> out;
    for (const HalfSpace& h : problem.half_spaces)
        if (h.b) out.emplace_back(std::min(h.a, *h.b), std::max(h.a, *h.b));
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

/// The longest part of a step, up to 1, that keeps all values >= 0.
double longest(const Scalars& value, const Scalars& change)
{
    double out = 1;
    for (std::size_t i = 0; i < value.size(); ++i)
        if (change[i] < 0) out = std::min(out, -value[i] / change[i]);
    return out;
}

double mean_product(const Scalars& s, const Scalars& l, const Scalars& ds, const Scalars& dl, double part_s,
                    double part_l)
{
    double sum = 0;
    for (std::size_t i = 0; i < s.size(); ++i) sum += (s[i] + part_s * ds[i]) * (l[i] + part_l * dl[i]);
    return sum / static_cast<double>(s.size());
}

/// Slacks s and multipliers l > 0 with s = A y + t and y = A^T l in the end.
class InteriorPoint {
public:
    InteriorPoint(const ProjectionProblem& problem, double scale)
        : normals_(unit_normals(problem)),
          y_(problem.start.size(), Vector{}),
          m_(normals_.size()),
          offset_(m_),
          s_(m_),
          l_(m_, first_multiplier),
          ds_(m_),
          dl_(m_),
          primal_(m_),
          best_(m_),
          best_slacks_(m_),
          factor_(static_cast<int>(problem.start.size()), edges_of(problem))
    {
        for (std::size_t i = 0; i < m_; ++i) {
            offset_[i] = slack(problem.half_spaces[i], problem.start) / (normals_[i].length * scale);
            normals_[i].add_to(y_, l_[i]);
        }
        for (std::size_t i = 0; i < m_; ++i) s_[i] = std::max(normals_[i].dot(y_) + offset_[i], first_slack);
    }

    bool solve()
    {
        int stalled = 0;
        for (; steps_ < most_interior_steps; ++steps_) {
            double sum = 0, miss = 0;
            UnitVectors pushed(y_.size(), Vector{});
            for (std::size_t i = 0; i < m_; ++i) {
                s_[i] = std::max(s_[i], l_[i] / largest_stiffness);
                primal_[i] = normals_[i].dot(y_) + offset_[i] - s_[i];
                miss = std::max(miss, std::abs(primal_[i]));
                sum += s_[i] * l_[i];
                normals_[i].add_to(pushed, l_[i]);
            }
            for (std::size_t k = 0; k < y_.size(); ++k)
                for (std::size_t c = 0; c < 3; ++c) miss = std::max(miss, std::abs(y_[k][c] - pushed[k][c]));
            const double mu = sum / static_cast<double>(m_),
                         error = std::max(mu / interior_complementarity, miss / interior_miss);
            // Not a number: rounding has the last word where forces are huge, and the best step before it counts.
            if (!(error < best_error_ * interior_diverges)) return polish();
            ++stalled;
            if (error < best_error_) {
                stalled = 0;
                best_error_ = error;
                best_ = l_;
                best_slacks_ = s_;
            }
            if (error < 1 || stalled > most_stalls) return polish();
            step(mu);
        }
        return polish();
    }

    double multiplier(std::size_t i, double scale) const { return best_[i] * scale / normals_[i].length; }
    int steps() const { return steps_; }

private:
    /// The largest violation of a slack, and the largest slack that has a multiplier, where multipliers alone make the
    /// point.
    double miss_of(const Scalars& l) const
    {
        UnitVectors y(y_.size(), Vector{});
        for (std::size_t i = 0; i < m_; ++i) normals_[i].add_to(y, l[i]);
        double out = 0;
        for (std::size_t i = 0; i < m_; ++i) {
            const double slack = normals_[i].dot(y) + offset_[i];
            out = std::max(out, best_[i] > best_slacks_[i] ? std::abs(slack) : -slack);
        }
        return out;
    }

    /// Near the end the multipliers of half-spaces that bound the point carry the rounding of slacks that are almost 0.
    /// The method of multipliers with a moderate weight finds them anew; half-spaces that do not bound it lose theirs.
    bool polish()
    {
        Scalars l(m_, 0);
        columns_.clear();
        for (std::size_t i = 0; i < m_; ++i) {
            if (best_[i] < negligible_multiplier * best_slacks_[i]) best_[i] = 0;
            const bool bounds = best_[i] > best_slacks_[i];
            l[i] = best_[i];
            columns_.push_back(normals_[i].scaled(bounds ? std::sqrt(polishing_weight) : 0));
        }
        factor_.factor(columns_);
        UnitVectors y(y_.size(), Vector{});
        for (std::size_t i = 0; i < m_; ++i) normals_[i].add_to(y, l[i]);
        double least = miss_of(best_);
        for (int round = 0; round < most_polishing_rounds && least > polished_enough; ++round) {
            UnitVectors change(y_.size(), Vector{});
            for (std::size_t k = 0; k < y.size(); ++k)
                for (std::size_t c = 0; c < 3; ++c) change[k][c] = -y[k][c];
            for (std::size_t i = 0; i < m_; ++i) {
                const bool bounds = best_[i] > best_slacks_[i];
                normals_[i].add_to(change, l[i] - (bounds ? polishing_weight * (normals_[i].dot(y) + offset_[i]) : 0));
            }
            factor_.solve(change);
            for (std::size_t k = 0; k < y.size(); ++k)
                for (std::size_t c = 0; c < 3; ++c) y[k][c] += change[k][c];
            for (std::size_t i = 0; i < m_; ++i)
                if (best_[i] > best_slacks_[i])
                    l[i] = std::max(0.0, l[i] - polishing_weight * (normals_[i].dot(y) + offset_[i]));
            const double miss = miss_of(l);
            if (miss < least) {
                least = miss;
                polished_ = l;
            }
        }
        if (!polished_.empty()) best_ = polished_;
        return least < interior_accuracy;
    }

    void step(double mu)
    {
        columns_.clear();
        for (std::size_t i = 0; i < m_; ++i) columns_.push_back(normals_[i].scaled(std::sqrt(l_[i] / s_[i])));
        factor_.factor(columns_);
        Scalars wanted(m_);
        for (std::size_t i = 0; i < m_; ++i) wanted[i] = -s_[i] * l_[i];
        direction(wanted);
        const double predicted = mean_product(s_, l_, ds_, dl_, longest(s_, ds_), longest(l_, dl_));
        const double ratio = predicted / mu, centring = ratio * ratio * ratio;
        for (std::size_t i = 0; i < m_; ++i) wanted[i] = centring * mu - s_[i] * l_[i] - ds_[i] * dl_[i];
        direction(wanted);
        const double part = std::min(1.0, interior_step * std::min(longest(s_, ds_), longest(l_, dl_)));
        for (std::size_t i = 0; i < m_; ++i) {
            s_[i] += part * ds_[i];
            l_[i] += part * dl_[i];
        }
        for (std::size_t k = 0; k < y_.size(); ++k)
            for (std::size_t c = 0; c < 3; ++c) y_[k][c] += part * dy_[k][c];
    }

    /// The Newton step to s l = s l + wanted, (1 + A^T D A) dy = A^T l - y + A^T (wanted - l primal) / s, D = l / s.
    void direction(const Scalars& wanted)
    {
        UnitVectors right(y_.size(), Vector{});
        for (std::size_t k = 0; k < y_.size(); ++k)
            for (std::size_t c = 0; c < 3; ++c) right[k][c] = -y_[k][c];
        for (std::size_t i = 0; i < m_; ++i)
            normals_[i].add_to(right, l_[i] + (wanted[i] - l_[i] * primal_[i]) / s_[i]);
        dy_ = right;
        factor_.solve(dy_);
        UnitVectors left = right;  // one refinement
        for (std::size_t k = 0; k < y_.size(); ++k)
            for (std::size_t c = 0; c < 3; ++c) left[k][c] -= dy_[k][c];
        for (std::size_t i = 0; i < m_; ++i) normals_[i].add_to(left, -(l_[i] / s_[i]) * normals_[i].dot(dy_));
        factor_.solve(left);
        for (std::size_t k = 0; k < y_.size(); ++k)
            for (std::size_t c = 0; c < 3; ++c) dy_[k][c] += left[k][c];
        for (std::size_t i = 0; i < m_; ++i) {
            ds_[i] = normals_[i].dot(dy_) + primal_[i];
            dl_[i] = (wanted[i] - l_[i] * ds_[i]) / s_[i];
        }
    }

    std::vector<UnitNormal> normals_;
    UnitVectors y_, dy_;
    std::size_t m_;
    Scalars offset_, s_, l_, ds_, dl_, primal_;
    Scalars best_, best_slacks_;  ///< multipliers and slacks of the least error
    Scalars polished_;
    BlockCholesky factor_;
    std::vector<BlockCholesky::Column> columns_;
    double best_error_ = std::numeric_limits<double>::max() / interior_diverges;
    int steps_ = 0;
};

}  // namespace

Projection interior_point(const ProjectionProblem& problem, double scale)
{
    Projection out;
    out.point = problem.start;
    out.multipliers.assign(problem.half_spaces.size(), 0);
    if (problem.half_spaces.empty()) return out;
    InteriorPoint solver(problem, scale);
    out.complete = solver.solve();
    out.steps = solver.steps();
    for (std::size_t i = 0; i < problem.half_spaces.size(); ++i) {
        out.multipliers[i] = solver.multiplier(i, scale);
        push(problem.half_spaces[i], problem.w, out.multipliers[i], out.point);
    }
    return out;
}

}  // namespace carom
