#include "verify/findings.hpp"

#include <cstdio>

namespace carom::verification {

std::string figure(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

}  // namespace carom::verification
