/// \file
/// Numbers and lists as users type them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace carom::cli {

/// "0.001", "1e-3", "1/240". \throws std::invalid_argument with what is wrong; only finite numbers pass.
double parse_number(std::string_view text);

/// Whole number in [low, high]; "1e6" is one. \throws std::invalid_argument
long long parse_integer(std::string_view text, long long low, long long high);

/// Seed of random choices: a whole number from 0 to 2^64 - 1 in decimal digits, every one of which counts: no sign, no
/// exponent, no leading zeros. \throws std::invalid_argument
std::uint64_t parse_seed(std::string_view text);

/// "a,b,c", "start:stop:linN", "start:stop:logN" and mixtures; both ends belong to a range, N >= 2.
/// \throws std::invalid_argument with what is wrong
std::vector<double> parse_list(std::string_view text);

/// "a,b,c" as words without blanks around; empty words are errors. \throws std::invalid_argument
std::vector<std::string> parse_words(std::string_view text);

}  // namespace carom::cli
