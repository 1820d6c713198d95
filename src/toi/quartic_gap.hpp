/// \file
/// The squared gap of two spheres on parabolas, its half rate and that one's rate, as exact polynomials of time.
#pragma once

#include "math/exact_polynomial.hpp"
#include "toi/accelerated_enclosure.hpp"

namespace carom {

struct QuarticGap {
    ExactPolynomial f, h, h_rate;
    int time = 0;  ///< 2^time is the unit of time
};

/// Exponent of the time in which a body at rest falls a length: signs are cheap in it.
int natural_time(const ExactMotion& m);

/// \param time exponent of the unit of time
QuarticGap quartic_gap(const ExactMotion& m, int time);

/// A double beyond every positive root, or the horizon if there is none.
double root_bound(const ExactPolynomial& p);

}  // namespace carom
