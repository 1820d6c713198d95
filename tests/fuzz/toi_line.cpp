/// \file
/// A line of `carom toi`: whatever is asked, one line of JSON answers, and a time lies in its interval.
#include "io/toi_line.hpp"
#include "fuzz/fuzz.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace carom::fuzz {

namespace {

using nlohmann::json;

void check_hit(const json& answer)
{
    const double t = answer.at("t"), lo = answer.at("lo"), hi = answer.at("hi");
    expect(0 <= lo && lo <= t && t <= hi && std::isfinite(hi), "t is not in [lo, hi]");
    expect(answer.at("status") != "touching" || t == 0, "touching, but not at once");
    expect(answer.at("approach_speed") >= 0, "an approach that separates");
    double length = 0;
    for (const json& each : answer.at("normal")) length += each.get<double>() * each.get<double>();
    expect(std::abs(length - 1) < 1e-12, "a normal that is not of unit length");
}

void check_answer(const std::string& line)
{
    expect(line.find('\n') == std::string::npos, "an answer of several lines");
    const json answer = json::parse(line);
    const std::string status = answer.at("status");
    if (status == "error") {
        expect(!answer.at("message").get<std::string>().empty(), "an error without a message");
        return;
    }
    const int level = answer.at("level");
    expect(0 <= level && level <= 2, "an unknown level");
    if (answer.contains("overlap")) expect(answer.at("overlap") > 0, "an overlap of nothing");
    if (status == "none")
        expect(answer.at("t").is_null() && answer.at("lo").is_null(), "a time without an impact");
    else if (status == "impact" || status == "touching")
        check_hit(answer);
    else
        finding("an unknown status");
}

}  // namespace

std::vector<std::string> seeds()
{
    return {
        R"({"a":{"p":[0,0,0],"v":[1,0,0],"r":1},"b":{"p":[10,0,0],"v":[-1,0,0],"r":2}})",
        R"({"a":{"p":[0,0,0],"v":[1,0,0],"r":1},"b":{"p":[10,2.9999999999999996,0],"v":[-1,0,0],"r":2},"until":1e9})",
        R"({"a":{"p":[0,0,0],"v":[1,0,0],"acc":[0,0,-9.81],"r":1},"b":{"p":[10,0,0],"v":[-1,0,3],"acc":[0,0,-9.81],"r":2}})",
        R"({"a":{"p":[0,0,0],"v":[1,0,0],"acc":[0,0,-9.81],"r":0.5},"b":{"p":[10,0,0],"v":[-1,0,3],"acc":[1e-200,0,0],"r":2}})",
        R"({"a":{"p":[0,0,5],"v":[1,0,0],"acc":[0,0,-2],"r":1},"plane":{"n":[0,0,1],"offset":0}})",
        R"({"a":{"p":[0,0,-5],"v":[0,0,1],"r":1},"plane":{"n":[1,2,3],"offset":1,"thickness":0.5},"until":100})",
        R"({"a":{"p":[0,0,1],"v":[0,0,0],"acc":[0,0,-2],"r":1},"plane":{"n":[0,0,1],"offset":0}})",
        R"({"a":{"p":[1e100,0,0],"v":[-1e-100,0,0],"r":1e-300},"b":{"p":[-1e100,0,0],"v":[0,0,0],"r":1e300}})",
        R"({"a":{"p":[0,0,0],"v":[0,0,0],"r":1},"b":{"p":[1.9999999999999998,0,0],"v":[0,0,0],"r":1}})",
        R"({"a":{"p":[0,0,-1],"v":[0,0,0],"r":1},"plane":{"n":[0,0,1],"offset":0,"thickness":0.5}})",
        R"({"a":{"p":[0,0,0],"v":[0,0,0],"r":-1}})",
        R"({"a":1,"b":[null,true,"x"]})",
        "",
        "{"};
}

}  // namespace carom::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    carom::fuzz::check_answer(carom::io::answer_toi_line({reinterpret_cast<const char*>(data), size}));
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int seed)
{
    static const std::vector<std::string_view> words{"a", "b",     "p",      "v",         "acc",  "r",
                                                     "n", "plane", "offset", "thickness", "until"};
    return carom::fuzz::mutate_json(data, size, most, seed, words);
}
