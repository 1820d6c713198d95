#include "cli/toi_command.hpp"

#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "io/limits.hpp"
#include "io/toi_line.hpp"

#include <iostream>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace carom::cli {

namespace {

/// Lines of which one too long for a query is cut: it may have no end.
class Lines {
public:
    explicit Lines(std::istream& in) : in_(in) {}

    /// The next one, without its end, valid until the next call; none at the end of the input.
    std::optional<std::string_view> next()
    {
        if (is_cut_) in_.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
        in_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
        const auto taken = static_cast<std::size_t>(in_.gcount());
        is_cut_ = in_.fail() && taken > 0;
        if (taken == 0) return {};
        if (is_cut_) in_.clear(in_.rdstate() & ~std::ios::failbit);
        const bool has_end = !is_cut_ && !in_.eof();
        return std::string_view(buffer_.data(), taken - has_end);
    }
    bool is_cut() const { return is_cut_; }

private:
    std::istream& in_;
    std::vector<char> buffer_ = std::vector<char>(io::longest_toi_line + 2);  // a character too many, and a 0
    bool is_cut_ = false;
};

}  // namespace

void serve_toi(std::istream& in, std::ostream& out)
{
    Lines lines(in);
    while (const auto line = lines.next()) {
        out << io::answer_toi_line(*line) << '\n';
        if (lines.is_cut() || in.rdbuf()->in_avail() <= 0) out.flush();
        if (!out) return;
    }
    out.flush();
}

int do_toi(const Console& console)
{
    std::ios::sync_with_stdio(false);  // nothing was read or written yet
    std::cin.tie(nullptr);
    serve_toi(std::cin, console.out);
    return console.out ? exit_ok : exit_failed;
}

}  // namespace carom::cli
