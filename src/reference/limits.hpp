/// \file
/// The numbers that the reference decides by, with unit and reason. None is a scene's: `rest` and `guard` are not read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace carom::reference {

// The two precisions. They differ in digits and in tolerances, so that their distance shows the error of both.

/// Digits [1] of the run that the answer is compared with: three times those of doubles.
inline constexpr unsigned low_digits = 50;
/// Digits [1] of the run that gives the answer.
inline constexpr unsigned high_digits = 100;
/// Number types [1] of the higher of the two.
template <class Real>
inline constexpr bool is_high = std::numeric_limits<Real>::digits10 >= high_digits;
/// Closing speed [fastest that either body has been] at which bounces are over: time and place of rest are off by about
/// as much, while doubles end at 1e-16.
template <class Real>
inline constexpr double rest_speed = is_high<Real> ? 1e-30 : 1e-27;
/// Way [radius] that the last terms of a step of constrained motion may make: less than bounces, for steps are many.
template <class Real>
inline constexpr double step_tolerance = is_high<Real> ? 1e-36 : 1e-28;
/// Terms [1] of a step of constrained motion. n terms go 10^(-digits/n) of the radius of convergence in n^2 operations:
/// least for n = 1.15 times the digits of the tolerance.
template <class Real>
inline constexpr std::size_t step_terms = is_high<Real> ? 42 : 32;
/// Corrections [1] that put contacts back after a step: each doubles the digits, of which there are at least 28.
inline constexpr int projections = 2;

// The ends of a reference.

/// Bound [smallest radius] beyond which there is no reference: a thousandth of the steppers' errors.
inline constexpr double worst_bound = 1e-6;
/// Effort of a run [impacts of one contact, some 0.15 ms in both precisions]: half a minute. Bounces to rest are some
/// 69 / (1 - e) of them.
inline constexpr std::int64_t max_effort = 250'000;
/// Cubes of the number of contacts [1] that are as much effort as an impact of one of them: measured.
inline constexpr std::size_t cubes_an_impact = 100;
/// Pairs of a contact and any body [1] that are as much effort as an impact: measured.
inline constexpr std::size_t pairs_an_impact = 250;
/// Times of contact [1] that are as much effort as an impact: measured.
inline constexpr std::int64_t questions_an_impact = 20;
/// Times of contact [1] without drag that are as much effort as one with it, whose root takes exponentials: measured.
inline constexpr std::int64_t questions_a_damped_one = 8;
/// Effort of a step of constrained motion [impacts] for each of its contacts: measured.
inline constexpr std::size_t impacts_a_step = 15;
/// Events at one time [1]: bounces whose gaps 50 digits do not tell any more, down to the speeds that they do.
inline constexpr std::int64_t most_at_once = 10'000;
/// Contacts resolved together [1]: the work grows with their cube, and more.
inline constexpr std::size_t most_contacts = 128;
/// Steps of a complementarity problem [1], and as many for each contact: it ends by itself unless rounding cycles.
inline constexpr std::size_t most_pivots = 10;
/// Rounds of reflections [1] before the answer is the inelastic one, as docs/impacts.md has it.
inline constexpr std::size_t most_rounds = 100;
/// More rounds of reflections [1] for each contact.
inline constexpr std::size_t more_rounds = 10;
/// Impulses of `sequential` [1] before the answer is the inelastic one, as docs/impacts.md has it.
inline constexpr std::size_t most_impulses = 10'000;
/// More impulses of `sequential` [1] for each contact.
inline constexpr std::size_t more_impulses = 100;
/// Changes of the contacts that carry [1, for each contact] before a step has no answer.
inline constexpr std::size_t most_changes = 4;
/// Newton steps and halvings of a bracket [1]: more than 100 digits need.
inline constexpr int most_root_steps = 500;
/// Change of a root [itself] below which it is found: its last digit.
template <class Real>
inline constexpr double last_digit = is_high<Real> ? 1e-99 : 1e-49;
/// Halvings of an interval in which a polynomial is not monotone [1]: 1e-24 of it is a graze.
inline constexpr int most_halvings = 80;
/// Halvings of the time that is left in which a distance is not monotone [1]: bounces end at 1e-30 of the fastest,
/// and take as small a part of it, times at most 1e9.
inline constexpr int most_damped_halvings = 130;
/// Drag times a time [1] from which (t - s) / k may lose its digit and no more; below it 50 terms are the sum.
inline constexpr double series_damping = 0.125;

