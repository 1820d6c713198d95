#include <catch2/catch.hpp>

#include "io/json.hpp"
#include "io/scene_json.hpp"
#include "problems_of.hpp"

#include <carom/method.hpp>

#include <fstream>

using namespace carom;
using namespace carom::test;
using Catch::Contains;
using Catch::StartsWith;

namespace {

Scene read(const std::string& members)
{
    return parse_scene(scene_with(members), "s.json");
}

/// Written by scene_json and read again.
Scene reread(const Scene& scene)
{
    return parse_scene(io::scene_json_without_spheres(scene), "again.json");
}

/// The words of an enumeration in the schema.
std::vector<std::string> schema_words(const std::vector<std::string>& path)
{
    std::ifstream stream(std::string(CAROM_SCENE_DIR) + "/scene.schema.json");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const io::Json schema = io::parse_json(text, "schema");
    const io::Json* place = &schema;
    for (const std::string& key : path) {
        place = place->find(key);
        REQUIRE(place != nullptr);
    }
    std::vector<std::string> words;
    for (const io::Json& word : place->find("enum")->items) words.push_back(word.text);
    return words;
}

template <class Names>
std::vector<std::string> listed(const Names& names)
{
    return {names.begin(), names.end()};
}

}  // namespace

TEST_CASE("a scene that says nothing about responses has the documented ones", "[io]")
{
    const Scene s = read("");
    CHECK(s.impact.impact_operator == ImpactOperator::reflections);
    CHECK_FALSE(s.impact.tie);
    CHECK(s.rest.policy == RestPolicy::contact);
    CHECK(s.guard.on);
    CHECK(s.guard.impacts == 100);
    CHECK_FALSE(s.guard.window);
    CHECK(s.guard.fallback == GuardFallback::moreau);
}

TEST_CASE("an impact operator is a word or an object with options, and survives being written", "[io]")
{
    for (std::size_t k = 0; k < impact_operator_names.size(); ++k) {
        const std::string word(impact_operator_names[k]);
        CAPTURE(word);
        CHECK(read("\"impact\": \"" + word + "\"").impact.impact_operator == static_cast<ImpactOperator>(k));
        const Scene s = read(R"("impact": {"tie": 1e-6, "operator": ")" + word + "\"}");
        CHECK(s.impact.impact_operator == static_cast<ImpactOperator>(k));
        CHECK(s.impact.tie == 1e-6);
        CHECK(reread(s).impact.impact_operator == s.impact.impact_operator);
        CHECK(reread(s).impact.tie == s.impact.tie);
    }
    const Scene lcp =
        read(R"("impact": {"operator": "lcp", "law": "poisson", "solver": "gauss_seidel", "sweeps": 12})");
    for (const Scene& s : {lcp, reread(lcp)}) {
        CHECK(s.impact.lcp.law == LcpLaw::poisson);
        CHECK(s.impact.lcp.solver == LcpSolver::gauss_seidel);
        CHECK(s.impact.lcp.sweeps == 12);
    }
    CHECK_FALSE(reread(read("")).impact.tie);
    CHECK(read("").impact.on_cap == OnCap::accept);
    const Scene stopping = read(R"("impact": {"on_cap": "stop"})");
    CHECK(stopping.impact.on_cap == OnCap::stop);
    CHECK(reread(stopping).impact.on_cap == OnCap::stop);
}

TEST_CASE("the guard is on, off, or an object with options, and survives being written", "[io]")
{
    CHECK(read(R"("guard": "on")").guard.on);
    CHECK_FALSE(read(R"("guard": "off")").guard.on);
    CHECK_FALSE(reread(read(R"("guard": "off")")).guard.on);
    for (std::size_t k = 0; k < guard_fallback_names.size(); ++k) {
        const Scene s = read(R"("guard": {"impacts": 5, "window": 0.25, "fallback": ")" +
                             std::string(guard_fallback_names[k]) + "\"}");
        for (const Scene& each : {s, reread(s)}) {
            CHECK(each.guard.on);
            CHECK(each.guard.impacts == 5);
            CHECK(each.guard.window == 0.25);
            CHECK(each.guard.fallback == static_cast<GuardFallback>(k));
        }
    }
    CHECK_FALSE(reread(read("")).guard.window);
}

