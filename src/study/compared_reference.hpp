/// \file
/// The reference with its samples spread over the part of the run that it covers.
#pragma once

#include "reference/reference.hpp"
#include "study/sample_times.hpp"

namespace carom::study {

struct ComparedReference {
    Reference reference;  ///< its samples are those of `times`
    SampleTimes times;
    double until = 0;    ///< end of what is compared: that of the reference, or the one asked for if it begins nowhere
    std::string reason;  ///< why that is before the end asked for; empty if it is not
};

/// Makes the reference with more samples than are wanted, as many as memory allows, and keeps those that are spread
/// over what it covers, nearly equal; makes it again where that were too few, or where samples fall on impacts.
ComparedReference make_compared_reference(const Scene& scene, double until, std::size_t intervals,
                                          const OnProgress& on_progress);

}  // namespace carom::study
