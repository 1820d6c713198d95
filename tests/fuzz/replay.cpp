/// \file
/// A fuzz target without libFuzzer.
///
///     PROGRAM MUTATIONS [FILE...]   every seed or file, then so many mutations of them, always the same ones
///     PROGRAM --write DIR           the seeds as files, for libFuzzer
#include "fuzz/fuzz.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {

using carom::Random;

Random& byte_random()
{
    static Random random(1);
    return random;
}

int write_seeds(const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder);
    const auto seeds = carom::fuzz::seeds();
    for (std::size_t i = 0; i < seeds.size(); ++i)
        std::ofstream(folder / ("seed-" + std::to_string(i)), std::ios::binary) << seeds[i];
    return 0;
}

void run(const std::string& input)
{
    // Exactly as large as the input, so that a sanitizer sees what reads beyond it.
    const std::vector<std::uint8_t> data(input.begin(), input.end());
    LLVMFuzzerTestOneInput(data.data(), data.size());
}

std::string mutated(const std::string& input, unsigned int seed)
{
    constexpr std::size_t growth = 4096;
    std::vector<std::uint8_t> data(input.begin(), input.end());
    data.resize(input.size() + growth);
    const std::size_t size = LLVMFuzzerCustomMutator(data.data(), input.size(), data.size(), seed);
    return {data.begin(), data.begin() + static_cast<std::ptrdiff_t>(size)};
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most)
{
    Random& random = byte_random();
    const std::size_t at = random.below(size + 1);
    switch (random.below(4)) {
        case 0:  // insert
            if (size == most) return size;
            std::copy_backward(data + at, data + size, data + size + 1);
            data[at] = static_cast<std::uint8_t>(random.bits());
            return size + 1;
        case 1: {  // cut out
            const std::size_t length = std::min(size - at, 1 + random.below(16));
            std::copy(data + at + length, data + size, data + at);
            return size - length;
        }
        case 2:  // another byte
            if (at < size) data[at] = static_cast<std::uint8_t>(random.bits());
            return size;
        default:  // a flipped bit
            if (at < size) data[at] = static_cast<std::uint8_t>(data[at] ^ (1u << random.below(8)));
            return size;
    }
}

int main(int count, char** words)
{
    const std::vector<std::string> args(words + 1, words + count);
    if (args.size() == 2 && args[0] == "--write") return write_seeds(args[1]);
    if (args.empty()) {
        std::fprintf(stderr, "usage: %s MUTATIONS [FILE...] | --write DIR\n", words[0]);
        return 2;
    }
    std::vector<std::string> inputs;
    for (std::size_t i = 1; i < args.size(); ++i) {
        std::ifstream file(args[i], std::ios::binary);
        inputs.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    if (inputs.empty()) inputs = carom::fuzz::seeds();
    for (const std::string& input : inputs) run(input);
    const std::size_t originals = inputs.size();
    const auto mutations = static_cast<unsigned int>(std::strtoul(args[0].c_str(), nullptr, 10));
    constexpr std::size_t most_kept = 1000;
    for (unsigned int i = 0; i < mutations; ++i) {
        // Half of them of seeds, half of mutations: these get further, and sooner or later are refused at once.
        const bool fresh = byte_random().below(2) == 0;
        const std::size_t from = byte_random().below(fresh ? originals : inputs.size());
        std::string next = mutated(inputs[from], i);
        run(next);
        if (inputs.size() < originals + most_kept)
            inputs.push_back(std::move(next));
        else if (from >= originals)
            inputs[from] = std::move(next);
    }
    std::printf("%zu seeds and %u mutations without a finding\n", originals, mutations);
    return 0;
}
