/// \file
/// The decision and the time behind the public query, for inputs as given: every difference of two doubles is kept
/// exactly.
#pragma once

#include "math/double_double.hpp"

#include <carom/time_of_impact.hpp>

#include <cstdint>

namespace carom {

struct CertifiedTime {
    ImpactStatus status = ImpactStatus::none;
    double t = 0, t_lo = 0, t_hi = 0;
    DoubleDouble sharp;  ///< t with what is left of it
    std::uint8_t level = 0;
};

/// Motion of `a` relative to `b`.
struct ExactMotion;

CertifiedTime certified_time(const ExactMotion& motion);

/// The time for spheres in uniform relative motion, given exactly.
CertifiedTime certified_time(const DoubleDouble3& r, const DoubleDouble3& v, DoubleDouble contact_distance);

struct ScenePlane;
CertifiedTime certified_time(const ScenePlane& plane);

}  // namespace carom
