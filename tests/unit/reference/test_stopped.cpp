#include "reference_scenes.hpp"

#include <carom/simulate.hpp>

#include <catch2/catch.hpp>

#include <set>

using namespace carom;
using namespace carom::test;

TEST_CASE("a reference that is stopped ends at a sample that it reached, and is right up to there", "[reference]")
{
    const Scene scene = gas(3, 0.4);
    const std::vector<double> times = sample_grid(1, 10);
    const Reference whole = make_reference(scene, 1, times);
    REQUIRE(whole.until == 1);
    REQUIRE(whole.impacts.size() > 10);
    const Reference part = make_reference(
        scene, 1, times, [&](const Progress& now) { return now.stage != "reference" || now.amount < 0.55; });
    CHECK(part.stopped);
    CHECK_FALSE(part.reason.empty());
    CHECK(part.until == times[5]);
    REQUIRE(part.sample_times.size() == 6);
    for (std::size_t k = 0; k < part.samples.size(); ++k)
        for (std::size_t i = 0; i < scene.spheres.size(); ++i)
            CHECK(part.samples[k][i].position == whole.samples[k][i].position);
    std::size_t impacts = 0;
    while (whole.impacts[impacts].time <= times[5]) ++impacts;
    CHECK(part.impacts.size() == impacts);
}

TEST_CASE("a reference can be stopped before its first event, and says how far it is", "[reference]")
{
    std::set<std::string> stages;
    const Reference none = make_reference(gas(3, 0.4), 1, sample_grid(1, 10), [&](const Progress& now) {
        stages.insert(now.stage);
        return now.amount < 5;
    });
    CHECK(none.stopped);
    CHECK(none.until == 0);
    CHECK(none.impacts.empty());
    CHECK(stages == std::set<std::string>{"reference: contacts at the start"});
}
