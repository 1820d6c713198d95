/// \file
/// Figures in words, for sentences and labels. Files carry the full numbers.
#pragma once

#include <string>

namespace carom::study {

/// Two significant digits: 310, 0.032, 1.2e-7; "not a finite number" for what is none.
std::string two_digits(double value);
/// A step: the shortest decimal that is the same double, or 1/n where that is shorter.
std::string step_text(double dt);
/// A length in the scene's unit; metres are written as mm, cm and so on.
std::string length_text(double value, const std::string& unit);
/// Seconds of a computer's time.
std::string seconds_text(double seconds);

}  // namespace carom::study
