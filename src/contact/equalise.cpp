#include "contact/equalise.hpp"

#include "contact/tolerances.hpp"
#include "projection/shortest_change.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace carom {

namespace {

/// How much further than the widest gap that is to close (or the fastest) a body may go. One pinched between two that
/// do not give way could close both gaps a few radii aside, where their normals differ.
double longest_way(std::size_t contacts)
{
    return stretch + stretch_each * static_cast<double>(contacts);
}

}  // namespace

EqualisingChange equalising_change(const ContactProblem& cluster, std::span<const double> wanted)
{
    std::vector<double> w;
    for (const ContactBody& body : cluster.bodies) w.push_back(body.inverse_mass);
    std::vector<UnitNormal> normals;
    std::vector<double> scaled;
    double far = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const Contact& c = cluster.contacts[i];
        normals.emplace_back(HalfSpace{c.a, c.b, c.normal, 0}, w);
        scaled.push_back(wanted[i] / normals.back().length);
        far = std::max(far, longest_way(wanted.size()) * std::abs(wanted[i]));
    }
    std::vector<double> furthest;
    for (const double each : w) furthest.push_back(far / std::sqrt(each));

    const std::vector<char> all(normals.size(), 1);
    std::optional<ActiveFactor> factor;
    if (normals.size() >= factored_from) {
        factor.emplace(w.size(), normals);
        factor->follow(all);
    }
    ShortestChange found = shortest_change(normals, all, scaled, w.size(), {factor ? &*factor : nullptr, furthest});
    EqualisingChange out;
    for (std::size_t k = 0; k < w.size(); ++k) {
        const BlockCholesky::Vector& y = found.change[k];
        out.change.emplace_back(std::sqrt(w[k]) * Vec3(y[0], y[1], y[2]));
    }
    for (std::size_t i = 0; i < normals.size(); ++i) out.impulses.push_back(found.multipliers[i] / normals[i].length);
    return out;
}

}  // namespace carom
