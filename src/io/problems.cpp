#include "io/problems.hpp"

#include "io/limits.hpp"

#include <algorithm>
#include <carom/error.hpp>
#include <cctype>

namespace carom::io {

namespace {

std::string lower(std::string_view word)
{
    std::string out(word);
    for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

std::size_t edit_distance(const std::string& a, const std::string& b)
{
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substitution = a[i - 1] == b[j - 1] ? 0 : 1;
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + substitution});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[a.size()][b.size()];
}

}  // namespace

void Problems::keep(std::string line)
{
    ++count_;
    if (lines_.size() < most_problems) lines_.push_back(std::move(line));
}

void Problems::add(const std::string& pointer, const std::string& what)
{
    keep(file_ + ": " + (pointer.empty() ? "/" : pointer) + ": " + what);
}

void Problems::add_lines(const std::vector<std::string>& lines)
{
    for (const auto& line : lines) keep(file_ + ": " + line);
}

void Problems::throw_if_any() const
{
    if (count_ == 0) return;
    std::vector<std::string> lines = lines_;
    if (count_ > lines.size())
        lines.push_back(file_ + ": /: and " + std::to_string(count_ - lines.size()) + " more problems");
    throw InputError(std::move(lines));
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates)
{
    if (word.size() > longest_compared) return "";
    const std::string wanted = lower(word);
    std::string best;
    std::size_t best_distance = std::max<std::size_t>(1, word.size() / letters_per_slip) + 1;
    for (const auto& candidate : candidates) {
        if (candidate.size() > longest_compared) continue;
        const std::size_t distance = edit_distance(wanted, lower(candidate));
        if (distance >= best_distance) continue;
        best_distance = distance;
        best = candidate;
    }
    return best;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates, const std::string& plural)
{
    const std::string near = nearest(word, candidates);
    if (!near.empty()) return " (did you mean \"" + near + "\"?)";
    if (candidates.empty()) return "";
    std::string list;
    for (std::size_t i = 0; i < std::min(candidates.size(), most_listed); ++i)
        list += (i == 0 ? "" : ", ") + candidates[i];
    return " (" + plural + ": " + list + (candidates.size() > most_listed ? ", ..." : "") + ")";
}

}  // namespace carom::io
