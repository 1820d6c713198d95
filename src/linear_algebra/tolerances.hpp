/// \file
/// The tolerances of factorisations: unit, value, reason.
#pragma once

namespace carom {

/// Part [1] of the square of a column that is left below which what is left is made orthogonal again: 1 / sqrt 2 of the
/// length, the constant of Daniel et al. (thin_qr.hpp), loses one bit at most.
inline constexpr double orthogonal_enough = 0.5;

}  // namespace carom
