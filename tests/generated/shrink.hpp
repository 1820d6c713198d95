/// \file
/// Makes a failing scene small.
#pragma once

#include <carom/scene.hpp>

#include <functional>

namespace carom::test {

/// Fewer spheres, fewer planes, a shorter run, as long as `still_fails` says so; asks at most `tries` times.
/// \pre still_fails(scene)
Scene shrink(Scene scene, const std::function<bool(const Scene&)>& still_fails, int tries = 200);

}  // namespace carom::test
