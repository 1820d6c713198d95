/// \file
/// The relative error of doubles and double-doubles against 100 digits.
#pragma once

#include "math/double_double.hpp"
#include "support/multiprecision.hpp"

namespace carom::test {

using Float100 = Float<100>;

inline Float100 exact(double x)
{
    return x;
}
inline Float100 exact(DoubleDouble x)
{
    return Float100(x.high) + Float100(x.low);
}

/// |computed / wanted - 1|. \pre wanted is not 0
template <class Number>
double relative_error(Number computed, const Float100& wanted)
{
    return Float100(abs(exact(computed) / wanted - 1)).template convert_to<double>();
}

}  // namespace carom::test
