#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/json.hpp"
#include "problems_of.hpp"
#include "scene/check_keys.hpp"

using namespace carom;
using namespace carom::test;
using Catch::Contains;
using Catch::EndsWith;
namespace fs = std::filesystem;

namespace {

const fs::path scene_dir = CAROM_SCENE_DIR;

std::string read_problem(const fs::path& file)
{
    try {
        read_scene(file);
    } catch (const InputError& error) {
        return error.what();
    }
    return "(accepted)";
}

/// A folder of this test's own, removed with it.
struct Folder {
    fs::path path = fs::temp_directory_path() /
                    ("carom-test-scene-files-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)));
    Folder() { fs::create_directories(path); }
    ~Folder()
    {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    fs::path write(const std::string& name, const std::string& text) const
    {
        fs::create_directories((path / name).parent_path());
        std::ofstream(path / name, std::ios::binary) << text;
        return path / name;
    }
};

}  // namespace

TEST_CASE("files that are no scenes are refused with a clear word", "[io]")
{
    const Folder folder;
    CHECK_THAT(read_problem(folder.path / "missing.json"), EndsWith("missing.json: no such file"));
    CHECK_THAT(read_problem(folder.path), Contains(": is a directory"));
    CHECK_THAT(read_problem(folder.write("empty.json", "")), Contains("empty.json: the file is empty"));
    CHECK_THAT(read_problem(folder.write("binary.json", std::string("\x1f\x8b\0\0", 4))), Contains("is a binary file"));
    const std::string whole = scene_with(R"("spheres": [{"radius": 1, "position": [0, 0, 0]}])");
    CHECK(read_problem(folder.write("whole.json", whole)) == "(accepted)");
    for (std::size_t n = 1; n < whole.size(); ++n) {
        INFO(whole.substr(0, n));
        CHECK_THAT(read_problem(folder.write("cut.json", whole.substr(0, n))),
                   Contains("cut.json:1:") && Contains("ends too early"));
    }
}

TEST_CASE("the catalogue lists readable scenes by name, without the schema", "[io]")
{
    const Folder folder;
    folder.write("b/zebra.json", R"({"name": "Z", "description": "striped"})");
    folder.write("a/ant.json", "{}");
    folder.write("a/broken.json", "{");
    folder.write("a/notes.txt", "{}");
    folder.write("scene.schema.json", "{}");
    const auto entries = list_scenes(folder.path);
    REQUIRE(entries.size() == 2);
    CHECK(entries[0].name == "ant");
    CHECK(entries[1].name == "zebra");
    CHECK(entries[1].title == "Z");
    CHECK(entries[1].description == "striped");
    CHECK(list_scenes(folder.path / "none").empty());
}

TEST_CASE("a scene is found by path or by catalogue name, and a slip gets the nearest name", "[io]")
{
    const Folder folder;
    const fs::path file = folder.write("a/bouncing.json", "{}");
    CHECK(find_scene(file.string(), folder.path) == file);
    CHECK(find_scene("bouncing", folder.path) == file);
    CHECK_THROWS_WITH(find_scene("bouncin", folder.path), Contains("did you mean \"bouncing\"?"));
    CHECK_THROWS_WITH(find_scene((file.parent_path() / "bouncing").string(), folder.path),
                      Contains("did you mean \"") && Contains("bouncing.json\"?"));
    CHECK_THROWS_WITH(find_scene("zzz", folder.path), Contains("there are: bouncing"));
    CHECK_THROWS_WITH(find_scene((folder.path / "a").string(), folder.path), Contains("is a directory"));
}

TEST_CASE("every scene of the catalogue is valid, described and checked", "[io]")
{
    const auto entries = list_scenes(scene_dir);
    std::istringstream names(
        "bouncing_ball incline bullet cradle gas_1000 counting_pi_0 counting_pi_1 counting_pi_2 counting_pi_3 "
        "counting_pi_4 two_spheres grazing billiards_break falling_column extreme_masses far_away 666 "
        "cradle_1 cradle_2 cradle_3 cradle_4 unequal_chain bernoulli rack_of_15 corner wedge_90 wedge_60 wedge_45 "
        "pile_up collapse_of_three tower pyramid v_groove ball_on_three slide_off_sphere column_100 settle_30 "
        "settle_1000 slot");
    for (std::string name; names >> name;) CHECK_NOTHROW(find_scene(name, scene_dir));
    for (const auto& entry : entries) {
        INFO(entry.path);
        Scene scene;
        REQUIRE_NOTHROW(scene = read_scene(entry.path));
        CHECK_FALSE(scene.name.empty());
        CHECK(scene.description.size() > 50);
        CHECK_FALSE(scene.units.length.empty());
        CHECK_FALSE(scene.checks.empty());
    }
}

TEST_CASE("the counting scenes expect the digits of pi", "[io]")
{
    const std::vector<std::int64_t> impacts{3, 31, 314, 3141, 31415};
    for (std::size_t k = 0; k < impacts.size(); ++k) {
        const Scene scene = read_scene(find_scene("counting_pi_" + std::to_string(k), scene_dir));
        double ratio = 1;
        for (std::size_t i = 0; i < k; ++i) ratio *= 100;
        CHECK(scene.spheres[1].mass / scene.spheres[0].mass == ratio);
        bool counted = false;
        for (const auto& check : scene.checks)
            counted = counted || (check.type == CheckType::event_count && check.count == impacts[k]);
        CHECK(counted);
    }
}

TEST_CASE("the schema and the reader know the same keys", "[io]")
{
    std::ifstream stream(scene_dir / "scene.schema.json");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const io::Json schema = io::parse_json(text, "schema");
    const auto known_to_reader = [](const std::string& members, const std::string& key) {
        for (const auto& p : problems_of(scene_with(members)))
            if (p.find("/" + key + ": unknown key") != std::string::npos) return false;
        return true;
    };
    for (const auto& key : schema.find("properties")->keys) {
        INFO(key);
        if (key != "format" && key != "end_time") CHECK(known_to_reader("\"" + key + "\": null", key));
    }
    const std::vector<std::pair<std::string, std::string>> objects{
        {"sphere", "\"spheres\": [{\"%\": null}]"},
        {"plane", "\"planes\": [{\"%\": null}]"},
        {"box", "\"box\": {\"%\": null}"},
        {"material", "\"materials\": {\"m\": {\"%\": null}}"},
        {"contact", "\"contacts\": [{\"%\": null}]"},
        {"rest", "\"rest\": {\"%\": null}"},
        {"impact", "\"impact\": {\"operator\": \"lcp\", \"%\": null}"},
        {"guard", "\"guard\": {\"%\": null}"},
        {"stress", "\"stress\": {\"%\": null}"}};
    for (const auto& [name, pattern] : objects) {
        for (const auto& key : schema.find("$defs")->find(name)->find("properties")->keys) {
            INFO(name << " " << key);
            std::string members = pattern;
            members.replace(members.find('%'), 1, key);
            CHECK(known_to_reader(members, key));
        }
    }
    CHECK_FALSE(known_to_reader("\"nonsense\": null", "nonsense"));
    const io::Json* check = schema.find("$defs")->find("check")->find("properties");
    for (const std::string_view key : check_key_names) {
        INFO(key);
        CHECK(check->find(key) != nullptr);
    }
}
