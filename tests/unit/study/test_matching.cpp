#include "study/matching.hpp"

#include "make_sphere.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace carom;
using namespace carom::study;

namespace {

constexpr BodyId ball = 0, floor_id = 1;

/// An impact at t = 1 with 2 length/time after it, then halved flights of 0.4, 0.2, 0.1, ..., rest at 1.8.
Reference series_reference()
{
    Reference reference;
    reference.until = 10;
    reference.impacts = {{1, ball, floor_id}};
    reference.series = {{1, 1.8, ball, floor_id, 2, 0.5, 10}};
    return reference;
}

std::vector<FoundImpact> at(std::initializer_list<double> times)
{
    std::vector<FoundImpact> found;
    for (const double t : times) found.push_back({t, ball, floor_id});
    return found;
}

ExpectedImpacts expect(std::initializer_list<double> times)
{
    ExpectedImpacts expected;
    expected[{ball, floor_id}].times = times;
    return expected;
}

}  // namespace

TEST_CASE("an impact within three steps is found, farther away it is missed and invented", "[matching]")
{
    const MatchWindow window{0.3, 10};
    const MatchResult near = match_impacts(expect({1.0}), at({1.25}), {}, window);
    CHECK(near.expected == 1);
    CHECK(near.missed == 0);
    CHECK(near.invented == 0);
    const MatchResult far = match_impacts(expect({1.0}), at({1.35}), {}, window);
    CHECK(far.missed == 1);
    CHECK(far.invented == 1);
    CHECK(far.mistimed == 1);
    REQUIRE(far.missed_list.size() == 1);
    CHECK(far.missed_list[0].time == 1.0);
    CHECK(far.invented_list[0].time == 1.35);
}

TEST_CASE("impacts of another pair do not count", "[matching]")
{
    const std::vector<FoundImpact> other{{1.0, ball, 2}};
    const MatchResult result = match_impacts(expect({1.0}), other, {}, {0.3, 10});
    CHECK(result.missed == 1);
    CHECK(result.mistimed == 0);
    CHECK(result.invented == 1);
    CHECK(result.invented_list[0].b == 2);
}

TEST_CASE("each found impact takes the first free one, in time order", "[matching]")
{
    // Greedy in order: 1.0 goes to 1.1, 1.2 to 1.2, and 1.4 stays.
    const MatchResult result = match_impacts(expect({1.0, 1.2, 1.4}), at({1.1, 1.2}), {}, {0.3, 10});
    CHECK(result.missed == 1);
    CHECK(result.missed_list[0].time == 1.4);
    CHECK(result.invented == 0);
}

TEST_CASE("a bounce spread over two steps invents nothing, and a third far off does", "[matching]")
{
    const MatchResult result = match_impacts(expect({1.0}), at({1.0, 1.1, 1.5}), {}, {0.3, 10});
    CHECK(result.missed == 0);
    CHECK(result.invented == 1);
    CHECK(result.invented_list[0].time == 1.5);
}

TEST_CASE("nothing counts after the horizon, but an impact before it may be found after it", "[matching]")
{
    const MatchResult result = match_impacts(expect({1.0, 3.0}), at({1.2, 5.0}), {}, {0.3, 1.1});
    CHECK(result.expected == 1);
    CHECK(result.missed == 0);
    CHECK(result.invented == 0);
}

TEST_CASE("a method that finds nothing misses all", "[matching]")
{
    const MatchResult result = match_impacts(expect({1.0, 2.0, 3.0}), {}, {}, {0.3, 10});
    CHECK(result.missed == 3);
    CHECK(result.expected == 3);
}

TEST_CASE("lists of mismatches are cut, their counts are not", "[matching]")
{
    ExpectedImpacts expected;
    for (int i = 0; i < 1000; ++i) expected[{ball, floor_id}].times.push_back(1 + i);
    const MatchResult result = match_impacts(expected, {}, {}, {0.3, 1e6});
    CHECK(result.missed == 1000);
    CHECK(result.missed_list.size() == max_listed_mismatches);
    CHECK(result.missed_list[1].time == 2);
}

TEST_CASE("a series is expanded down to flights of four steps", "[matching]")
{
    const auto expected = expected_impacts(series_reference(), 4 * 0.02);  // flights of 0.4, 0.2, 0.1 are long enough
    const PairImpacts& pair = expected.at({ball, floor_id});
    REQUIRE(pair.times.size() == 4);
    CHECK(pair.times[0] == 1);
    CHECK(pair.times[1] == Approx(1.4));
    CHECK(pair.times[2] == Approx(1.6));
    CHECK(pair.times[3] == Approx(1.7));
    // Bounce k of the formula in reference.hpp.
    for (int k = 1; k < 4; ++k)
        CHECK(pair.times[static_cast<std::size_t>(k)] == Approx(1 + 2 * 2 * (1 - std::pow(0.5, k)) / (10 * 0.5)));
}

