#include "impact/exact_steps.hpp"

#include "impact/exact_matrix.hpp"
#include "impact/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

DoubleDouble dot(const Vec3& a, const Vec3& b)
{
    return (DoubleDouble(two_product(a.x(), b.x())) + DoubleDouble(two_product(a.y(), b.y()))) +
           DoubleDouble(two_product(a.z(), b.z()));
}

bool touches(const HalfSpace& h, int body)
{
    return h.a == body || h.b == body;
}

}  // namespace

bool is_stiff(const ProjectionProblem& problem)
{
    double least = std::numeric_limits<double>::infinity(), largest = 0;
    for (const double w : problem.w) {
        if (w == 0) continue;
        least = std::min(least, w);
        largest = std::max(largest, w);
    }
    return largest > stiff_mass_ratio * least;
}

ExactSteps::ExactSteps(const ProjectionProblem& problem, double closing, Pace pace)
    : problem_(problem),
      closing_(closing),
      pace_(pace),
      couplings_(problem.half_spaces.size()),
      impulses_(couplings_.size())
{
    std::vector<std::vector<int>> of_body(problem.start.size());
    for (std::size_t i = 0; i < couplings_.size(); ++i) {
        const HalfSpace& h = problem.half_spaces[i];
        of_body[static_cast<std::size_t>(h.a)].push_back(static_cast<int>(i));
        if (h.b) of_body[static_cast<std::size_t>(*h.b)].push_back(static_cast<int>(i));
        DoubleDouble rate = dot(h.normal, problem.start[static_cast<std::size_t>(h.a)]) + DoubleDouble(h.offset);
        if (h.b) rate = rate - dot(h.normal, problem.start[static_cast<std::size_t>(*h.b)]);
        rates_.push_back(rate);
    }
    for (std::size_t i = 0; i < couplings_.size(); ++i) {
        const HalfSpace& h = problem.half_spaces[i];
        std::vector<int> near = of_body[static_cast<std::size_t>(h.a)];
        if (h.b) {
            const std::vector<int>& more = of_body[static_cast<std::size_t>(*h.b)];
            near.insert(near.end(), more.begin(), more.end());
        }
        std::sort(near.begin(), near.end());
        near.erase(std::unique(near.begin(), near.end()), near.end());
        for (const int j : near) {
            const HalfSpace& other = problem.half_spaces[static_cast<std::size_t>(j)];
            DoubleDouble weight;
            for (const std::optional<int> body : {std::optional(h.a), h.b}) {
                if (!body || !touches(other, *body)) continue;
                const DoubleDouble w = problem.w[static_cast<std::size_t>(*body)];
                weight = weight + ((h.a == *body) == (other.a == *body) ? w : -w);
            }
            couplings_[i].push_back({j, weight * dot(h.normal, other.normal)});
        }
    }
}

DoubleDouble ExactSteps::product(int i, int j) const
{
    const std::vector<Coupling>& row = couplings_[static_cast<std::size_t>(i)];
    const auto found =
        std::lower_bound(row.begin(), row.end(), j, [](const Coupling& c, int contact) { return c.contact < contact; });
    return found != row.end() && found->contact == j ? found->product : DoubleDouble();
}

Numbers ExactSteps::products(const std::vector<int>& contacts) const
{
    Numbers out;
    for (const int i : contacts)
        for (const int j : contacts) out.push_back(product(i, j));
    return out;
}

void ExactSteps::spread(int contact, DoubleDouble impulse, Numbers& rates) const
{
    for (const Coupling& c : couplings_[static_cast<std::size_t>(contact)]) {
        DoubleDouble& rate = rates[static_cast<std::size_t>(c.contact)];
        rate = rate + impulse * c.product;
    }
}

Numbers ExactSteps::impulses_of(const Step& step, const Numbers& rates) const
{
    Numbers out;
    for (const int i : step.contacts) out.push_back(DoubleDouble(-step.gain) * rates[static_cast<std::size_t>(i)]);
    if (out.size() == 1)  // by far the most
        out.front() = out.front() / product(step.contacts.front(), step.contacts.front());
    else
        solve({out.size(), products(step.contacts)}, out, 1);
    return out;
}

void ExactSteps::take(const Step& step)
{
    const Numbers impulses = impulses_of(step, rates_);
    for (std::size_t k = 0; k < impulses.size(); ++k) {
        DoubleDouble& sum = impulses_[static_cast<std::size_t>(step.contacts[k])];
        sum = sum + impulses[k];
        spread(step.contacts[k], impulses[k], rates_);
    }
}

bool ExactSteps::is_projection(const Step& step) const
{
    const Numbers impulses = impulses_of(step, rates_);
    if (!std::all_of(impulses.begin(), impulses.end(), [](const DoubleDouble& x) { return x.high > 0; })) return false;
    return std::all_of(step.idle.begin(), step.idle.end(), [&](int i) {
        DoubleDouble rate = rates_[static_cast<std::size_t>(i)];
        for (std::size_t k = 0; k < impulses.size(); ++k)
            rate = rate + product(i, step.contacts[k]) * impulses[k] / DoubleDouble(step.gain);
        return static_cast<double>(rate) >= -closing_;
    });
}

void ExactSteps::take_once(const Step& step)
{
    take(step);
    history_.clear();
}

void ExactSteps::push(int contact, double impulse)
{
    DoubleDouble& sum = impulses_[static_cast<std::size_t>(contact)];
    sum = sum + DoubleDouble(impulse);
    spread(contact, impulse, rates_);
    history_.clear();
}

std::vector<Vec3> ExactSteps::vectors() const
{
    std::vector<DoubleDouble3> sums;
    for (const Vec3& x : problem_.start) sums.push_back({x.x(), x.y(), x.z()});
    for (std::size_t i = 0; i < contacts(); ++i) {
        const HalfSpace& h = problem_.half_spaces[i];
        const DoubleDouble3 normal{h.normal.x(), h.normal.y(), h.normal.z()};
        const auto push = [&](int body, DoubleDouble impulse) {
            DoubleDouble3& sum = sums[static_cast<std::size_t>(body)];
            sum = sum + (DoubleDouble(problem_.w[static_cast<std::size_t>(body)]) * impulse) * normal;
        };
        push(h.a, impulses_[i]);
        if (h.b) push(*h.b, -impulses_[i]);
    }
    std::vector<Vec3> out;
    for (const DoubleDouble3& x : sums)
        out.emplace_back(static_cast<double>(x.x), static_cast<double>(x.y), static_cast<double>(x.z));
    return out;
}

std::vector<double> ExactSteps::impulses() const
{
    std::vector<double> out;
    for (const DoubleDouble x : impulses_) out.push_back(static_cast<double>(x));
    return out;
}

}  // namespace carom
