#include "io/frames_csv.hpp"
#include "io/trace_reader.hpp"
#include "support/scenes.hpp"

#include <carom/error.hpp>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace carom;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
namespace fs = std::filesystem;

namespace {

/// Two balls and a fixed one above a floor.
Scene scene_of_three()
{
    Scene scene = test::empty_scene(1);
    test::add_floor(scene);
    for (int i = 0; i < 3; ++i) test::add_sphere(scene, 0.5, {2.0 * i, 0, 1});
    scene.spheres[2].fixed = true;
    return scene;
}

/// A file for one test.
class TraceFile {
public:
    explicit TraceFile(const std::string& text)
        : path_(fs::temp_directory_path() / ("carom-trace-" + std::to_string(::getpid()) + ".csv"))
    {
        std::ofstream(path_) << text;
    }
    ~TraceFile() { fs::remove(path_); }
    TraceFile(const TraceFile&) = delete;
    TraceFile& operator=(const TraceFile&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// Why a trace is refused, without the folder of its file; empty if it is not.
std::string problem_of(const std::string& text)
{
    const TraceFile file(text);
    const Scene scene = scene_of_three();
    try {
        io::TraceReader reader(file.path(), scene);
    } catch (const InputError& error) {
        return std::string(error.what()).substr(file.path().string().size());
    }
    return "";
}

const std::string good = "t,id,x,y,z\n0,s0,0,0,1\n0,s1,2,0,1\n0.5,s1,2,0,1.25\n0.5,s0,0,0,1\n";

}  // namespace

TEST_CASE("frames come in order, their bodies in any, fixed ones from the scene")
{
    const TraceFile file("# made by hand\n" + good);
    const Scene scene = scene_of_three();
    io::TraceReader reader(file.path(), scene);
    CHECK(reader.count() == 2);
    audit::Frame frame;
    REQUIRE(reader.next(frame));
    CHECK(frame.time == 0);
    REQUIRE(reader.next(frame));
    CHECK(frame.time == 0.5);
    CHECK(frame.places[0] == Vec3(0, 0, 1));
    CHECK(frame.places[1] == Vec3(2, 0, 1.25));
    CHECK(frame.places[2] == scene.spheres[2].position);
    CHECK_FALSE(reader.next(frame));
}

TEST_CASE("columns may stand in any order, with others between, quoted and with spaces")
{
    CHECK(problem_of("speed, z ,id,y,t,x\n9,1,\"s0\",0,0,0\n9,1,s1,0,0,2\n9,1,s0,0,1,0\n9,1,s1,0,1,2\r\n").empty());
}

TEST_CASE("a faulty trace is refused with its line and what is wrong")
{
    CHECK(problem_of("").find(":1: an empty trace") == 0);
    CHECK_THAT(problem_of("time,id,x,y,z\n"), StartsWith(":1: no column \"t\""));
    CHECK_THAT(problem_of(good + "0.6,s0,0,0\n"), StartsWith(":6: 4 fields"));
    CHECK_THAT(problem_of(good + "0.6,s0,0,oops,0\n"), StartsWith(":6: y: \"oops\" is no finite number"));
    CHECK_THAT(problem_of(good + "0.6,s0,0,nan,0\n"), StartsWith(":6: y: \"nan\" is no finite number"));
    CHECK_THAT(problem_of(good + "0.6,s9,0,0,0\n"), StartsWith(":6: no sphere \"s9\" in the scene (did you mean"));
    CHECK_THAT(problem_of(good + "0.6,floor,0,0,0\n"), StartsWith(":6: \"floor\" is a plane"));
    CHECK_THAT(problem_of(good + "0.6,s0,0,0,1\n"), StartsWith(":6: the frame t = 0.6 has no sphere \"s1\""));
    CHECK_THAT(problem_of(good + "0.6,s0,0,0,1\n0.6,s0,0,0,1\n"), StartsWith(":7: sphere \"s0\" twice"));
    CHECK_THAT(problem_of(good + "0.4,s0,0,0,1\n0.4,s1,0,0,1\n"), StartsWith(":6: t = 0.4 after t = 0.5"));
    CHECK_THAT(problem_of("t,id,x,y,z\n0,s0,0,0,1\n0,s1,2,0,1\n"), Contains("one frame"));
    CHECK_THAT(problem_of("t,id,x,y,z\n0,s0,0,0,1\n0,s1,2,0,1\n1,s0,0,0,1\n1,s1,2,0,1\n1,s2,4.5,0,1.00001\n"),
               Contains("sphere \"s2\" is fixed, but 0.5"));
    const Scene scene = scene_of_three();
    CHECK_THROWS_WITH(io::TraceReader("/no/such/trace.csv", scene), StartsWith("/no/such/trace.csv: no such file"));
}

TEST_CASE("times at equal distances are exact though they have few digits, others are known to their digits")
{
    const Scene scene = scene_of_three();
    const auto time_error = [&](const std::string& last) {
        const TraceFile file(good + last + ",s0,0,0,1\n" + last + ",s1,2,0,1\n");
        return io::TraceReader(file.path(), scene).rounding().time;
    };
    CHECK(time_error("1.0") < 1e-14);
    CHECK(time_error("1.1") == Approx(0.05));
}

TEST_CASE("frames that are written read back as the same places")
{
    Scene scene = scene_of_three();
    scene.spheres[0].id = "a, \"b\"";
    std::ostringstream text;
    io::FramesCsv csv(text, scene);
    std::vector<BodyState> states(3);
    for (std::size_t i = 0; i < 3; ++i) states[i].position = scene.spheres[i].position;
    states[0].position = Vec3(0.1, 1.0 / 3, -1e-300);
    csv.write(0, states);
    csv.write(1.0 / 240, states);
    const TraceFile file(text.str());
    io::TraceReader reader(file.path(), scene);
    audit::Frame frame;
    REQUIRE(reader.next(frame));
    REQUIRE(reader.next(frame));
    CHECK(frame.time == 1.0 / 240);
    CHECK(frame.places[0] == states[0].position);
}
