/// \file
/// The reference with its samples spread over the part of the run that it covers.
#pragma once

#include "reference/reference.hpp"
#include "study/sample_times.hpp"

namespace carom::study {

struct ComparedReference {
    Reference reference;  ///< its samples are those of `times`
    SampleTimes times;
    double asked_for = 0;  ///< the end asked for [time]
    double until = 0;    ///< end of what is compared: that of the reference, or the one asked for if it begins nowhere
    std::string reason;  ///< why that is before the end asked for; empty if it is not
};

/// Makes the reference; again with other samples where it ended early or where samples fall on impacts.
ComparedReference make_compared_reference(const Scene& scene, double until, std::size_t intervals,
                                          const OnProgress& on_progress);

}  // namespace carom::study
