#include "window/relaxation.hpp"

#include "window/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

void push(const RelaxationRow& row, double impulse, std::vector<Vec3>& u)
{
    u[at(row.a)] += (impulse * row.weight_a) * row.normal;
    u[at(row.b)] -= (impulse * row.weight_b) * row.normal;
}

void set_multiplier(RelaxationRow& row, double multiplier, std::vector<Vec3>& u)
{
    const double change = std::max(0.0, multiplier) - row.multiplier;
    if (change == 0) return;
    row.multiplier += change;
    if (row.multiplier < 0) row.multiplier = 0;
    push(row, change, u);
}

class Relaxation {
public:
    Relaxation(std::vector<RelaxationRow>& rows, std::vector<Vec3>& u) : rows_(rows), u_(u), wrong_(u.size()) {}

    /// Marks bodies of contacts that are wrong and lists the contacts of these. \returns whether all are right
    bool examine(double tolerance)
    {
        std::fill(wrong_.begin(), wrong_.end(), char{0});
        feasible_ = true;
        bool right = true;
        for (const RelaxationRow& row : rows_) {
            const double now = rate(row, u_), missing = row.wanted - now;
            const bool overlaps = now < row.least;
            if (overlaps) feasible_ = false;
            if (!overlaps && !((row.multiplier > 0 ? std::abs(missing) : missing) > tolerance)) continue;
            right = false;
            if (row.weight_a > 0) wrong_[at(row.a)] = 1;
            if (row.weight_b > 0) wrong_[at(row.b)] = 1;
        }
        if (right) return true;
        active_.clear();
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            if (!wrong_[at(rows_[i].a)] && !wrong_[at(rows_[i].b)]) continue;
            active_.push_back(i);
            rows_[i].search = 0;
        }
        return false;
    }

    void sweep(int count)
    {
        double last = 0;
        for (int k = 0; k < count; ++k) {
            double square = 0;
            const std::size_t size = active_.size();
            for (std::size_t j = 0; j < size; ++j) square += relax_one(rows_[active_[k % 2 ? size - 1 - j : j]]);
            const bool restarts = !(last > 0) || square > last;
            const double beta = restarts ? 0 : square / last;
            last = square;
            const bool extrapolates = !restarts && k + 1 < count;
            for (const std::size_t i : active_) {
                RelaxationRow& row = rows_[i];
                const double along = beta * row.search;
                if (extrapolates) set_multiplier(row, row.multiplier + along, u_);
                row.search = restarts ? row.change : along + row.change;
            }
        }
    }

    bool feasible() const { return feasible_; }
    long active() const { return static_cast<long>(active_.size()); }

private:
    /// \returns the square of the change in the metric of kinetic energy
    double relax_one(RelaxationRow& row)
    {
        const double weight = row.weight_a + row.weight_b, before = row.multiplier;
        set_multiplier(row, before + (row.wanted - rate(row, u_)) / weight, u_);
        row.change = row.multiplier - before;
        return row.change * row.change * weight;
    }

    std::vector<RelaxationRow>& rows_;
    std::vector<Vec3>& u_;
    std::vector<char> wrong_;
    std::vector<std::size_t> active_;
    bool feasible_ = false;
};

}  // namespace

RelaxationReport relax(std::vector<RelaxationRow>& rows, std::vector<Vec3>& u, const RelaxationOptions& options)
{
    Relaxation relaxation(rows, u);
    RelaxationReport out;
    for (int round = 0;; ++round) {
        if (relaxation.examine(options.tolerance) || out.sweeps >= options.most_sweeps) break;
        const int count = first_round_of_sweeps + round_growth * round;
        relaxation.sweep(count);
        out.sweeps += count;
        out.relaxations += count * relaxation.active();
    }
    out.feasible = relaxation.feasible();
    return out;
}

}  // namespace carom
