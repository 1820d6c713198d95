/// \file
/// The few numbers that the reference decides by. None of them is a scene's: `rest` and `guard` are not read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace carom::reference {

// What ends a reference.

/// Effort of a run, in impacts of one contact of some 0.15 ms for both precisions: half a minute. Bounces to rest are
/// some 69 / (1 - e) of them.
inline constexpr std::int64_t max_effort = 250'000;
/// Effort of an impact of n contacts among N bodies, 1 + n^3 / 100 + (1 + n) N / 250, and of a step of constrained
/// motion with them, 15 n more: measured.
inline constexpr std::size_t cubes_an_impact = 100, pairs_an_impact = 250, impacts_a_step = 15;
/// Events at one time: bounces whose gaps 50 digits do not tell any more, down to the speeds that they do.
inline constexpr std::int64_t most_at_once = 10'000;
/// Contacts resolved together: the work grows with their cube, and more.
inline constexpr std::size_t most_contacts = 128;
/// Bound [smallest radius] beyond which there is no reference: a stepper's error is a thousandth at best.
inline constexpr double worst_bound = 1e-6;

// What is 0 in 50 digits, which leave errors near 1e-50 of the scales below.

/// Gaps, rates and speeds below this part of their scale are rounding: the scene's doubles come in steps of 1e-16, and
/// 20 digits are left for what a run makes of its roundings.
inline constexpr double rounding = 1e-30;
/// A square of it: of (r.v)^2 against r^2 v^2.
inline constexpr double rounding_square = 1e-60;
/// Relative residual of complementarity problems: halfway between what the scene's doubles say and 50 digits; and what
/// counts as closing in an impact of several contacts, a little more than that.
inline constexpr double residual_left = 1e-25, least_closing = 1e-24;
/// Forces, accelerations and what they make of a gap below this part of their scale change their sign there: a step
/// of constrained motion leaves errors of 1e-28.
inline constexpr double sign_change = 1e-20;

// What the scene's doubles cannot tell apart.

/// Contacts closer than this are one instant (in radii), unless the scene says otherwise; those of the scene's start
/// are within 1e-9 r, by contract.
inline constexpr double tie = 1e-12, declared_tie = 1e-9;
/// Elastic contacts slower than two roundings of the speeds persist, for they would bounce for ever: normals and
/// velocities are doubles.
inline constexpr double still_rounding = 0x1p-51;
/// Impulses below this part of the largest of their instant come from normals that are doubles, and are not listed. Its
/// square tells which rows of a coupling are sums of others.
inline constexpr double noise = 1e-12, dependent = 1e-24;
/// Contacts hold each other where velocities and accelerations are below this part of their scale, 90 roundings of
/// doubles: a tower whose axis is a rounding off stands.
inline constexpr double equilibrium = 1e-14;
/// Velocities [largest speed] that two impact operators give are different, not differently rounded.
inline constexpr double other_outcome = 1e-9;
/// Closing speed [largest closing before] after an impact at which it was not resolved.
inline constexpr double unresolved = 1e-9;

// Choices.

/// Unit normals with a convex combination shorter than this are jammed; weights in it below `jam_weight` are none.
inline constexpr double jam = 1e-7, jam_weight = 1e-9;
/// Bounces lower than this fraction of the radius are listed as a series, not one by one.
inline constexpr double series_height = 1e-3;
/// Instants at which the impact operators are compared: beyond them a list says nothing new.
inline constexpr std::size_t most_conventions = 100;

/// Bounces to closings below this part of the fastest that either body has been are over. Here and below the two
/// precisions differ, so that their distance shows the error of it.
template <class Real>
inline constexpr bool is_high = std::numeric_limits<Real>::digits10 >= 100;
template <class Real>
inline constexpr double rest_speed = is_high<Real> ? 1e-30 : 1e-27;
/// Terms and tolerance [radius] of a step of constrained motion. A step of n terms goes 10^(-digits/n) of the radius of
/// convergence: the work, n^2 a step, is least for n = 2.3 digits / 2.
template <class Real>
inline constexpr std::size_t step_terms = is_high<Real> ? 42 : 32;
template <class Real>
inline constexpr double step_tolerance = is_high<Real> ? 1e-36 : 1e-28;

}  // namespace carom::reference
