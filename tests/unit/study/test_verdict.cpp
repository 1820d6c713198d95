#include "study/timing.hpp"
#include "study/words.hpp"

#include <carom/study.hpp>

#include "make_sphere.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace carom;
using namespace carom::study;
using Catch::Matchers::Contains;

namespace {

Scene metric_scene()
{
    Scene scene;
    scene.units = {"m", "s", "kg"};
    scene.spheres.push_back(make_sphere("ball", 0.1));
    return scene;
}

CompareRow event_row(double error, double cpu)
{
    CompareRow row;
    row.method = "event";
    row.position_max = row.position_final_max = error;
    row.cpu_seconds = cpu;
    row.reference_impacts = 1;
    row.time = 5;
    return row;
}

CompareRow step_row(const char* method, double dt, double error, double cpu)
{
    CompareRow row = event_row(error, cpu);
    row.method = method;
    row.dt = dt;
    row.substeps = row.passes = 1;
    return row;
}

Comparison comparison(std::vector<CompareRow> rows)
{
    Comparison result;
    result.until = result.reference.until = 5;
    result.tolerance = 1e-3;
    result.reference.bound = 1e-20;
    result.rows = std::move(rows);
    return result;
}

std::string sentence(const Comparison& c, std::size_t i)
{
    return verdict(metric_scene(), c).at(i);
}

}  // namespace

TEST_CASE("the verdict names the largest step that is good enough, and its price", "[verdict]")
{
    const Comparison c =
        comparison({event_row(3.1e-15, 1e-5), step_row("velocity", 1.0 / 60, 0.1, 1e-4),
                    step_row("velocity", 2e-4, 8e-4, 3.1e-3), step_row("velocity", 1e-4, 4e-4, 6.2e-3)});
    CHECK(sentence(c, 0) ==
          "Use event: it is off by at most 3.1e-15 m and takes 10 us of CPU; the cheapest stepper "
          "within 1 mm, velocity at dt = 2e-4, costs 310 times the event run.");
    CHECK(sentence(c, 1) ==
          "velocity: of the steps tried, dt = 2e-4 is the largest from which all smaller ones keep within a position "
          "error "
          "of 1 mm; it costs 310 times the event run; the next larger, 1/60, is off by 10 cm (to close in, try --dt "
          "1/60:2e-4:log5).");
}

TEST_CASE("a method that never gets there is told its best", "[verdict]")
{
    const Comparison c = comparison(
        {event_row(0, 1e-5), step_row("pbd", 1.0 / 60, 0.4, 1e-5), step_row("pbd", 1.0 / 2400, 0.032, 4e-4)});
    CHECK(
        sentence(c, 0).find("; no stepper tried comes within 1 mm (the best, pbd at dt = 1/2400, is off by 3.2 cm).") !=
        std::string::npos);
    CHECK(sentence(c, 1) ==
          "pbd: no step tried keeps within a position error of 1 mm (best 3.2 cm at dt = 1/2400, 40 times the event "
          "run).");
}

TEST_CASE("missed impacts are counted, and a small error does not excuse them", "[verdict]")
{
    CompareRow blind = step_row("pbd", 1.0 / 60, 5e-4, 1e-6);
    blind.missed_impacts = 1;
    const Comparison c = comparison({event_row(0, 1e-5), blind});
    CHECK(
        sentence(c, 1) ==
        "pbd: no step tried keeps within a position error of 1 mm without missing an impact (0.5 mm at dt = 1/60, 0.1 "
        "times the event run); it misses 1 of 1 impacts at dt = 1/60.");
}

TEST_CASE("impacts that come too early or late are not lost, and what the audit says is told with the price",
          "[verdict]")
{
    CompareRow late = step_row("pbd", 1e-4, 5e-4, 1e-5);
    late.reference_impacts = 35;
    late.missed_impacts = late.mistimed_impacts = 20;
    late.invented_impacts = 29;
    late.audit = Audit{263, 182, 0, 0, 81, 12, 0, 0, 0.5};
    CHECK(sentence(comparison({event_row(0, 1e-5), late}), 1) ==
          "pbd: the only step tried, dt = 1e-4, keeps within a position error of 1 mm; it costs 1 times the event run; "
          "asked impact by impact, it answers with a wrong velocity 30.8 % (25.5-36.6).");
    late.mistimed_impacts = 19;
    CHECK_THAT(sentence(comparison({event_row(0, 1e-5), late}), 1),
               Contains("without missing an impact") && Contains("misses 1 of 35"));
}

