/// \file
/// Why a reference ends, in words.
#pragma once

#include <carom/scene.hpp>

#include <algorithm>
#include <cstdio>

namespace carom::reference {

inline std::string at_time(double t)
{
    char text[40];
    std::snprintf(text, sizeof text, " at t = %.6g", t);
    return text;
}

/// "what: ball-1, ball-2, floor at t = 0.5", bodies in the order of their ids.
inline std::string reason(const Scene& scene, const std::string& what, std::vector<BodyId> who, double t)
{
    std::sort(who.begin(), who.end());
    std::string text = what;
    for (const BodyId body : who) text += (text == what ? ": " : ", ") + scene.body_name(body);
    return text + at_time(t);
}

}  // namespace carom::reference
