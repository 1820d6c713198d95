#include <algorithm>
#include <carom/error.hpp>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "io/json.hpp"

namespace carom::io {

namespace {

constexpr std::size_t deepest = 64;  // a scene needs 6; the bound keeps recursion over the tree safe

/// "FILE:LINE:COL" of a byte.
std::string place_of(std::string_view text, std::size_t byte, const std::string& file)
{
    const std::string_view before = text.substr(0, byte);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t newline = before.rfind('\n');
    const std::size_t column = newline == std::string_view::npos ? byte + 1 : byte - newline;
    return file + ":" + std::to_string(line) + ":" + std::to_string(column);
}

/// The usual slips, with their cure. `rest` begins at the token that the parser could not take.
std::string hint(std::string_view before, std::string_view rest)
{
    const auto begins = [&](std::string_view word) { return rest.substr(0, word.size()) == word; };
    const std::size_t last = before.find_last_not_of(" \t\r\n");
    const char previous = last == std::string_view::npos ? ' ' : before[last];
    if (begins("NaN") || begins("nan") || begins("Inf") || begins("inf") || begins("-Inf") || begins("-inf"))
        return "NaN and Infinity are not numbers of JSON or of a scene (give a finite number)";
    if (begins("//") || begins("/*") || begins("#")) return "JSON has no comments (remove it, or use \"description\")";
    if ((begins("}") || begins("]")) && previous == ',') return "comma before the closing bracket (remove it)";
    if (begins("'")) return "JSON strings stand in double quotes";
    if (begins("+") || begins(".")) return "a number begins with a digit or a minus sign (0.5, not .5 or +0.5)";
    return "";
}

/// Builds the tree from the parser's calls.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
public:
    TreeBuilder(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    Json root;
    std::vector<std::string> problems;

    bool null() override { return add({}); }
    bool boolean(bool value) override
    {
        Json json;
        json.kind = Json::Kind::boolean;
        json.boolean = value;
        return add(std::move(json));
    }
    bool number_integer(number_integer_t value) override
    {
        return number(static_cast<double>(value), std::to_string(value));
    }
    bool number_unsigned(number_unsigned_t value) override
    {
        return number(static_cast<double>(value), std::to_string(value));
    }
    bool number_float(number_float_t value, const string_t& digits) override { return number(value, digits); }
    bool string(string_t& value) override
    {
        Json json;
        json.kind = Json::Kind::string;
        json.text = std::move(value);
        return add(std::move(json));
    }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::Kind::object); }
    bool start_array(std::size_t) override { return open(Json::Kind::array); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& value) override
    {
        if (!open_.back().known.insert(value).second)
            problems.push_back(file_ + ": " + join(pointer(), value) + ": duplicate key (remove one of the two)");
        open_.back().json.keys.push_back(std::move(value));
        return true;
    }

    bool parse_error(std::size_t read, const std::string& token, const nlohmann::detail::exception& error) override
    {
        const bool at_end = read > text_.size();
        const bool escaped = token.find("<U+") != std::string::npos;  // then its length is not that of the text
        const std::size_t token_size = escaped ? 1 : token.size();
        const std::size_t end = std::min(read, text_.size());
        const std::size_t byte = at_end && token_size <= 1 ? end : end - std::min(token_size, end);
        const std::string place = place_of(text_, byte, file_) + ": ";
        constexpr int number_too_large = 406;
        if (error.id == number_too_large) {
            problems.push_back(place + next_pointer() + ": " + token +
                               " is out of range (the largest number is 1.8e308)");
        } else if (const std::string cure = hint(text_.substr(0, byte), text_.substr(byte)); !cure.empty()) {
            problems.push_back(place + cure);
        } else if (at_end) {
            problems.push_back(place +
                               "the text ends too early (is the file truncated? a bracket or quote is missing)");
        } else {
            const std::string what = error.what();
            const std::size_t begin = what.find("syntax error");
            problems.push_back(place + (begin == std::string::npos ? what : what.substr(begin)));
        }
        return false;
    }

private:
    struct Open {
        Json json;
        std::unordered_set<std::string> known;  ///< keys so far
    };

    bool number(double value, const std::string& digits)
    {
        Json json;
        json.kind = Json::Kind::number;
        json.number = value;
        json.text = digits;
        return add(std::move(json));
    }
    bool add(Json json)
    {
        if (open_.empty())
            root = std::move(json);
        else
            open_.back().json.items.push_back(std::move(json));
        return true;
    }
    bool open(Json::Kind kind)
    {
        if (open_.size() >= deepest) {
            problems.push_back(file_ + ": nested deeper than " + std::to_string(deepest) + " levels (no scene is)");
            return false;
        }
        open_.emplace_back();
        open_.back().json.kind = kind;
        return true;
    }
    bool close()
    {
        Json done = std::move(open_.back().json);
        open_.pop_back();
        return add(std::move(done));
    }

    /// Of the container that is being read.
    std::string pointer() const
    {
        std::string path;
        for (std::size_t level = 0; level + 1 < open_.size(); ++level) path = step(path, open_[level].json);
        return path;
    }
    /// Of the value that comes next.
    std::string next_pointer() const { return open_.empty() ? "" : step(pointer(), open_.back().json); }
    static std::string step(const std::string& path, const Json& container)
    {
        return container.kind == Json::Kind::object ? join(path, container.keys.back())
                                                    : join(path, container.items.size());
    }

    std::string_view text_;
    const std::string& file_;
    std::vector<Open> open_;
};

/// Text that cannot be JSON at all deserves a better word than the parser's.
void refuse_what_is_no_text(std::string_view text, const std::string& file)
{
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark) text.remove_prefix(byte_order_mark.size());
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) throw InputError({file + ": the file is empty (a scene is a JSON object)"});
    const auto lead = static_cast<unsigned char>(text[first]);
    constexpr unsigned char first_printable = 0x20, last_printable = 0x7e;
    if (lead < first_printable || lead > last_printable || text.find('\0') != std::string_view::npos)
        throw InputError({file + ": is a binary file or not UTF-8, no JSON text (save it as UTF-8 text)"});
}

}  // namespace

Json parse_json(std::string_view text, const std::string& file)
{
    refuse_what_is_no_text(text, file);
    TreeBuilder builder(text, file);
    const bool complete = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
    if (!builder.problems.empty()) throw InputError(std::move(builder.problems));
    if (!complete) throw InputError({file + ": is no JSON text"});
    return std::move(builder.root);
}

}  // namespace carom::io
