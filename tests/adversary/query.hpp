/// \file
/// What an adversary asks, and what many digits answer.
#pragma once

#include "adversary/quartic_oracle.hpp"
#include "support/multiprecision.hpp"

#include <carom/time_of_impact.hpp>

#include <optional>

namespace carom::test {

struct Query {
    MovingSphere a;
    MovingSphere b;  ///< unless there is a plane
    std::optional<Plane> plane;
    /// The acceleration moves the answer by less than 1e-100 of itself: the quadratic is the oracle.
    bool is_negligible = false;
};

struct Answer {
    ImpactStatus status = ImpactStatus::none;
    bool no_digits = false;  ///< the oracle cannot tell either
    Float200 t = 0;
    double uncertainty = 0;  ///< of the oracle's own time, relative
};

/// By formulas other than the kernel's, in Real.
template <class Real>
Answer answer_to(const Query& q);

extern template Answer answer_to<Float200>(const Query&);
extern template Answer answer_to<Float700>(const Query&);

}  // namespace carom::test
