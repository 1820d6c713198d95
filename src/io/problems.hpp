/// \file
/// Problems of a file: collected, so that one reading reports everything.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace carom::io {

class Problems {
public:
    explicit Problems(std::string file) : file_(std::move(file)) {}

    /// Adds "FILE: POINTER: what"; the root is called "/".
    void add(const std::string& pointer, const std::string& what);
    /// Adds "FILE: line" for lines that begin with a pointer.
    void add_lines(const std::vector<std::string>& lines);
    std::size_t count() const { return count_; }
    /// \throws InputError if there is any.
    void throw_if_any() const;

private:
    void keep(std::string line);

    std::string file_;
    std::vector<std::string> lines_;  ///< the first few hundred
    std::size_t count_ = 0;
};

/// The candidate that `word` is most likely a slip of: fewest insertions, deletions, substitutions and swaps of
/// neighbours (Damerau 1964), letter case ignored; empty if none is near.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// ` (did you mean "x"?)`, or ` (PLURAL: a, b, c)` if nothing is near.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates, const std::string& plural);

}  // namespace carom::io
