/// \file
/// A vector as results and scenes have it.
#pragma once

#include <carom/types.hpp>

#include <nlohmann/json.hpp>

namespace carom::io {

inline nlohmann::ordered_json vector_json(const Vec3& v)
{
    return {v[0], v[1], v[2]};
}

}  // namespace carom::io
