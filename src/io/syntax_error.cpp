#include "io/syntax_error.hpp"

#include <algorithm>
#include <carom/error.hpp>

namespace carom::io {

namespace {

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

/// A value where a comma belongs: the line and column behind the value before, and the cure. `byte` is where the value
/// begins that came too early.
std::string missing_comma(std::string_view text, const std::string& file, std::size_t byte, std::string_view what)
{
    const bool expects_end = what.ends_with("expected '}'") || what.ends_with("expected ']'");
    const std::size_t last = byte == 0 ? std::string_view::npos : text.find_last_not_of(" \t\r\n", byte - 1);
    if (!expects_end || last == std::string_view::npos) return "";
    constexpr std::string_view begins_value = "\"{[-0123456789tfn", ends_value = "\"}]0123456789el";
    if (byte >= text.size() || begins_value.find(text[byte]) == std::string_view::npos ||
        ends_value.find(text[last]) == std::string_view::npos)
        return "";
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(last), '\n');
    const bool same_line = text.substr(last, byte - last).find('\n') == std::string_view::npos;
    return place_of(text, last + 1, file) + ": a comma is missing " +
           (same_line ? "here" : "at the end of line " + std::to_string(line));
}

/// Where the token begins that the parser could not take, having read everything before `end`. (The parser's own record
/// of the token reaches back too far.)
std::size_t token_begin(std::string_view text, std::size_t end, std::string_view what)
{
    const auto is_word = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '+' || c == '-' ||
               c == '.' || c == '_';
    };
    const auto says = [&](std::string_view words) { return what.find(words) != std::string_view::npos; };
    if (end == 0 || says("invalid string")) return end == 0 ? 0 : end - 1;
    std::size_t begin = end - 1;
    if (says("unexpected string literal")) {
        const auto escaped = [&](std::size_t quote) {
            std::size_t backslashes = 0;
            while (backslashes < quote && text[quote - backslashes - 1] == '\\') ++backslashes;
            return backslashes % 2 == 1;
        };
        while (begin > 0 && (text[--begin] != '"' || escaped(begin))) continue;
        return begin;
    }
    if (says("invalid") && begin > 0 && !is_word(text[begin]) && is_word(text[begin - 1])) --begin;
    while (begin > 0 && is_word(text[begin]) && is_word(text[begin - 1])) --begin;
    return begin;
}

/// The parser's message without its name, its own position, and what it read last.
std::string plain(const std::string& what)
{
    const std::size_t begin = what.find("syntax error");
    std::string text = begin == std::string::npos ? what : what.substr(begin);
    const std::size_t read = text.find("; last read: ");
    if (read == std::string::npos) return text;
    const std::size_t expected = text.rfind("; expected");
    const bool has_tail = expected != std::string::npos && expected > read;
    return text.substr(0, read) + (has_tail ? text.substr(expected) : "");
}

}  // namespace

std::string syntax_error(std::string_view text, const std::string& file, std::size_t read, const std::string& what,
                         const std::string& too_large)
{
    const bool at_end = read > text.size();
    const std::size_t byte = at_end ? text.size() : token_begin(text, read, what);
    const std::string place = place_of(text, byte, file) + ": ";
    if (!too_large.empty())
        return place + too_large + ": " + std::string(text.substr(byte, read - byte)) +
               " is out of range (the largest number is 1.8e308)";
    if (const std::string cure = hint(text.substr(0, byte), text.substr(byte)); !cure.empty()) return place + cure;
    if (const std::string found = missing_comma(text, file, byte, what); !found.empty()) return found;
    if (at_end) return place + "the text ends too early (is the file truncated? a bracket or quote is missing)";
    return place + plain(what);
}

void refuse_binary(const std::string& file)
{
    throw InputError({file + ": is a binary file or not UTF-8, no JSON text (save it as UTF-8 text)"});
}

void refuse_what_is_no_text(std::string_view text, const std::string& file)
{
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark) text.remove_prefix(byte_order_mark.size());
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) throw InputError({file + ": the file is empty (a scene is a JSON object)"});
    const auto lead = static_cast<unsigned char>(text[first]);
    constexpr unsigned char first_printable = 0x20, last_printable = 0x7e;
    if (lead < first_printable || lead > last_printable || text.find('\0') != std::string_view::npos)
        refuse_binary(file);
}

}  // namespace carom::io
