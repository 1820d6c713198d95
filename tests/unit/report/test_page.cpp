// The page around its data: nothing in a scene's names can get out of the data, and nothing of the page is lost.
#include "report/page.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cctype>
#include <string>

using carom::comparison_page;
using carom::page_data_marker;
using carom::page_template;

namespace {

std::size_t count(std::string_view text, std::string_view what)
{
    std::size_t n = 0;
    for (auto at = text.find(what); at != std::string_view::npos; at = text.find(what, at + what.size())) ++n;
    return n;
}

std::string lower(std::string_view text)
{
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

/// What a browser takes for the content of the data element: up to the first end tag after its start tag.
std::string data_element(const std::string& page)
{
    const std::string start = "<script type=\"application/json\" id=\"carom-data\">";
    const auto begin = page.find(start) + start.size();
    return page.substr(begin, lower(page).find("</script", begin) - begin);
}

nlohmann::json with_title(const std::string& title)
{
    return {{"format", "carom-page/1"}, {"comparisons", {{{"title", title}, {"rows", nlohmann::json::array()}}}}};
}

}  // namespace

TEST_CASE("the page template is a whole document with exactly one place for data")
{
    const std::string_view page = page_template();
    REQUIRE(page.size() > 1000);
    CHECK(page.starts_with("<!doctype html>"));
    CHECK(page.find("</html>") != std::string_view::npos);
    CHECK(count(page, page_data_marker) == 1);
    CHECK(count(page, "id=\"carom-data\"") == 1);
}

TEST_CASE("the page refers to nothing outside itself")
{
    const std::string page = lower(page_template());
    for (const char* reference : {"src=\"http", "href=\"http", "src=\"//", "href=\"//", "@import", "url(http",
                                  "url(\"http", "<link", "<iframe"})
        CHECK(count(page, reference) == 0);
}

TEST_CASE("data arrive on the page as they were given")
{
    const auto data = with_title("Bouncing ball \u2264 1 mm, \"quoted\" \\ back");
    const std::string page = comparison_page(data.dump());
    CHECK(count(page, page_data_marker) == 0);
    CHECK(nlohmann::json::parse(data_element(page)) == data);
}

TEST_CASE("no name in a scene can end the data or begin a comment")
{
    const std::string name =
        GENERATE("</script><script>alert(1)</script>", "</SCRIPT >", "<!--", "<!-- <script>", "]]>", "<script");
    const auto data = with_title(name);
    const std::string page = comparison_page(data.dump());
    CHECK(count(lower(page), "</script") == count(lower(page_template()), "</script"));
    CHECK(count(lower(page), "<script") == count(lower(page_template()), "<script"));
    CHECK(count(page, "<!--") == count(page_template(), "<!--"));
    CHECK(nlohmann::json::parse(data_element(page)) == data);
}

TEST_CASE("a marker inside the data stays data")
{
    const auto data = with_title(std::string(page_data_marker) + " $& $1");
    const std::string page = comparison_page(data.dump());
    CHECK(count(page, page_data_marker) == 1);
    CHECK(nlohmann::json::parse(data_element(page)) == data);
}

TEST_CASE("the page around the data is the template, byte for byte")
{
    const std::string json = R"({"format":"carom-page/1","comparisons":[]})";
    const std::string page = comparison_page(json);
    const std::string_view whole = page_template();
    const auto at = whole.find(page_data_marker);
    REQUIRE(at != std::string_view::npos);
    CHECK(page.substr(0, at) == whole.substr(0, at));
    CHECK(page.substr(at, json.size()) == json);
    CHECK(page.substr(at + json.size()) == whole.substr(at + page_data_marker.size()));
}
