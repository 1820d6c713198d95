/// \file
/// The tolerances of impact operators: unit, value, reason. m counts the contacts of a cluster.
#pragma once

#include "contact/tolerances.hpp"
#include "projection/tolerances.hpp"

#include <cstddef>
#include <cstdint>

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
/// Contacts times rounds [1] granted to stiff and to elastic clusters whose rounds are taken exactly: some seconds.
/// Light bodies among those of M times their mass need some 3 M^(1/2) rounds where they do not repeat: ten may have M =
/// 1e9.
inline constexpr std::size_t exact_rounds = 1'000'000;

// Steps in double-double (exact_steps.cpp).

/// Ratio of masses [1] from which on steps are exact: rounding of impulses, u, shows in the speeds of the lightest as
/// u times the ratio, `closing_tolerance`.
inline constexpr double stiff_mass_ratio = 1e4;
/// Contacts [1] up to which steps are exact: what they cost grows with the cube of those that close at once. No
/// derivation.
inline constexpr std::size_t most_exact = 100;
/// Steps [1] of a period at most: one for each of its contacts in `sequential`, see `most_repeated`.
inline constexpr std::size_t longest_period = 16;
/// Contacts [1] of a period at most: its powers cost the cube. No derivation.
inline constexpr std::size_t most_repeated = 16;
/// Periods [1] at once that are worth the search for them, which takes the time of some ten.
inline constexpr std::int64_t fewest_repeats = 8;
/// Steps [1] at most until a period is tried again after fewer. No derivation.
inline constexpr std::int64_t longest_wait = 256;
/// Doublings [1] of a period at most, one more than `endless_repeats` has.
inline constexpr std::size_t most_doublings = 49;
/// Periods [1] of those that are endless. Two contacts that stick, e = 0, come nearer by 2/M each time, and have 1e-12
/// left after 14 M of them; 2^48 are 20 times that at `largest_mass_ratio`.
inline constexpr std::int64_t endless_repeats = std::int64_t{1} << (most_doublings - 1);
/// Differences [1] that are known of what decides on steps: the room that a jump of N periods needs goes with this
/// power of N. Measured: with 6 a light ball between heavy ones, M = 1e6, takes 40 % more instructions.
inline constexpr int known_differences = 3;
/// Part [N^2 times the largest second difference] by which numbers stray from the line between the first and the N-th:
/// at most k (N - k) / 2, the largest for k = N/2.
inline constexpr double second_difference_strays = 1.0 / 8;
/// Jumps [1] in a row. No derivation: a bound of the loop.
inline constexpr int most_jumps = 256;

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
