#include "core/printable.hpp"

#include <catch2/catch.hpp>

using carom::printable;

TEST_CASE("text stays as it is, in whatever script", "[printable]")
{
    for (const std::string text :
         {"", "plain text, \"quoted\" \\x1b", "\xc3\xa4 \xe2\x82\xac \xf0\x9f\x8e\xb1", "\xc2\xa0"})
        CHECK(printable(text) == text);
}

TEST_CASE("control characters, of one byte or two, and what is no UTF-8 are written out", "[printable]")
{
    CHECK(printable("\x1b[31mred\x1b[0m") == "\\x1b[31mred\\x1b[0m");
    CHECK(printable(std::string("a\0b\r\n\t\x7f", 7)) == "a\\x00b\\x0d\\x0a\\x09\\x7f");
    CHECK(printable("\xc2\x9b"
                    "31m") == "\\x9b31m");  // U+009B begins a sequence as ESC [ does
    CHECK(printable("\x9b") == "\\x9b");
    CHECK(printable("\xc3") == "\\xc3");                    // cut off
    CHECK(printable("\xe2\x82x") == "\\xe2\\x82x");         // cut short
    CHECK(printable("\xc0\x9b\xff") == "\\xc0\\x9b\\xff");  // a long form, and never a byte of UTF-8
}