// Zero in 50 digits, which leave errors near 1e-50 of the scales below.

/// Gaps, rates and speeds [their scale] that are rounding: the scene's doubles come in steps of 1e-16, and 20 digits
/// are left for what a run makes of its roundings.
inline constexpr double rounding = 1e-30;
/// The square of it, for (r.v)^2 [r^2 v^2].
inline constexpr double rounding_square = 1e-60;
/// Rate [largest] that a complementarity problem may leave: halfway between doubles and 50 digits.
inline constexpr double residual_left = 1e-25;
/// Rate [fastest that closes] that counts as closing in an impact of several contacts: ten times what may be left.
inline constexpr double least_closing = 1e-24;
/// Terms of a force or a gap [largest term] at its change of sign: a step leaves errors of 1e-28.
inline constexpr double sign_change = 1e-20;

// Differences that the scene's doubles cannot tell.

/// Gap [smaller radius] of contacts of one instant, unless the scene says otherwise: 10^4 roundings of a place.
inline constexpr double tie = 1e-12;
/// Gap [smaller radius] of contacts that a scene declares, by its format.
inline constexpr double declared_tie = 1e-9;
/// Rate [speeds] of declared and of elastic contacts that persist, two roundings: elastic ones would bounce for ever.
inline constexpr double still_rounding = 0x1p-51;
/// Impulses and rates [largest of their instant] that come from normals that are doubles; not listed, and no bounce.
inline constexpr double noise = 1e-12;
/// Pivot [diagonal] of a row that is a sum of others: the square of `noise`.
inline constexpr double dependent = 1e-24;
/// Velocities and accelerations [largest, or gravity] of contacts that hold each other, 90 roundings of doubles: a
/// tower whose axis is a rounding off stands.
inline constexpr double equilibrium = 1e-14;
/// Velocities [largest] of two impact operators that are different, not differently rounded.
inline constexpr double other_outcome = 1e-9;
/// Closing speed [largest before] after an impact at which it was not resolved: an operator went wrong, not rounding.
inline constexpr double unresolved = 1e-9;
/// Length [1] of a convex combination of unit normals that are jammed, as docs/impacts.md has it.
inline constexpr double jam = 1e-7;
/// Weights [their sum] in it that are none.
inline constexpr double jam_weight = 1e-9;

// The answer.

/// Rounding of a sample to double [itself].
inline constexpr double rounding_of_double = 0x1p-53;

/// Height [radius] of bounces that are listed as a series, not one by one: what steppers do not resolve.
inline constexpr double series_height = 1e-3;
/// Instants [1] at which the impact operators are compared: more say nothing new.
inline constexpr std::size_t most_conventions = 100;

// The prefilter in doubles.

/// Error of a flight in doubles [sum of its terms]: 100 times what some ten roundings make.
inline constexpr double shadow_error = 1e-12;
/// Distance [sum of radii] that surfaces certainly keep beyond it: 10^6 roundings of a root of squares.
inline constexpr double outside = 1 + 1e-9;
/// Way [itself] that is certainly longer: 10^9 roundings.
inline constexpr double longer = 1 + 1e-6;
/// Errors of components [1] that a product of two relative vectors has, rounded up.
inline constexpr double errors_a_product = 8;
/// Number added to errors [its unit] that may be 0 by underflow.
inline constexpr double underflow = 1e-300;
/// Least square of a distance [length^2] that has a root in doubles; the largest is its inverse.
inline constexpr double least_square = 1e-290;

}  // namespace carom::reference