TEST_CASE("a stepper that is within the tolerance at less cost wins, if that is sure", "[verdict]")
{
    CompareRow event = event_row(1e-15, 1e-5), step = step_row("bisection", 0.01, 5e-4, 4e-6);
    event.cpu_low = 9e-6;
    event.cpu_high = 1.1e-5;
    step.cpu_low = 3e-6;
    step.cpu_high = 5e-6;
    CHECK(
        sentence(comparison({event, step}), 0) ==
        "A stepper wins: bisection at dt = 0.01 keeps within 1 mm and costs 0.4 (0.27-0.56) times the event run; event "
        "is off by at most 1e-15 m and takes 10 us of CPU.");
    step.cpu_high = 1e-5;
    CHECK_THAT(sentence(comparison({event, step}), 0), Catch::Matchers::StartsWith("Use event: it is off"));
}

TEST_CASE("what is exact to rounding is not called better than what is, too, but told with its price", "[verdict]")
{
    const Comparison c = comparison({event_row(2e-15, 1e-5), step_row("toi", 0.25, 1e-15, 1.2e-5)});
    CHECK(
        sentence(c, 0) ==
        "Use event: it is off by at most 2e-15 m and takes 10 us of CPU; the cheapest stepper within 1 mm, toi at dt = "
        "1/4, costs 1.2 times the event run.");
}

TEST_CASE("the event method's own faults are told apart", "[verdict]")
{
    CompareRow event = event_row(1e-6, 1e-5);
    event.audit = Audit{185, 170, 9, 6, 0, 0, 190, 2, std::nullopt};
    event.absorbed_impacts = 6;
    CHECK(sentence(comparison({event}), 1) ==
          "event itself, of 191 impacts of the reference: 6 missed, 9 early or late by more than touching is, 2 "
          "invented, "
          "6 closing slower than v_c taken for rest; its error has that in it.");
}

TEST_CASE("what the search for a step found is told, and why it found none", "[verdict]")
{
    Comparison c = comparison({event_row(0, 1e-5), step_row("pbd", 1.0 / 60, 0.1, 1e-5)});
    StepSearch found;
    found.end = StepSearch::End::found;
    found.method = "pbd";
    found.row = step_row("pbd", 5e-4, 9.8e-4, 2e-4);
    found.tries = {{2e-4, 4e-4, true}, {4e-4, 9.9e-4, true}, {5e-4, 9.8e-4, true}, {5.2e-4, 1.03e-3, false}};
    found.is_complete = true;
    StepSearch capped = found;
    capped.variant = ", parabola";
    capped.tries.pop_back();
    capped.is_complete = false;
    capped.largest = 5e-4;
    StepSearch stalls;
    stalls.end = StepSearch::End::stalls;
    stalls.method = "pbd";
    stalls.variant = ", order jacobi";
    stalls.tries = {{1e-5, 4.9e-3, false}, {1e-3, 6e-3, false}};
    StepSearch dear = stalls;
    dear.end = StepSearch::End::not_reached;
    dear.method = "moreau";
    StepSearch lucky = dear;
    lucky.method = "naive";
    lucky.tries.push_back({0.01, 1e-4, true});
    c.searches = {found, capped, stalls, dear, lucky};
    c.convergence = {{"pbd", "", 0.98, 0.051, 4, false, 1e-4}, {"pbd", ", order jacobi", 0.01, 0.02, 3, true, 4.9e-3}};
    CHECK(sentence(c, 1) ==
          "pbd: dt = 5e-4 is enough: all 3 steps tried from 2e-4 up to it keep within a position error of 1 mm, the "
          "worst is off by 0.99 mm; it costs 20 times the event run; at 0.00052 it is off by 1.03 mm.");
    CHECK_THAT(sentence(c, 2), Contains("not all steps that a search tries were run, for its 10 s were over") &&
                                   Contains("larger steps are not tried (up to an eighth of the run"));
    CHECK(sentence(c, 3) ==
          "pbd, order jacobi: no step tried keeps within a position error of 1 mm (2 tried, from 1e-5 to 0.001; best "
          "4.9 mm at dt = 1e-5), and errors no longer fall.");
    CHECK_THAT(sentence(c, 4), Contains("moreau, order jacobi: no step tried keeps within") &&
                                   Contains("); smaller ones would take more than 10 s of runs."));
    CHECK(sentence(c, 5) ==
          "naive, order jacobi: no step tried is safe: 1 of 3 tried, from 1e-5 to 0.01, keep within a position error "
          "of 1 mm, but not "
          "the smaller 1e-5.");
    CHECK(sentence(c, 6) ==
          "Errors fall with the step: pbd as dt^0.98 +- 0.051. Errors no longer fall with smaller steps: pbd, order "
          "jacobi at 4.9 mm.");
}