TEST_CASE("rest policies are read and written", "[io]")
{
    for (std::size_t k = 0; k < rest_policy_names.size(); ++k) {
        const Scene s = read(R"("rest": {"policy": ")" + std::string(rest_policy_names[k]) + "\"}");
        CHECK(s.rest.policy == static_cast<RestPolicy>(k));
        CHECK(reread(s).rest.policy == s.rest.policy);
    }
}

TEST_CASE("what is wrong with responses is answered with place and cure", "[io]")
{
    CHECK(problem_with(R"("impact": "reflection")") ==
          "s.json: /impact: \"reflection\": unknown (did you mean \"reflections\"?)");
    CHECK_THAT(problem_with(R"("impact": "xyz")"), Contains("(take: reflections, sequential, lcp, shock, jacobi)"));
    CHECK_THAT(problem_with(R"("impact": 3)"),
               StartsWith("s.json: /impact: must be the name of an operator or an object, is"));
    CHECK_THAT(problem_with(R"("impact": {"operator": "shok"})"),
               StartsWith("s.json: /impact/operator: \"shok\": unknown (did you mean \"shock\"?)"));
    CHECK_THAT(problem_with(R"("impact": {"operater": "lcp"})"),
               StartsWith("s.json: /impact/operater: unknown key (did you mean \"operator\"?)"));
    CHECK_THAT(problem_with(R"("impact": {"tie": -1})"), StartsWith("s.json: /impact/tie: must be >= 0, is -1"));
    for (const char* option : {R"("law": "poisson")", R"("solver": "exact")", R"("sweeps": 3)"}) {
        CAPTURE(option);
        CHECK_THAT(problem_with(R"("impact": {"operator": "shock", )" + std::string(option) + "}"),
                   Contains(": is for the operator \"lcp\" (remove it, or take that operator)"));
        CHECK(problems_of(scene_with(R"("impact": {"operator": "lcp", )" + std::string(option) + "}")).empty());
    }
    CHECK_THAT(problem_with(R"("impact": {"operator": "lcp", "sweeps": 0})"),
               StartsWith("s.json: /impact/sweeps: must be an integer from 1"));
    CHECK_THAT(problem_with(R"("impact": {"operator": "lcp", "law": "hertz"})"),
               StartsWith("s.json: /impact/law: \"hertz\": unknown"));
    // The options of a misspelt operator are not reported too.
    CHECK_THAT(problem_with(R"("impact": {"operator": "lpc", "law": "poisson"})"), Contains("did you mean \"lcp\"?"));
    CHECK_THAT(problem_with(R"("guard": "of")"), StartsWith("s.json: /guard: \"of\": unknown (did you mean \"o"));
    CHECK(problem_with(R"("guard": false)") == "s.json: /guard: must be \"on\", \"off\" or an object, is false");
    CHECK_THAT(problem_with(R"("guard": {"window": 0})"), StartsWith("s.json: /guard/window: must be > 0, is 0"));
    CHECK_THAT(problem_with(R"("guard": {"impacts": 0})"), StartsWith("s.json: /guard/impacts: must be an integer"));
    CHECK_THAT(problem_with(R"("guard": {"fallback": "naive"})"),
               StartsWith("s.json: /guard/fallback: \"naive\": unknown (take: moreau, velocity, pbd, windows)"));
    CHECK_THAT(problem_with(R"("rest": {"policy": "micron"})"),
               StartsWith("s.json: /rest/policy: \"micron\": unknown (did you mean \"micro\"?)"));
}

TEST_CASE("the schema lists the words of the public headers", "[io]")
{
    CHECK(schema_words({"$defs", "impact_operator"}) == listed(impact_operator_names));
    CHECK(schema_words({"$defs", "impact", "properties", "law"}) == listed(lcp_law_names));
    CHECK(schema_words({"$defs", "impact", "properties", "solver"}) == listed(lcp_solver_names));
    CHECK(schema_words({"$defs", "guard", "properties", "fallback"}) == listed(guard_fallback_names));
    CHECK(schema_words({"$defs", "rest", "properties", "policy"}) == listed(rest_policy_names));
    CHECK(schema_words({"$defs", "check", "properties", "type"}) == listed(check_type_names));
    CHECK(schema_words({"$defs", "check", "properties", "kind"}) == listed(event_kind_names));
    CHECK(schema_words({"$defs", "method"}) == method_names());
}
