#include "report/stress_page.hpp"

#include "io/stress_files.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace carom;
using namespace carom::stress;

namespace {

Result result(const char* method, bool is_exact, Symptom symptom)
{
    Result made{.method = method, .is_exact = is_exact};
    made.findings.push_back({"scene, e = 0.9", Evidence{}, symptom});
    if (symptom != Symptom::none) made.reason = "scene, e = 0.9: off by 1";
    return made;
}

Case make_case(const char* name, Symptom event, Symptom pbd)
{
    Case made;
    made.words.case_name = name;
    made.results = {result("event", true, event), result("pbd", false, pbd)};
    return made;
}

}  // namespace

TEST_CASE("the verdict counts what is required, and names what waits", "[stress_page]")
{
    Report report{
        .methods = {"event", "pbd"},
        .cases = {make_case("a", Symptom::none, Symptom::none), make_case("b", Symptom::none, Symptom::late)}};
    using Sentences = std::vector<std::string>;
    CHECK(report::stress_verdict(report) == Sentences{"event passes 2 of 2 cases.", "pbd passes 1 of 2."});
    report.cases.push_back(make_case("c", Symptom::late, Symptom::sank));
    CHECK(report::stress_verdict(report) == Sentences{"event passes 2 of 3 cases.", "pbd passes 1 of 3."});
    report.cases[2].words.waits_for = "better days";
    CHECK(report::stress_verdict(report) == Sentences{"event passes 2 of 2 cases.", "pbd passes 1 of 2.",
                                                      "Not required yet, and not counted: c for better days."});
    CHECK(report::stress_verdict({}).empty());
}

TEST_CASE("the page of stress has the data of stress.json, with the verdict and who wrote it", "[stress_page]")
{
    const Report report{.methods = {"event", "pbd"}, .cases = {make_case("a", Symptom::none, Symptom::late)}};
    const auto data = nlohmann::json::parse(report::stress_page_data(report, io::stress_json(report), "carom 9"));
    CHECK(data["format"] == "carom-stress-page/1");
    CHECK(data["generator"] == "carom 9");
    CHECK(data["verdict"][0] == "event passes 1 of 1 case.");
    const auto& pbd = data["cases"][0]["results"][1];
    CHECK(pbd["scene"] == "scene, e = 0.9");
    CHECK(pbd["symptom"] == "late");
    CHECK(pbd["runs"][0]["scene"] == "scene, e = 0.9");
}
