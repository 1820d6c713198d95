/// \file
/// Everything that the library core, `carom::carom`, implements. Beside it stand <carom/study.hpp> and
/// <carom/metrics.hpp> (link `carom::study`) and <carom/io.hpp> (link `carom::io`).
#pragma once

#include <carom/error.hpp>           // IWYU pragma: export
#include <carom/event.hpp>           // IWYU pragma: export
#include <carom/features.hpp>        // IWYU pragma: export
#include <carom/flight.hpp>          // IWYU pragma: export
#include <carom/method.hpp>          // IWYU pragma: export
#include <carom/progress.hpp>        // IWYU pragma: export
#include <carom/response.hpp>        // IWYU pragma: export
#include <carom/scene.hpp>           // IWYU pragma: export
#include <carom/simulate.hpp>        // IWYU pragma: export
#include <carom/time_of_impact.hpp>  // IWYU pragma: export
#include <carom/types.hpp>           // IWYU pragma: export
