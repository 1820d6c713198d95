#include "impact/turns.hpp"

#include "impact/tolerances.hpp"
#include "projection/unit_normals.hpp"

#include <cmath>
#include <vector>

namespace carom {

namespace {

/// Coordinates of the plane along the first normal and square to it.
struct InPlane {
    double p = 0, q = 0;
};

double length(const InPlane& x)
{
    return std::sqrt(x.p * x.p + x.q * x.q);
}

/// Rotation by an angle of this cosine and sine.
struct Rotation {
    double cosine = 1, sine = 0;

    InPlane operator()(const InPlane& x) const { return {cosine * x.p - sine * x.q, sine * x.p + cosine * x.q}; }
    /// The same twice, of length 1 again: rounding of it would double each time.
    Rotation twice() const
    {
        const InPlane square{(cosine - sine) * (cosine + sine), 2 * sine * cosine};
        return {square.p / length(square), square.q / length(square)};
    }
};

double product(const UnitVectors& x, const UnitVectors& y)
{
    double sum = 0;
    for (std::size_t k = 0; k < x.size(); ++k) sum += x[k][0] * y[k][0] + x[k][1] * y[k][1] + x[k][2] * y[k][2];
    return sum;
}

/// The plane of two unit normals. Of nearly opposite ones the sum is what is known well: 1 + cosine = |sum|^2 / 2.
class Plane {
public:
    Plane(const ProjectionProblem& at, const UnitNormal& first, const UnitNormal& second)
        : sum_(at.start.size(), BlockCholesky::Vector{})
    {
        first.add_to(sum_, 1);
        second.add_to(sum_, 1);
        beyond_ = product(sum_, sum_) / 2;
        sine_ = std::sqrt(beyond_ * (2 - beyond_));
    }

    double cosine() const { return beyond_ - 1; }
    double sine() const { return sine_; }
    /// Coordinates of a vector from its products with the first normal and with the sum of both.
    InPlane coordinates(double with_first, double with_sum) const
    {
        return {with_first, (with_sum - beyond_ * with_first) / sine_};
    }
    /// Multipliers of the two unit normals whose sum has these coordinates.
    Turns multipliers(const InPlane& x) const { return {x.p - cosine() * x.q / sine_, x.q / sine_}; }
    const UnitVectors& sum() const { return sum_; }

private:
    UnitVectors sum_;
    double beyond_, sine_;
};

double rate(const HalfSpace& h, const UnitNormal& normal, const ProjectionProblem& at)
{
    return slack(h, at.start) / normal.length;
}

/// Whether a rotation of `now` in the plane, by any angle, leaves all others open.
bool keeps_others_open(const ProjectionProblem& at, std::span<const UnitNormal> normals, std::size_t first,
                       std::size_t second, const Plane& plane, const InPlane& now, double closing)
{
    UnitVectors along(at.start.size(), BlockCholesky::Vector{});
    normals[first].add_to(along, 1);
    for (std::size_t k = 0; k < normals.size(); ++k) {
        if (k == first || k == second) continue;
        const InPlane part = plane.coordinates(normals[k].dot(along), normals[k].dot(plane.sum()));
        if (part.p == 0 && part.q == 0) continue;
        const double apart = rate(at.half_spaces[k], normals[k], at) - (part.p * now.p + part.q * now.q);
        if ((apart - length(part) * length(now)) * normals[k].length < -closing) return false;
    }
    return true;
}

/// Square of the length, in the metric, that multipliers of unit normals add to the vectors.
double energy_gained(const ProjectionProblem& at, std::size_t i, std::size_t j, std::span<const UnitNormal> normals,
                     const Turns& multipliers)
{
    std::vector<Vec3> after = at.start;
    push(at.half_spaces[i], at.w, multipliers.first / normals[i].length, after);
    push(at.half_spaces[j], at.w, multipliers.second / normals[j].length, after);
    double gained = 0;
    for (std::size_t k = 0; k < after.size(); ++k)
        gained += (after[k] - at.start[k]).dot(after[k] + at.start[k]) / at.w[k];
    return gained;
}

}  // namespace

std::optional<Turns> turns(const ProjectionProblem& at, int first, int second, double closing)
{
    const std::vector<UnitNormal> normals = unit_normals(at);
    const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
    const Plane plane(at, normals[i], normals[j]);
    if (!(plane.cosine() < 0 && plane.sine() > 0)) return std::nullopt;
    const double rate_i = rate(at.half_spaces[i], normals[i], at), rate_j = rate(at.half_spaces[j], normals[j], at);
    const InPlane before = plane.coordinates(rate_i, rate_i + rate_j);

    // Powers of the rotation, none beyond an eighth of a full turn before it is doubled: none leads past the opening.
    std::vector<Rotation> powers{{1 - 2 * plane.sine() * plane.sine(), 2 * plane.sine() * plane.cosine()}};
    while (powers.back().cosine > std::abs(powers.back().sine)) powers.push_back(powers.back().twice());
    InPlane now = before;
    double taken = 0, each = std::ldexp(1.0, static_cast<int>(powers.size()) - 1);
    for (std::size_t k = powers.size(); k-- > 0; each /= 2)
        for (InPlane next = powers[k](now); next.p < 0; next = powers[k](now)) {
            now = next;
            taken += each;
        }
    if (taken < fewest_turns || !keeps_others_open(at, normals, i, j, plane, before, closing)) return std::nullopt;
    Turns out = plane.multipliers({now.p - before.p, now.q - before.q});
    // The coordinate q is known to u / sine of the first rate only, and lengths must be kept to rounding: what the new
    // velocities have too much is taken from q, which is nearly all that is left of them in the plane.
    const double gained = energy_gained(at, i, j, normals, out);
    const Turns mend = plane.multipliers({0, -gained / (2 * now.q)});
    out.first = (out.first + mend.first) / normals[i].length;
    out.second = (out.second + mend.second) / normals[j].length;
    return out;
}

}  // namespace carom
