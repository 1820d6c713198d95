#include "projection/shortest_change.hpp"

#include "projection/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace carom {

namespace {

using Numbers = std::vector<double>;

double product(const Numbers& x, const Numbers& y)
{
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
    return sum;
}

double product(const UnitVectors& x, const UnitVectors& y)
{
    double sum = 0;
    for (std::size_t k = 0; k < x.size(); ++k) sum += x[k][0] * y[k][0] + x[k][1] * y[k][1] + x[k][2] * y[k][2];
    return sum;
}

/// x + factor * y
template <class Values>
Values sum(Values x, double factor, const Values& y)
{
    for (std::size_t k = 0; k < x.size(); ++k) {
        if constexpr (std::is_same_v<Values, Numbers>)
            x[k] += factor * y[k];
        else
            for (std::size_t c = 0; c < 3; ++c) x[k][c] += factor * y[k][c];
    }
    return x;
}

class Search {
public:
    Search(std::span<const UnitNormal> normals, const std::vector<char>& active, std::size_t vectors,
           const ShortestChangeOptions& options)
        : normals_(normals), active_(active), vectors_(vectors), options_(options)
    {
    }

    ShortestChange go(std::span<const double> wanted) const
    {
        Numbers residual(normals_.size(), 0);
        for (std::size_t i = 0; i < residual.size(); ++i)
            if (active_[i]) residual[i] = wanted[i];
        // change = sum x_i a_i and direction = sum combination_i a_i, throughout.
        UnitVectors change(vectors_, BlockCholesky::Vector{});
        Numbers x(residual.size(), 0);
        UnitVectors gradient = transposed_times(residual);
        Step next = preconditioned(gradient, residual);
        Step step = next;
        double size = product(gradient, next.direction);
        double left = product(residual, residual), slope = product(gradient, gradient);  // the least so far
        const double enough = searched_enough * left, hardly = unmended * left;
        const std::size_t most = search_steps + search_steps_each * (residual.size() + 3 * vectors_);
        double share = 1, shares = 0;  // of what no change can mend, in the multipliers
        for (std::size_t n = 0; n < most && slope > enough; ++n) {
            const Numbers image = times(step.direction);
            const double length = size / product(image, image);
            // Exactly, every step shrinks the residual by length * size.
            Numbers next_residual = sum(residual, -length, image);
            const double next_left = product(next_residual, next_residual);
            UnitVectors next_change = sum(change, length, step.direction);
            if (goes_too_far(next_change)) break;
            change = std::move(next_change);
            x = sum(std::move(x), length, step.combination);
            shares += length * share;
            residual = std::move(next_residual);
            gradient = transposed_times(residual);
            const double next_slope = product(gradient, gradient);
            // The residual may be all that cannot be mended; then its gradient tells.
            if (!(next_left < left || next_slope < slope)) break;
            left = std::min(left, next_left);
            slope = std::min(slope, next_slope);
            next = preconditioned(gradient, residual);
            const double next_size = product(gradient, next.direction), ratio = next_size / size;
            step.direction = sum(std::move(next.direction), ratio, step.direction);
            step.combination = sum(std::move(next.combination), ratio, step.combination);
            share = 1 + ratio * share;
            size = next_size;
        }
        // Without a factor combinations begin as residuals, and what is left of these at the end changes nothing: it
        // goes, if the search came so close that it really changes nothing.
        if (!options_.factor && left > hardly &&
            shares * std::sqrt(slope) <= negligible_change * std::sqrt(product(change, change))) {
            x = sum(std::move(x), -shares, residual);
            change = sum(std::move(change), -shares, gradient);
        }
        return {std::move(change), std::move(x)};
    }

private:
    struct Step {
        UnitVectors direction;
        Numbers combination;
    };

    Numbers times(const UnitVectors& y) const
    {
        Numbers out(normals_.size(), 0);
        for (std::size_t i = 0; i < normals_.size(); ++i)
            if (active_[i]) out[i] = normals_[i].dot(y);
        return out;
    }

    UnitVectors transposed_times(const Numbers& x) const
    {
        UnitVectors out(vectors_, BlockCholesky::Vector{});
        for (std::size_t i = 0; i < normals_.size(); ++i)
            if (active_[i]) normals_[i].add_to(out, x[i]);
        return out;
    }

    /// The step A (small_epsilon I + A^T A)^-2 A^T r for the residual r, A = (a_1 a_2 ...)^T. One inverse would do, but
    /// not without numbers of the size of what cannot be mended over epsilon.
    Step preconditioned(const UnitVectors& gradient, const Numbers& residual) const
    {
        if (!options_.factor) return {gradient, residual};
        UnitVectors twice = gradient;
        options_.factor->solve(twice);
        options_.factor->solve(twice);
        for (BlockCholesky::Vector& d : twice)
            for (double& each : d) each /= small_epsilon * small_epsilon;
        Numbers combination = times(twice);
        return {transposed_times(combination), std::move(combination)};
    }

    bool goes_too_far(const UnitVectors& change) const
    {
        for (std::size_t k = 0; k < options_.furthest.size(); ++k) {
            const BlockCholesky::Vector& y = change[k];
            if (!(std::sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2]) <= options_.furthest[k])) return true;
        }
        return false;
    }

    std::span<const UnitNormal> normals_;
    const std::vector<char>& active_;
    const std::size_t vectors_;
    const ShortestChangeOptions& options_;
};

}  // namespace

ShortestChange shortest_change(std::span<const UnitNormal> normals, const std::vector<char>& active,
                               std::span<const double> wanted, std::size_t vectors,
                               const ShortestChangeOptions& options)
{
    return Search(normals, active, vectors, options).go(wanted);
}

}  // namespace carom
