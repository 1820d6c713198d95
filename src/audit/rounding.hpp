/// \file
/// The digits to which numbers were printed, and what is therefore unknown of each.
#pragma once

#include <carom/types.hpp>

#include <string_view>

namespace carom::audit {

/// Precision of a column of numbers. Neither the digits after the point nor the significant ones alone say it, for
/// zeros at the end may have been dropped: the coarser of what both say holds.
class Rounding {
public:
    /// Notes a number as it was printed, "-1.25e-3". \pre it is one
    void see(std::string_view number);

    /// Half a unit of the last digit of `value`. 0.5 if nothing was seen.
    double of(double value) const;

    int digits() const { return digits_; }      ///< significant ones, at most
    int decimals() const { return decimals_; }  ///< after the point, at most

private:
    int digits_ = 0, decimals_ = 0;
};

/// Errors of the numbers of a trace, which are rounded.
struct TraceRounding {
    Rounding places;
    double time = 0;  ///< of a frame, at most [time]

    /// Bound on the distance of a sphere from where a frame shows it: half a unit of the last printed digit, and the
    /// roundings of an engine of single precision where the digits may be those of one, else of double; engines reckon
    /// with gaps and cells, so that they round what is as large as the sphere even where the place is near 0 [length].
    double place_error(const Vec3& place, double radius) const;
};

}  // namespace carom::audit