TEST_CASE("bounces in the tail of a series and after its rest are neither missed nor invented", "[matching]")
{
    const auto expected = expected_impacts(series_reference(), 4 * 0.02);
    const MatchResult result = match_impacts(expected, at({1, 1.4, 1.6, 1.7, 1.75, 1.9, 2.5, 9.0}), {}, {0.06, 10});
    CHECK(result.missed == 0);
    CHECK(result.invented == 0);
    // The control: what was expanded is missed by who does not see it, and what comes before the series is invented.
    const MatchResult blind = match_impacts(expected, at({0.5}), {}, {0.06, 10});
    CHECK(blind.missed == 4);
    CHECK(blind.invented == 1);
}

TEST_CASE("a series on a fixed sphere is matched by the pair as events name it", "[matching]")
{
    Reference reference = series_reference();
    constexpr BodyId bump = 0, bouncer = 1;
    reference.impacts = {{1, bump, bouncer}};
    reference.series[0].body = bouncer;
    reference.series[0].plane = bump;
    const auto expected = expected_impacts(reference, 4 * 0.02);
    REQUIRE(expected.size() == 1);
    CHECK(expected.at({bump, bouncer}).times.size() == 4);
}

TEST_CASE("where the reference begins its series makes no difference", "[matching]")
{
    Reference late = series_reference();
    // The same motion: two bounces more as impacts, the series from 1.6 on with a quarter of the speed.
    late.impacts = {{1, ball, floor_id}, {1.4, ball, floor_id}, {1.6, ball, floor_id}};
    late.series = {{1.6, 1.8, ball, floor_id, 0.5, 0.5, 10}};
    for (const double shortest : {0.5, 0.3, 0.15, 0.08, 0.04}) {
        CAPTURE(shortest);
        const auto a = expected_impacts(series_reference(), shortest).at({ball, floor_id});
        const auto b = expected_impacts(late, shortest).at({ball, floor_id});
        REQUIRE(a.times.size() == b.times.size());
        for (std::size_t i = 0; i < a.times.size(); ++i) CHECK(a.times[i] == Approx(b.times[i]));
        CHECK(a.exempt.front().begin == Approx(b.exempt.front().begin));
    }
}

TEST_CASE("fast impacts of other kinds are not excused by their number", "[matching]")
{
    // Between two walls: no series, so each one counts however short the flight.
    Reference reference;
    reference.until = 10;
    for (int i = 0; i < 10; ++i) reference.impacts.push_back({1 + 0.01 * i, ball, static_cast<BodyId>(1 + i % 2)});
    const auto expected = expected_impacts(reference, 4 * 0.1);
    CHECK(match_impacts(expected, {}, {}, {0.3, 10}).missed == 10);
}

TEST_CASE("the event method keeps a series closed", "[matching]")
{
    const auto expected = expected_impacts(series_reference(), 0);
    CHECK(expected.at({ball, floor_id}).times == std::vector<double>{1});
    CHECK(match_impacts(expected, at({1}), at({1.8}), {1e-5, 10}).missed == 0);
}

TEST_CASE("a run may close its series earlier than the reference, or later", "[matching]")
{
    Reference later = series_reference();
    later.impacts.push_back({1.4, ball, floor_id});
    later.series[0].start = 1.4;
    later.series[0].normal_speed = 1;
    const auto expected = expected_impacts(later, 0);
    CHECK(match_impacts(expected, at({1}), at({1.8}), {1e-5, 10}).missed == 0);
    CHECK(match_impacts(expected, at({1}), {}, {1e-5, 10}).missed == 1);  // without the rest it is missed
    const MatchResult own =
        match_impacts(expected_impacts(series_reference(), 0), at({1, 1.4, 1.6}), at({1.8}), {1e-5, 10});
    CHECK(own.missed == 0);
    CHECK(own.invented == 0);
}

TEST_CASE("answers in a contact that persists in the reference are not invented impacts, others are", "[matching]")
{
    Reference reference;
    reference.until = 3;
    reference.contacts = {{0, 2, ball, floor_id}};
    const auto expected = expected_impacts(reference, 0.04);
    CHECK(match_impacts(expected, at({0.1, 0.5, 1.5}), {}, {0.03, 3}).invented == 0);
    CHECK(match_impacts(expected, at({0.1, 0.5, 1.5, 2.5, 2.7}), {}, {0.03, 3}).invented == 2);
}

