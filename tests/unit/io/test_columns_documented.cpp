// The tables of columns are the only place that says them; what others read must say the same.
#include "core/names.hpp"
#include "io/recording_columns.hpp"
#include "io/recording_format.hpp"
#include "study/compare_columns.hpp"
#include "tunnel/columns.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

using namespace carom;
using Catch::Contains;

namespace {

std::string text_of(const char* file)
{
    std::ifstream stream(std::filesystem::path(CAROM_SCENE_DIR).parent_path() / file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The columns that docs/recording.md names in the row `name`, without what it explains in brackets.
std::string documented_columns(const std::string& page, const std::string& name)
{
    const std::string head = "\n| " + name + " | ";
    const std::size_t begin = page.find(head);
    if (begin == std::string::npos) return "no row";
    const std::string row = page.substr(begin + head.size(), page.find(" |\n", begin) - begin - head.size());
    return std::regex_replace(row, std::regex(R"( \([^()]*\))"), "");
}

}  // namespace

TEST_CASE("docs/recording.md lists the columns that a recording has", "[recording]")
{
    const std::string page = text_of("docs/recording.md");
    CHECK(documented_columns(page, "events") == io::columns_text<Event>(io::event_columns));
    CHECK(documented_columns(page, "flights") == io::columns_text<io::FlightRow>(io::flight_columns));
    CHECK(documented_columns(page, "spheres") == io::columns_text<io::SphereRow>(io::sphere_columns));
    CHECK(documented_columns(page, "planes") == io::columns_text<Plane>(io::plane_columns));
    CHECK(documented_columns(page, "materials") == io::columns_text<Material>(io::material_columns));
    CHECK(documented_columns(page, "contacts") == io::columns_text<ContactRule>(io::contact_columns));
    CHECK(documented_columns(page, "moons") == "no row");
    for (const io::RecordingTable& table : io::recording_tables)
        CHECK_THAT(page, Contains("\n| `" + io::table_text(table) + "` |"));
}

TEST_CASE("docs/compare.md lists the columns that a comparison has", "[results]")
{
    std::string table;
    for (const study::CompareColumn& column : study::compare_columns)
        table += "| `" + std::string(column.name) + "` | " +
                 std::string(name_of(column.unit, study::column_unit_names)) + " | " + std::string(column.meaning) +
                 " |\n";
    INFO("it should end in\n" << table);
    CHECK(text_of("docs/compare.md").ends_with("|---|---|---|\n" + table));
}

namespace {

template <class Columns>
std::string table_of(const Columns& columns)
{
    std::string table = "|---|---|---|\n";
    for (const auto& column : columns)
        table += "| `" + std::string(column.name) + "` | " +
                 std::string(name_of(column.unit, study::column_unit_names)) + " | " + std::string(column.meaning) +
                 " |\n";
    return table;
}

}  // namespace

TEST_CASE("docs/tunnel.md lists the columns of tunnel.csv and critical.csv", "[results]")
{
    const std::string page = text_of("docs/tunnel.md");
    INFO("it should have\n" << table_of(tunnel::row_columns) << table_of(tunnel::critical_columns));
    CHECK(page.find(table_of(tunnel::row_columns) + "\n") != std::string::npos);
    CHECK(page.ends_with(table_of(tunnel::critical_columns)));
}

TEST_CASE("the page explains the columns of a comparison in the same words", "[results]")
{
    std::string script = text_of("tools/web/src/columns.js");
    for (const auto& [typographic, plain] : {std::pair{"\u201c", "\\\""}, {"\u201d", "\\\""}, {"\u2019", "'"}})
        for (std::size_t at; (at = script.find(typographic)) != std::string::npos;)
            script.replace(at, std::string(typographic).size(), plain);
    std::size_t before = 0;
    for (const study::CompareColumn& column : study::compare_columns) {
        INFO(column.name);
        const std::size_t at = script.find("{ key: \"" + std::string(column.name) + "\"");
        REQUIRE(at != std::string::npos);
        CHECK(at > before);
        before = at;
        std::string meaning(column.meaning);
        for (std::size_t quote = 0; (quote = meaning.find('"', quote)) != std::string::npos; quote += 2)
            meaning.insert(quote, "\\");
        CHECK_THAT(script.substr(at, script.find('\n', at) - at), Contains("text: \"" + meaning + "\""));
    }
}
