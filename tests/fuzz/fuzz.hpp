/// \file
/// What every fuzz target is made of. Two programs share them: libFuzzer's (preset `fuzz`, tools/fuzz), and a driver
/// that replays the seeds and some thousand mutations of them in the ordinary build (replay.cpp, ctest fuzz_*).
#pragma once

#include "core/random.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// One input. A finding ends the process.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
/// A change of the input that goes deeper than flipped bytes. Returns its new size, at most `most`.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int seed);
/// Flipped, inserted, copied bytes: libFuzzer's own, or the driver's.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace carom::fuzz {

/// Inputs to start from.
std::vector<std::string> seeds();

/// Says what is wrong and ends the process, as a sanitizer does.
[[noreturn]] void finding(const std::string& what);
inline void expect(bool holds, const char* what)
{
    if (!holds) finding(what);
}

/// A number like those that break things: 0, powers of two, the ends of the range, a neighbour of `near`, ...
double odd_number(Random& random, double near);

/// Changes JSON text so that it stays JSON: numbers become odd ones, members are dropped, doubled or moved. Text that
/// is no JSON, and now and then what is, gets plain changes of bytes. `words` are keys and strings worth a try.
std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t most, unsigned int seed,
                        const std::vector<std::string_view>& words);

}  // namespace carom::fuzz
