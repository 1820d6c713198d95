#include "io/toi_line.hpp"

#include <carom/time_of_impact.hpp>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>
#include <string>

using namespace carom;
using carom::io::answer_toi_line;
using nlohmann::json;

namespace {

json ask(const std::string& line)
{
    return json::parse(answer_toi_line(line));
}

}  // namespace

TEST_CASE("a query of two spheres is answered with time, interval, normal, speed and level", "[toi_line]")
{
    const json answer =
        ask(R"({"a": {"p": [0,0,0], "v": [1,0,0], "r": 1}, "b": {"p": [10,0,0], "v": [-1,0,0], "r": 2}})");
    CHECK(answer.at("status") == "impact");
    CHECK(answer.at("t") == 3.5);
    CHECK(answer.at("lo") <= 3.5);
    CHECK(answer.at("hi") >= 3.5);
    CHECK(answer.at("normal") == json({-1, 0, 0}));
    CHECK(answer.at("approach_speed") == 2);
    CHECK(answer.at("level") == 0);
    CHECK(answer.size() == 7);
}

TEST_CASE("a query over a plane takes accelerations, a thickness and a normal of any length", "[toi_line]")
{
    const json fall =
        ask(R"({"a": {"p": [0,0,5], "v": [0,0,0], "acc": [0,0,-2], "r": 1}, "plane": {"n": [0,0,3], "offset": 0}})");
    CHECK(fall.at("status") == "impact");
    CHECK(fall.at("t") == 2);
    CHECK(fall.at("approach_speed") == 4);
    const json plate =
        ask(R"({"a": {"p": [0,0,-5], "v": [0,0,1], "r": 1}, "plane": {"n": [0,0,1], "offset": 1, "thickness": 0.5}})");
    CHECK(plate.at("t") == 4.75);
    CHECK(plate.at("normal") == json({0, 0, -1}));
    const json rest =
        ask(R"({"a": {"p": [0,0,1], "v": [0,0,0], "acc": [0,0,-2], "r": 1}, "plane": {"n": [0,0,1], "offset": 0}})");
    CHECK(rest.at("status") == "touching");
    CHECK(rest.at("t") == 0);
}

TEST_CASE("bodies that overlap say how deep, whether they approach or not", "[toi_line]")
{
    const auto spheres = [](const std::string& x, const std::string& v) {
        return ask(R"({"a": {"p": [0,0,0], "v": [)" + v + R"(,0,0], "r": 1}, "b": {"p": [)" + x +
                   R"(,0,0], "v": [0,0,0], "r": 1}})");
    };
    const json at_rest = spheres("1.5", "0");
    CHECK(at_rest.at("status") == "none");
    CHECK(at_rest.at("t").is_null());
    CHECK(at_rest.at("overlap") == 0.5);
    CHECK(spheres("1.5", "-1").at("status") == "none");
    CHECK(spheres("1.5", "-1").at("overlap") == 0.5);
    CHECK(spheres("1.5", "1").at("status") == "touching");
    CHECK(spheres("1.5", "1").at("overlap") == 0.5);
    CHECK(spheres("0", "0").at("overlap") == 2);
    // Touching is no overlap; the next double below is one, to its last digit.
    CHECK_FALSE(spheres("2", "0").contains("overlap"));
    CHECK(spheres("1.9999999999999998", "0").at("overlap") == 0x1p-52);
    CHECK_FALSE(spheres("2.5", "1").contains("overlap"));

    const auto over_plane = [](const std::string& z, const std::string& thickness) {
        return ask(R"({"a": {"p": [0,0,)" + z + R"(], "v": [0,0,0], "r": 1}, "plane": {"n": [0,0,2], "offset": 0)" +
                   thickness + "}}");
    };
    CHECK(over_plane("0.25", "").at("overlap") == 0.75);
    CHECK(over_plane("-3", "").at("overlap") == 4);
    CHECK_FALSE(over_plane("1", "").contains("overlap"));
    CHECK(over_plane("-1", R"(, "thickness": 0.5)").at("overlap") == 0.25);
    CHECK_FALSE(over_plane("-3", R"(, "thickness": 0.5)").contains("overlap"));
    // 1e300 squared is beyond the doubles, 1e-300 squared below them.
    for (const std::string size : {"1e300", "1e-300"}) {
        const json answer = ask(R"({"a": {"p": [0,0,0], "v": [0,0,0], "r": )" + size + R"(}, "b": {"p": [)" + size +
                                R"(,0,0], "v": [0,0,0], "r": )" + size + "}}");
        CHECK(answer.at("overlap").get<double>() == Approx(std::stod(size)).epsilon(1e-15));
    }
}

