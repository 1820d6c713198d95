/// \file
/// Runs that should be the same as one that was made: of the scene elsewhere, later, or backwards.
#pragma once

#include <carom/checks.hpp>

namespace carom::study {

/// Whether a check of this type needs a second run.
bool asks_for_repeat(CheckType type);

/// That second run and how far its end is from the one expected, in the units of CheckType; infinite if it did not get
/// there. \param first what the run of `scene` gave, at its end \pre asks_for_repeat(check.type)
Repeat repeat_run(const Scene& scene, const Check& check, const Outcome& first, const CheckOptions& options);

}  // namespace carom::study