TEST_CASE("bounces too short for a method that end in a contact are not asked of it, nor invented by it", "[matching]")
{
    // Two spheres: flights of 0.4, 0.2, 0.1, 0.05, .. from t = 1 on, at rest on each other from 1.8 to 3.
    Reference reference;
    reference.until = 10;
    for (double t = 1, flight = 0.4; flight > 1e-3; t += flight, flight /= 2) reference.impacts.push_back({t, 2, 5});
    reference.contacts = {{1.8, 3, 2, 5}};
    const PairImpacts pair = expected_impacts(reference, 0.15).at({2, 5});
    REQUIRE(pair.times.size() == 3);  // that after the flight of 0.2 is the last
    CHECK(pair.times[2] == Approx(1.6));
    REQUIRE(pair.exempt.size() == 1);
    CHECK(pair.exempt[0].begin == pair.times[2]);
    CHECK(pair.exempt[0].end == 3);
    CHECK(expected_impacts(reference, 0).at({2, 5}).times.size() == reference.impacts.size());
}

TEST_CASE("rests stand for the impacts that the definition gives them, for any mix of times", "[matching]")
{
    std::mt19937_64 random(3);
    const auto time = [&] { return static_cast<double>(random() % 40) / 4; };  // ties are frequent
    std::int64_t closed_in_all = 0;
    for (int round = 0; round < 400; ++round) {
        ExpectedImpacts expected;
        std::vector<FoundImpact> found, rests;
        for (std::uint64_t k = random() % 12; k > 0; --k) expected[{ball, floor_id}].times.push_back(time());
        std::vector<double>& times = expected[{ball, floor_id}].times;
        std::sort(times.begin(), times.end());
        for (std::uint64_t k = random() % 4; k > 0; --k) found.push_back({time(), ball, floor_id});
        for (std::uint64_t k = random() % 4; k > 0; --k) rests.push_back({time(), ball, floor_id});
        const MatchWindow window{0.3, 100};
        // Without rests everything that nothing took is missed. A rest stands for one of them where the last impact
        // found up to that rest is earlier, and the rest is at most the width too early.
        const MatchResult without = match_impacts(expected, found, {}, window);
        std::int64_t closed = 0;
        for (const ImpactMismatch& missed : without.missed_list)
            closed += std::any_of(rests.begin(), rests.end(), [&](const FoundImpact& rest) {
                double last = -1;
                for (const FoundImpact& each : found)
                    if (each.time <= rest.time) last = std::max(last, each.time);
                return last >= 0 && last < missed.time && missed.time <= rest.time + window.width;
            });
        CAPTURE(round);
        CHECK(match_impacts(expected, found, rests, window).missed == without.missed - closed);
        closed_in_all += closed;
    }
    CHECK(closed_in_all > 100);
}

TEST_CASE("of the missed impacts of many pairs the first two hundred in time are listed", "[matching]")
{
    ExpectedImpacts expected;
    for (int k = 0; k < 5000; ++k) expected[{k, k + 1}].times.push_back(1 + static_cast<double>(k * 7919 % 5000));
    const MatchResult result = match_impacts(expected, {}, {}, {0.5, 1e9});
    CHECK(result.missed == 5000);
    REQUIRE(result.missed_list.size() == max_listed_mismatches);
    for (std::size_t i = 0; i < max_listed_mismatches; ++i)
        CHECK(result.missed_list[i].time == 1 + static_cast<double>(i));
}

TEST_CASE("an impact that the run took for rest is absorbed, not missed, and a slow one is not invented", "[matching]")
{
    ExpectedImpacts expected;
    expected[{0, 1}].times = {1, 2, 3};
    const MatchWindow window{0.1, 10};
    const IsAbsorbed second = [](const Pair&, double time) { return time == 2; };
    const std::vector<FoundImpact> found{{1, 0, 1}, {5, 0, 1, true}, {6, 0, 1, false}};
    const MatchResult result = match_impacts(expected, found, {}, window, second);
    CHECK(result.absorbed == 1);
    CHECK(result.missed == 1);
    CHECK(result.invented == 1);
}

TEST_CASE("impacts in time are matched before others, so that one more does not shift the rest", "[matching]")
{
    ExpectedImpacts expected;
    expected[{0, 1}].times = {1, 1.01, 1.02, 1.03};
    const std::vector<FoundImpact> found{{1.01, 0, 1}, {1.02, 0, 1}, {1.03, 0, 1}};
    const MatchResult result = match_impacts(expected, found, {}, {0.1, 10, 1e-6});
    CHECK(result.late == 0);
    CHECK(result.missed == 1);
    CHECK(result.missed_list.front().time == 1);
}