TEST_CASE("beyond `until` there is no impact", "[toi_line]")
{
    const std::string query =
        R"({"a": {"p": [0,0,0], "v": [1,0,0], "r": 1}, "b": {"p": [10,0,0], "v": [-1,0,0], "r": 2}, "until": )";
    CHECK(ask(query + "3.5}").at("status") == "impact");
    const json none = ask(query + "3.4999}");
    CHECK(none.at("status") == "none");
    CHECK(none.at("t").is_null());
    CHECK(ask(query + "0}").at("status") == "none");
    CHECK(ask(query + "-1}").at("status") == "error");
}

TEST_CASE("numbers are read and written to the last bit", "[toi_line]")
{
    const json answer = ask(R"({"a": {"p": [0.1,0.2,0.3], "v": [1e-3,0.7,0.11], "r": 0.3},
        "b": {"p": [0.30000000000000004,2.2,0.9], "v": [0,-0.13,0], "r": 0.6}})");
    MovingSphere a, b;
    a.position = {0.1, 0.2, 0.3};
    a.velocity = {1e-3, 0.7, 0.11};
    a.radius = 0.3;
    b.position = {0.30000000000000004, 2.2, 0.9};
    b.velocity = {0, -0.13, 0};
    b.radius = 0.6;
    const TimeOfImpact hit = time_of_impact(a, b);
    REQUIRE(hit);
    CHECK(answer.at("t").get<double>() == hit.t);
    CHECK(answer.at("lo").get<double>() == hit.t_lo);
    CHECK(answer.at("hi").get<double>() == hit.t_hi);
    CHECK(answer.at("approach_speed").get<double>() == hit.approach_speed);
    for (int k = 0; k < 3; ++k) CHECK(answer.at("normal")[k].get<double>() == hit.normal[k]);
}

TEST_CASE("an impact later than a double can say is none", "[toi_line]")
{
    // g n is -8.5e-555: it underflows, and exact signs see that the sphere falls, for 1e427.
    const json answer = ask(R"({"a": {"p": [1, -1e300, 5], "v": [6.5, 0, 1e9], "acc": [0, 0, -8.5e-255], "r": 16},
        "plane": {"n": [0, -1e300, 1], "offset": 0}})");
    CHECK(answer.at("status") == "none");
    CHECK(answer.at("t").is_null());
}

TEST_CASE("a line that is no query is answered with what is wrong", "[toi_line]")
{
    const std::string a = R"("a": {"p": [0,0,0], "v": [1,0,0], "r": 1})",
                      b = R"("b": {"p": [9,0,0], "v": [0,0,0], "r": 1})";
    const auto message = [](const std::string& line) {
        const json answer = ask(line);
        CHECK(answer.at("status") == "error");
        return answer.at("message").get<std::string>();
    };
    using Catch::Matchers::Contains;
    CHECK(ask("{" + a + "," + b + "}").at("status") == "impact");
    CHECK_THAT(message(""), Contains("JSON"));
    CHECK_THAT(message("{" + a + "," + b), Contains("JSON"));
    CHECK_THAT(message("\"\xff\xfe\""), Contains("JSON"));
    CHECK_THAT(message("[1]"), Contains("object"));
    CHECK_THAT(message("{" + a + "}"), Contains("either"));
    CHECK_THAT(message("{" + b + "}"), Contains("\"a\" is missing"));
    CHECK_THAT(message("{" + a + "," + b + R"(,"plane": {"n": [0,0,1], "offset": 0}})"), Contains("either"));
    CHECK_THAT(message("{" + a + R"(,"b": {"p": [9,0], "v": [0,0,0], "r": 1}})"), Contains("b.p"));
    CHECK_THAT(message("{" + a + R"(,"b": {"p": [9,0,"x"], "v": [0,0,0], "r": 1}})"), Contains("number"));
    CHECK_THAT(message("{" + a + R"(,"b": {"p": [9,0,1e999], "v": [0,0,0], "r": 1}})"), Contains("1e999"));
    CHECK_THAT(message("{" + a + R"(,"b": {"p": [9,0,1e305], "v": [0,0,0], "r": 1}})"), Contains("2^1000"));
    CHECK_THAT(message("{" + a + R"(,"b": {"p": [9,0,0], "v": [0,0,0], "r": -1}})"), Contains("negative"));
    CHECK_THAT(message("{" + a + R"(,"b": {"p": [9,0,0], "r": 1}})"), Contains("\"v\" is missing"));
    CHECK_THAT(message("{" + a + R"(,"b": {"p": [9,0,0], "v": [0,0,0], "r": 1, "m": 1}})"), Contains("unknown key"));
    CHECK_THAT(message("{" + a + R"(,"plane": {"n": [0,0,0], "offset": 0}})"), Contains("zero"));
    CHECK_THAT(message("{" + a + "," + b + R"(,"until": "soon"})"), Contains("until"));
    CHECK_THAT(message(std::string(100000, ' ')), Contains("longer"));
    CHECK_THAT(message(std::string(60000, '[')), Contains("JSON"));
}
