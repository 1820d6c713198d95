/// \file
/// The tolerances of contacts: unit, value, reason. n counts contacts, but where it says otherwise.
#pragma once

#include <cstddef>

namespace carom {

// Speeds, forces and impulses.

/// Speed [largest speed] that is rounding in projections, and impulses that change speeds by less: 900 u, for the sums
/// over a body's dozen contacts whose multipliers cancel. Piles leave 5.7 of it at most (src/projection/tolerances.hpp,
/// "Measured").
inline constexpr double projection_tolerance = 1e-13;
/// Speed [largest speed] below which contacts do not close: ten times what projecting leaves. Not measured.
inline constexpr double closing_tolerance = 1e-12;
/// The same in the unit in which projections take it [projection_tolerance].
inline constexpr double closing_in_projections = closing_tolerance / projection_tolerance;

// Gaps and speeds that are to be closed (equalise.cpp).

/// Distance [widest gap that is to close, or the fastest] that a body may go, beside that for each contact. No
/// derivation: room for a sphere between two walls, which goes as far as their angle says.
inline constexpr double stretch = 256;
/// The same for each contact [likewise]: a tower of n spheres needs 2 n / pi, from its smallest singular value, and
/// this is six times that.
inline constexpr double stretch_each = 4;
/// Contacts [1] from which on they are factored first: fewer are equalised sooner. Not measured since.
inline constexpr std::size_t factored_from = 16;

// Memory of closings.

/// Closings [contacts] that are remembered in any run, beside those for each body. No derivation: some 50 kB.
inline constexpr std::size_t remembered = 1024;
/// Closings for each body [contacts]: a dozen neighbours make 6 pairs of each, and two are room.
inline constexpr std::size_t remembered_each = 8;

}  // namespace carom