TEST_CASE("being right at the end does not make up for being wrong before", "[verdict]")
{
    CompareRow bounced = step_row("pbd", 0.01, 0.09, 1e-5);
    bounced.position_final_max = 1e-15;
    CHECK_THAT(sentence(comparison({event_row(0, 1e-5), bounced}), 1),
               Contains("no step tried keeps within a position error of 1 mm (best 9 cm"));
}

TEST_CASE("a lucky step is called one", "[verdict]")
{
    const Comparison c =
        comparison({event_row(0, 1e-5), step_row("pbd", 1.0 / 60, 5e-4, 1e-5), step_row("pbd", 1.0 / 240, 0.2, 4e-5)});
    CHECK_THAT(sentence(c, 1), Contains("dt = 1/60 keeps within") &&
                                   Contains("but the smaller 1/240 is off by 20 cm: no step tried is safe"));
}

TEST_CASE("the event method is judged like the others", "[verdict]")
{
    SECTION("too far off")
    {
        const Comparison c = comparison({event_row(0.03, 1e-5), step_row("pbd", 1.0 / 60, 5e-4, 1e-5)});
        CHECK_THAT(sentence(c, 0), Contains("not within 1 mm") && Contains("3 cm") && Contains("which is less"));
    }
    SECTION("ended early")
    {
        CompareRow row = event_row(0, 1e-5);
        row.status = Status::unresolved;
        row.message = "two balls on a third";
        row.time = 2.5;
        CHECK(sentence(comparison({row}), 0) ==
              "event stopped early, at t = 2.5 s of 5 s (unresolved: two balls on a third), after 10 us of CPU; up to "
              "t = 2.5 s "
              "it is off by at most 0 m.");
    }
    SECTION("missed one")
    {
        CompareRow row = event_row(1e-9, 1e-5);
        row.missed_impacts = 1;
        CHECK_THAT(sentence(comparison({row}), 0), !Contains("Use") && Contains("misses 1 of 1"));
    }
    SECTION("diverged")
    {
        CompareRow row = event_row(0.3, 1e-5);
        row.divergence_time = 2;
        CHECK_THAT(sentence(comparison({row}), 1), Contains("t = 2 s") && Contains("compare energy"));
    }
    SECTION("not run")
    {
        CHECK_THAT(sentence(comparison({step_row("pbd", 0.01, 0.2, 1e-5)}), 0), Contains("not among those run"));
    }
}

TEST_CASE("a reference that ends early says up to when figures hold", "[verdict]")
{
    CompareRow row = event_row(1e-12, 1e-5);
    row.position_final_max.reset();
    Comparison c = comparison({row, step_row("pbd", 0.01, 0.2, 1e-5)});
    c.reference.until = 1.0468123;
    c.reference.reason = "three spheres meet";
    CHECK_THAT(sentence(c, 2), Catch::Matchers::StartsWith("pbd up to t = 1.0468 s: no step tried"));
    CHECK_THAT(sentence(c, 0),
               Catch::Matchers::StartsWith("Up to t = 1.0468 s of 5 s, where the reference ends, use event"));
    CHECK(sentence(c, 1) ==
          "The reference holds up to t = 1.0468 s of 5 s (three spheres meet): errors and impacts are counted up to "
          "there.");
}

TEST_CASE("where the reference ends at the start nothing is right or wrong", "[verdict]")
{
    Scene scene = metric_scene();
    scene.gravity = {0, 0, -10};
    CompareRow event = event_row(0, 1e-5), step = step_row("pbd", 0.01, 0, 1e-5);
    for (CompareRow* row : {&event, &step}) {
        row->position_max.reset();
        row->reference_impacts = 0;
    }
    Comparison c = comparison({event, step});
    c.reference.until = 0;
    c.reference.sample_times = {0};
    c.reference.reason = "contacts turn: roller at t = 0";
    const std::vector<std::string> said = verdict(scene, c);
    REQUIRE(said.size() == 2);
    CHECK_THAT(said[0], Contains("no verdict") && Contains("roller at t = 0"));
    CHECK_THAT(said[1], Contains("--set /rest/numeric_step=0.001"));
}

