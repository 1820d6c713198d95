#include <carom/checks.hpp>

#include "core/text.hpp"
#include "scene/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

std::string vector_text(const Vec3& v)
{
    return "[" + to_text(v[0]) + ", " + to_text(v[1]) + ", " + to_text(v[2]) + "]";
}

std::string title(const Scene& scene, const Check& check)
{
    if (check.type == "event_time") return check.type + " " + std::to_string(check.index);
    if (check.type == "event_count") return check.type + " " + check.kind;
    if (check.body != no_body) return check.type + " " + scene.body_name(check.body);
    return check.type;
}

/// Sum of m |v| [mass length/time].
double momentum_scale(const Scene& scene)
{
    double sum = 0;
    for (const Sphere& s : scene.spheres) sum += s.mass * s.velocity.norm();
    return sum;
}

std::int64_t count_of(const Counts& counts, const std::string& kind)
{
    if (kind == "rest") return counts.rests;
    if (kind == "release") return counts.releases;
    if (kind == "guard") return counts.guarded;
    if (kind == "settle") return counts.settles;
    return counts.impacts;
}

class Evaluator {
public:
    Evaluator(const Scene& scene, const CheckedRun& run) : scene_(scene), run_(run) {}

    CheckResult evaluate(const Check& check)
    {
        result_ = {};
        result_.what = title(scene_, check);
        const Outcome& outcome = run_.study.outcome;
        if (check.type == "event_time") {
            const auto index = static_cast<std::size_t>(check.index);
            if (index < run_.impact_times.size())
                compare_number(check, run_.impact_times[index]);
            else
                absent("there are only " + std::to_string(outcome.counts.impacts) + " impacts");
        } else if (check.type == "rest_time") {
            const auto& time = outcome.rest_times[static_cast<std::size_t>(check.body)];
            if (time)
                compare_number(check, *time);
            else
                absent("it did not come to rest");
        } else if (check.type == "event_count") {
            const auto count = count_of(outcome.counts, check.kind);
            judge(check, static_cast<double>(std::abs(count - check.count)), static_cast<double>(check.count));
            result_.message = "expected " + std::to_string(check.count) + ", found " + std::to_string(count);
            needs_end(count > check.count);
        } else if (check.type == "final_position" || check.type == "final_velocity") {
            final_vector(check);
        } else {
            conserved(check);
        }
        return result_;
    }

private:
    const RunStudy& study() const { return run_.study; }
    bool complete() const { return study().outcome.status == Status::reached_end; }

    void judge(const Check& check, double error, double size, double otherwise = 0)
    {
        result_.error = error;
        result_.tolerance = check.abs ? *check.abs : check.rel ? *check.rel * size : otherwise;
        result_.verdict = error <= result_.tolerance ? CheckVerdict::holds : CheckVerdict::fails;  // NaN fails
    }

    std::string why_open() const
    {
        const Outcome& outcome = study().outcome;
        return std::string("the run ended ") + name(outcome.status) + " at t = " + to_text(outcome.time, 10) +
               ", before its end";
    }

    /// A check about the whole run is open if the run ended early, unless it is already broken for good.
    void needs_end(bool broken_for_good)
    {
        if (complete() || (broken_for_good && result_.verdict == CheckVerdict::fails)) return;
        result_.verdict = CheckVerdict::open;
        result_.message = why_open();
    }

    void absent(const std::string& why)
    {
        result_.verdict = complete() ? CheckVerdict::fails : CheckVerdict::open;
        result_.message = complete() ? why : why_open();
    }

    void compare_number(const Check& check, double found)
    {
        judge(check, std::abs(found - check.time), std::abs(check.time));
        result_.message = "expected " + to_text(check.time) + ", found " + to_text(found);
    }

    void final_vector(const Check& check)
    {
        const BodyState& state = study().outcome.final[static_cast<std::size_t>(check.body)];
        const Vec3& found = check.type == "final_position" ? state.position : state.velocity;
        judge(check, (found - check.value).norm(), check.value.norm());
        result_.message = "expected " + vector_text(check.value) + ", found " + vector_text(found);
        needs_end(false);
    }

    void conserved(const Check& check)
    {
        if (check.type == "no_overlap") {
            const double radius = smallest_radius(scene_);
            judge(check, study().max_penetration, radius, declared_contact * radius);
            result_.message = "deepest overlap " + to_text(study().max_penetration, 3);
            needs_end(true);
        } else if (check.type == "energy") {
            judge(check, study().max_energy_change, study().max_kinetic_energy);
            result_.message = "changed by at most " + to_text(study().max_energy_change, 3) +
                              (conserves_energy(scene_) ? "" : " (some contacts take energy)");
            needs_end(true);
        } else if (check.type == "momentum") {
            const double change = (study().final_momentum - study().initial_momentum).norm();
            judge(check, change, momentum_scale(scene_));
            result_.message = "changed by " + to_text(change, 3);
            needs_end(false);
        } else {  // inside
            judge(check, static_cast<double>(study().escaped), 1);
            result_.message = std::to_string(study().escaped) + " outside";
            needs_end(false);
        }
    }

    const Scene& scene_;
    const CheckedRun& run_;
    CheckResult result_;
};

}  // namespace

const char* name(CheckVerdict verdict)
{
    switch (verdict) {
        case CheckVerdict::holds:
            return "holds";
        case CheckVerdict::fails:
            return "fails";
        case CheckVerdict::open:
            return "open";
    }
    return "?";
}

bool CheckReport::all_hold() const
{
    return std::all_of(results.begin(), results.end(),
                       [](const CheckResult& r) { return r.verdict == CheckVerdict::holds; });
}

bool CheckReport::any_fails() const
{
    return std::any_of(results.begin(), results.end(),
                       [](const CheckResult& r) { return r.verdict == CheckVerdict::fails; });
}

std::vector<CheckResult> evaluate_checks(const Scene& scene, const CheckedRun& run)
{
    Evaluator evaluator(scene, run);
    std::vector<CheckResult> results;
    for (const Check& check : scene.checks) results.push_back(evaluator.evaluate(check));
    return results;
}

CheckReport check_scene(const Scene& scene, const std::function<bool(double)>& on_progress)
{
    std::size_t wanted = 0;
    for (const Check& check : scene.checks)
        if (check.type == "event_time") wanted = std::max(wanted, static_cast<std::size_t>(check.index) + 1);
    CheckReport report;
    RunStudyOptions options;
    options.on_progress = on_progress;
    if (wanted > 0)
        options.on_event = [&](const Event& event) {
            if (event.kind == EventKind::impact && report.run.impact_times.size() < wanted)
                report.run.impact_times.push_back(event.time);
        };
    report.run.study = run_study(scene, EventDriven{}, options);
    report.results = evaluate_checks(scene, report.run);
    return report;
}

}  // namespace carom
