/// \file
/// Linear drag k: the functions of time that a damped flight is made of.
///
/// They come from a series whose remainder is bounded, in code of the verifier's own: the engine's exponential
/// (math/exponential.hpp) finds the impacts, and a fault in it would move a flight and its examination alike.
#pragma once

#include "math/double_double.hpp"

namespace carom::verification {

/// Effect of a time: x0 + way v0 + fall a is the place after it, decay v0 + way a the speed.
template <class N>
struct Damped {
    N way;    ///< (1 - exp(-k t)) / k [epochs]
    N fall;   ///< (t - way) / k [epochs^2]
    N decay;  ///< exp(-k t) [1]
};

/// Errors in double-double: way 40 u^2 of it, fall 30 u^2 t^2, decay 20 u^2; in double 2 u of those sizes. \pre k > 0,
/// t >= 0
template <class N>
Damped<N> damped(double k, const DoubleDouble& t);

}  // namespace carom::verification
