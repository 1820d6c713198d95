/// \file
/// Figures in words, for sentences and labels. Files carry the full numbers.
#pragma once

#include <carom/study.hpp>

#include <string>

namespace carom::study {

/// Two significant digits: 310, 0.032, 1.2e-7; "not a finite number" for what is none.
std::string two_digits(double value);
/// Three, where two would hide on which side of a limit a figure lies: 0.00104.
std::string three_digits(double value);
/// A time of the run to five digits, with its unit: "1.0468 s".
std::string time_text(double time, const std::string& unit);
/// A step: 1/n if it is one and that is shorter than its decimal; else a decimal of at most four digits, to which steps
/// of a logarithmic range are rounded.
std::string step_text(double dt);
/// Settings of a row beside method and step that are not built in: " in 4 substeps with 2 passes, parabola".
std::string variant_text(const CompareRow& row);
/// A length in the scene's unit, to three digits; metres are written as mm, cm and so on.
std::string length_text(double value, const std::string& unit);
/// Seconds of a computer's time.
std::string seconds_text(double seconds);

}  // namespace carom::study
