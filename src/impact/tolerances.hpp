/// \file
/// The tolerances of impact operators: unit, value, reason. m counts the contacts of a cluster.
#pragma once

#include "contact/tolerances.hpp"
#include "projection/tolerances.hpp"

#include <cstddef>

namespace carom {

// Promises of a response (resolve_cluster.hpp).

/// Speed [largest speed] at which contacts may close after it. No derivation: a thousand `closing_tolerance`s, for
/// tangential impulses come after the operator and a last projection after them.
inline constexpr double feasible = 1e-9;
/// The same in a jammed set [largest speed], 4e-8: what projections grant a unit normal p that depends on those of
/// other closed contacts, p = sum c_j a_j + r with |r| <= `dependent_normal`. Where the others neither open nor close p
/// closes at |r.u| <= |r||u|, and impulses along r that mend it would change speeds by |r.u| / |r|, all of u: so a
/// wedge that is so narrow is passed (docs/regimes.md).
inline constexpr double feasible_if_jammed = missed_by_dependent * projection_tolerance;
/// Energy [energy before] that rounding may add. No derivation: m impulses round by some m u.
inline constexpr double energy_rounding = 1e-9;
/// Ratio of masses [1] beyond which nothing is promised. No derivation: a light body between heavy ones makes contacts
/// that depend on each other to within its inverse, and normals to within the root of that.
inline constexpr double largest_mass_ratio = 1e12;

// Jam test (jam.cpp).

/// delta [1]: unit normals whose convex hull comes nearer to 0 are jammed. No derivation; below `dependent_normal` none
/// would be seen, this is five times that.
inline constexpr double smallest_opening = 1e-7;
/// Error [openings asked for, which are 1] of openings. No derivation, but it must be well below 1.
inline constexpr double opening_tolerance = 1e-6;
/// Connected contacts [1] beyond which none is asked; rounds then meet their bound. No derivation: the solver takes 1
/// to 2 ms for 191 half-spaces, and 0.1 s for 634.
inline constexpr std::size_t most_asked = 200;

// Reflections.

/// Rounds [1] after which those that go on are asked whether they are jammed. No derivation, and not measured.
inline constexpr int rounds_before_jam_test = 24;
/// Rounds [1] of these, the last ones, whose contacts are asked in large clusters: they tell what goes on and on. No
/// derivation.
inline constexpr int recent_rounds = 8;
/// Contacts [1] of a cluster that is asked as a whole. No derivation: the test is cheap up to here, see `most_asked`.
inline constexpr std::size_t asked_as_a_whole = 100;
/// Contacts [1] beyond which a cluster is granted no more rounds: larger ones are no harder, but their rounds cost
/// more. No derivation.
inline constexpr std::size_t hardest_cluster = 100;
/// Contacts times rounds [1] of a cluster where all e = 1, which has nothing to fall back on that keeps its energy. Light
/// bodies among those of M times their mass need some 3 M^(1/2) rounds, if more than two contacts close in turn: ten may
/// have M = 1e9.
inline constexpr std::size_t elastic_rounds = 1'000'000;
/// Pairs of rounds [1] of two contacts from which on they are taken at once: a jump takes the time of some ten rounds.
/// Clusters of bodies of like mass have no such pairs.
inline constexpr double fewest_turns = 8;

// Rounds of reflections and jacobi.

/// Rounds [1] granted to every cluster, beside those for each contact. No derivation: a bound of the loop.
inline constexpr int usual_rounds = 100;
/// Rounds for each contact [1]. No derivation: a bound of the loop.
inline constexpr int usual_rounds_each = 10;
/// Energy [energy before] with which jacobi gives up. No derivation: far from what a response may look like, and some
/// 20 rounds that double it away.
inline constexpr double too_much_energy = 1e6;

// Impulses of sequential and shock.

/// Impulses [1] granted to every cluster, beside those for each contact. No derivation: a bound of the loop; a light
/// body between two of M times its mass needs pi M^(1/2), so M up to 1e7.
inline constexpr int pair_impulses = 10'000;
/// Impulses for each contact [1]. No derivation: a bound of the loop.
inline constexpr int pair_impulses_each = 100;
/// Closing speed [largest speed before] at which all has collapsed. No derivation: no cascade that ends comes so far.
inline constexpr double collapsed = 1e-200;

}  // namespace carom
