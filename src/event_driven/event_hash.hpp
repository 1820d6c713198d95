/// \file
/// A fingerprint of a run: equal for equal runs, whatever compiler, build, grid or queue made them.
#pragma once

#include <carom/event.hpp>

#include <bit>

namespace carom {

/// FNV-1a 64 over 64-bit words (Fowler, Noll, Vo), seven an event; -0 counts as +0.
class EventHash {
public:
    void add(const Event& e)
    {
        word(static_cast<std::uint64_t>(e.kind));
        word((static_cast<std::uint64_t>(static_cast<std::uint32_t>(e.a)) << 32) | static_cast<std::uint32_t>(e.b));
        word(static_cast<std::uint64_t>(e.at.epoch));
        word(bits(e.at.offset));
        for (int k = 0; k < 3; ++k) word(bits(e.impulse[k]));
    }
    std::uint64_t value() const { return hash_; }

private:
    static std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x + 0.0); }
    void word(std::uint64_t w) { hash_ = (hash_ ^ w) * 0x100000001b3u; }

    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace carom
