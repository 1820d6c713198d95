/// \file
/// The pair law, contact after contact, until nothing closes: what `sequential` and `shock` are made of.
#pragma once

#include "contact/contact.hpp"
#include "impact/tolerances.hpp"

#include <span>
#include <vector>

namespace carom {

struct PairSweeps {
    std::vector<Vec3> velocities;  ///< by body, in and out
    std::vector<double> impulses;  ///< by contact along its normal, in and out: they add up
    int count = 0;                 ///< of impulses
};

/// Visits `contacts` in their order, again and again; each that closes gets the normal impulse of the pair law with its
/// own restitution.
/// \param inverse_masses by body; 0: infinitely heavy
/// \param most impulses
/// \returns whether nothing closes any more. It does not where impulses go on without end, nor where they accumulate
/// until nothing moves (inelastic collapse).
bool sweep_pairs(const ContactProblem& cluster, std::span<const int> contacts, std::span<const double> inverse_masses,
                 int most, PairSweeps& state);

/// The bound on impulses in a cluster, for operators that give each contact one again and again.
inline int most_impulses(std::size_t contacts)
{
    return pair_impulses + pair_impulses_each * static_cast<int>(contacts);
}

}  // namespace carom
