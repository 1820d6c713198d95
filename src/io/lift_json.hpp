/// \file
/// Spheres that were lifted out of a plane, as results say it.
#pragma once

#include <carom/study.hpp>

#include <nlohmann/json.hpp>

#include <span>

namespace carom::io {

/// A list of {"id", "plane", "depth", "energy"}.
nlohmann::ordered_json lifts_json(const Scene& scene, std::span<const Lift> lifts);

}  // namespace carom::io