TEST_CASE("a step that holds above one that does not is no answer, and the range to look in is told", "[verdict]")
{
    CompareRow blind = step_row("pbd", 1.0 / 3000, 9e-4, 1e-5);
    blind.reference_impacts = 16;
    blind.missed_impacts = 2;
    blind.mistimed_impacts = 1;
    const Comparison c = comparison({event_row(0, 1e-5), step_row("pbd", 1.0 / 2500, 8e-4, 1e-5), blind,
                                     step_row("pbd", 1.0 / 4000, 7e-4, 3e-5), step_row("pbd", 1.0 / 5000, 6e-4, 4e-5)});
    CHECK_THAT(sentence(c, 0), Contains("the cheapest stepper within 1 mm, pbd at dt = 1/4000, costs 3 times"));
    CHECK(sentence(c, 1) ==
          "pbd: of the steps tried, dt = 1/4000 is the largest from which all smaller ones keep within a position "
          "error of 1 mm; it costs 3 times the event run; the next larger, 1/3000, misses 1 of 16 impacts (to close "
          "in, try --dt 1/3000:1/4000:lin5).");
    CHECK_THAT(
        sentence(comparison({event_row(0, 1e-5), step_row("pbd", 0.02, 8e-4, 1e-5), step_row("pbd", 0.01, 4e-4, 2e-5)}),
                 1),
        Contains("all steps tried keep within") && Contains("the largest being dt = 0.02"));
    CHECK_THAT(
        sentence(comparison({event_row(0, 1e-5), step_row("pbd", 0.02, 8e-3, 1e-5), step_row("pbd", 0.01, 4e-4, 2e-5)}),
                 1),
        Contains("only the smallest, dt = 0.01, keeps within"));
}

TEST_CASE("a run that blows up is not the best", "[verdict]")
{
    const Comparison c =
        comparison({event_row(0, 1e-5), step_row("naive", 0.1, std::numeric_limits<double>::quiet_NaN(), 1e-5),
                    step_row("naive", 0.01, 0.5, 1e-5)});
    CHECK_THAT(sentence(c, 1), Contains("best 50 cm at dt = 0.01") && Contains("at dt = 0.1 it blows up"));
}

TEST_CASE("the default tolerance is a millimetre where metres make sense", "[verdict]")
{
    Scene scene = metric_scene();
    CHECK(default_tolerance(scene) == 1e-3);
    scene.spheres[0].radius = 0.001;  // half of it is below 1 mm
    CHECK(default_tolerance(scene) == 1e-5);
    scene.spheres[0].radius = 100;
    CHECK(default_tolerance(scene) == 1);
    scene.spheres[0].radius = 0.1;
    scene.units.length = "cm";
    CHECK(default_tolerance(scene) == 1e-3);
    scene.spheres[0].radius = 0.5;
    CHECK(default_tolerance(scene) == 5e-3);
}

TEST_CASE("figures in words are short and mean what they say", "[verdict]")
{
    CHECK(two_digits(314.159) == "310");
    CHECK(two_digits(0) == "0");
    CHECK(two_digits(1.26e-7) == "1.3e-7");
    CHECK(two_digits(std::numeric_limits<double>::infinity()) == "not a finite number");
    CHECK(step_text(1.0 / 240) == "1/240");
    CHECK(step_text(0.001) == "0.001");
    CHECK(step_text(2e-4) == "2e-4");
    CHECK(step_text(1.0 / 3) == "1/3");
    CHECK(step_text(0.0048403187030680965) == "0.00484");
    CHECK(step_text(4.64158883361278e-5) == "4.642e-5");
    CHECK(step_text(0.0012345) == "0.001234");
    CHECK(step_text(0.0002154434690031884) == "2.154e-4");
    CHECK(step_text(std::nextafter(1.0 / 240, 1)) == "1/240");
    CHECK(three_digits(0.00104) == "0.00104");
    CHECK(time_text(1.04679635511, "s") == "1.0468 s");
    CHECK(time_text(2, "") == "2");
    CHECK(length_text(0.00104, "m") == "1.04 mm");
    CHECK(length_text(0.032, "m") == "3.2 cm");
    CHECK(length_text(0.001, "m") == "1 mm");
    CHECK(length_text(4e-6, "m") == "4 um");
    CHECK(length_text(3e-15, "m") == "3e-15 m");
    CHECK(length_text(0.5, "diameter") == "0.5 diameter");
    CHECK(length_text(0.5, "") == "0.5");
    CHECK(seconds_text(1.23e-5) == "12 us");
}

TEST_CASE("the median of an even number is the mean of the middle two", "[timing]")
{
    CHECK(median({3, 1, 2}) == 2);
    CHECK(median({4, 1, 2, 3}) == 2.5);
    CHECK(median({5}) == 5);
}
