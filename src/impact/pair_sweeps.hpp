/// \file
/// The pair law, contact after contact, until nothing closes: what `sequential` and `shock` are made of.
#pragma once

#include "contact/contact.hpp"

#include <span>
#include <vector>

namespace carom {

struct PairSweeps {
    std::vector<Vec3> velocities;  ///< by body, in and out
    std::vector<double> impulses;  ///< by contact along its normal, in and out: they add up
    int count = 0;                 ///< of impulses, those of a period once
};

/// Visits `contacts` in their order, again and again; each that closes gets the normal impulse of the pair law with its
/// own restitution. Where impulses accumulate (inelastic collapse) the velocities are the limit: of stiff clusters, and
/// of others that 10000 + 100 m impulses do not end, periods of impulses are taken at once (exact_steps.hpp), and
/// contacts with e = 0 that go on after that are closed together.
/// \param inverse_masses by body; 0: infinitely heavy
/// \returns whether it ends. It does not where impulses go on without end
bool sweep_pairs(const ContactProblem& cluster, std::span<const int> contacts, std::span<const double> inverse_masses,
                 PairSweeps& state);

/// The limit of inelastic contacts whose impulses go on for ever: all of those that are `hit` are closed.
/// Closes them, if each of them pushes then and nothing closes. \returns whether that is so
bool close_for_good(const ContactProblem& cluster, std::span<const int> contacts,
                    std::span<const double> inverse_masses, const std::vector<char>& hit, PairSweeps& state);

}  // namespace carom
