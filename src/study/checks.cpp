#include <carom/checks.hpp>

#include "core/names.hpp"
#include "core/text.hpp"
#include "scene/tolerances.hpp"
#include "study/mirror_image.hpp"

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
    const std::string type(name_of(check.type, check_type_names));
    if (check.type == CheckType::event_time) {
        std::string of;
        if (check.between)
            of = " of " + scene.body_name((*check.between)[0]) + " and " + scene.body_name((*check.between)[1]);
        return type + " " + std::to_string(check.index) + of;
    }
    if (check.type == CheckType::event_count) return type + " " + name(check.kind);
    if (check.type == CheckType::position)
        return type + " " + scene.body_name(check.body) + " at " + to_text(check.time, 10);
    if (check.body != no_body) return type + " " + scene.body_name(check.body);
    return type;
}

/// Sum of m |v| [mass length/time].
double momentum_scale(const Scene& scene)
{
    double sum = 0;
    for (const Sphere& s : scene.spheres) sum += s.mass * s.velocity.norm();
    return sum;
}

std::int64_t count_of(const Counts& counts, EventKind kind)
{
    switch (kind) {
        case EventKind::rest:
            return counts.rests;
        case EventKind::release:
            return counts.releases;
        case EventKind::guard:
            return counts.guarded;
        case EventKind::settle:
            return counts.settles;
        case EventKind::impact:
            break;
    }
    return counts.impacts;
}

class Evaluator {
public:
    Evaluator(const Scene& scene, const CheckedRun& run) : scene_(scene), run_(run) {}

    /// \param sight what check had looked at
    CheckResult evaluate(const Check& check, const CheckSight& sight)
    {
        result_ = {};
        result_.what = title(scene_, check);
        const Outcome& outcome = study().outcome;
        switch (check.type) {
            case CheckType::no_overlap:
                no_overlap(check);
                break;
            case CheckType::energy:
                energy(check, study().max_energy_change);
                needs_end(true);
                break;
            case CheckType::final_energy:
                energy(check, std::abs(energy_difference(scene_, outcome.final, initial_states(scene_))));
                needs_end(false);
                break;
            case CheckType::momentum:
                momentum(check);
                break;
            case CheckType::inside:
                judge(check, static_cast<double>(study().escaped), 1);
                result_.message = std::to_string(study().escaped) + " outside";
                needs_end(false);
                break;
            case CheckType::event_time:
                time(check, sight.time,
                     check.between ? "there is no such impact"
                                   : "there are only " + std::to_string(outcome.counts.impacts) + " impacts");
                break;
            case CheckType::event_count:
                event_count(check);
                break;
            case CheckType::rest_time:
                time(check,
                     outcome.rest_times.empty() ? std::nullopt
                                                : outcome.rest_times[static_cast<std::size_t>(check.body)],
                     "it did not come to rest");
                break;
            case CheckType::position:
                if (sight.position)
                    vector(check, *sight.position);
                else
                    absent("the run is over before that time");
                break;
            case CheckType::final_position:
                vector(check, outcome.final[static_cast<std::size_t>(check.body)].position);
                needs_end(false);
                break;
            case CheckType::final_velocity:
                vector(check, outcome.final[static_cast<std::size_t>(check.body)].velocity);
                needs_end(false);
                break;
            case CheckType::moved:
            case CheckType::moved_origin:
            case CheckType::later:
            case CheckType::reversed:
                repeat(check, sight.repeat);
                break;
            case CheckType::mirrored:
                judge(check, scene_.spheres.empty() ? 0 : study::mirror_difference(scene_, outcome.final, check.value),
                      1);
                result_.message = "its image is off by " + to_text(*result_.error, 3);
                needs_end(false);
                break;
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

    void time(const Check& check, const std::optional<double>& found, const std::string& why_not)
    {
        if (!found) return absent(why_not);
        judge(check, std::abs(*found - check.time), std::abs(check.time));
        result_.message = "expected " + to_text(check.time) + ", found " + to_text(*found);
    }

    void event_count(const Check& check)
    {
        const auto count = count_of(study().outcome.counts, check.kind);
        judge(check, static_cast<double>(std::abs(count - check.count)), static_cast<double>(check.count));
        result_.message = "expected " + std::to_string(check.count) + ", found " + std::to_string(count);
        needs_end(count > check.count);
    }

    void vector(const Check& check, const Vec3& found)
    {
        judge(check, (found - check.value).stableNorm(), check.value.stableNorm());
        result_.message = "expected " + vector_text(check.value) + ", found " + vector_text(found);
    }

    void no_overlap(const Check& check)
    {
        const double radius = smallest_radius(scene_);
        judge(check, study().max_penetration, radius, declared_contact * radius);
        result_.message = "deepest overlap " + to_text(study().max_penetration, 3);
        needs_end(true);
    }

    void energy(const Check& check, double change)
    {
        judge(check, change, study().max_kinetic_energy);
        const char* why = scene_.drag > 0 ? " (drag takes energy)" : " (some contacts take energy)";
        result_.message = "changed by " + to_text(change, 3) + (conserves_energy(scene_) ? "" : why);
    }

    void momentum(const Check& check)
    {
        const double change = (study().final_momentum - study().initial_momentum).norm();
        judge(check, change, momentum_scale(scene_));
        result_.message = "changed by " + to_text(change, 3);
        needs_end(false);
    }

    void repeat(const Check& check, const std::optional<Repeat>& repeat)
    {
        if (!repeat) return absent("the run was not repeated");
        judge(check, repeat->difference, 1);
        const Outcome& second = repeat->outcome;
        if (second.status != Status::reached_end)
            result_.message = std::string("the repeated run ended ") + name(second.status) + ": " + second.message;
        else
            result_.message = repeat->other_events ? "other events" : "off by " + to_text(repeat->difference, 3);
    }

    const Scene& scene_;
    const CheckedRun& run_;
    CheckResult result_;
};

}  // namespace

const char* name(CheckVerdict verdict)
{
    return name_of(verdict, check_verdict_names).data();
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
    for (std::size_t k = 0; k < scene.checks.size(); ++k)
        results.push_back(evaluator.evaluate(scene.checks[k], k < run.sights.size() ? run.sights[k] : CheckSight{}));
    return results;
}

}  // namespace carom
