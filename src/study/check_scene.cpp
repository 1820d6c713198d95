#include <carom/checks.hpp>

#include "study/repeat_run.hpp"

#include <algorithm>
#include <utility>

namespace carom {

namespace {

bool is_between(const Event& event, const std::array<BodyId, 2>& pair)
{
    return std::minmax(event.a, event.b) == std::minmax(pair[0], pair[1]);
}

/// Fills in the sights while a run goes on.
class Lookout {
public:
    Lookout(const Scene& scene, std::vector<CheckSight>& sights) : scene_(scene), sights_(sights)
    {
        sights_.resize(scene.checks.size());
        before_.resize(scene.checks.size(), 0);
    }

    std::vector<double> times() const
    {
        std::vector<double> times;
        for (const Check& check : scene_.checks)
            if (check.type == CheckType::position && check.time <= scene_.end_time) times.push_back(check.time);
        std::sort(times.begin(), times.end());
        return times;
    }

    bool looks_at_events() const
    {
        return std::any_of(scene_.checks.begin(), scene_.checks.end(),
                           [](const Check& check) { return check.type == CheckType::event_time; });
    }

    void see(const Event& event)
    {
        if (event.kind != EventKind::impact) return;
        for (std::size_t k = 0; k < sights_.size(); ++k) {
            const Check& check = scene_.checks[k];
            if (check.type != CheckType::event_time || sights_[k].time) continue;
            if (check.between && !is_between(event, *check.between)) continue;
            if (before_[k]++ == check.index) sights_[k].time = event.time;
        }
    }

    void see(double time, std::span<const BodyState> states)
    {
        for (std::size_t k = 0; k < sights_.size(); ++k)
            if (const Check& check = scene_.checks[k]; check.type == CheckType::position && check.time == time)
                sights_[k].position = states[static_cast<std::size_t>(check.body)].position;
    }

private:
    const Scene& scene_;
    std::vector<CheckSight>& sights_;
    std::vector<std::int64_t> before_;  ///< impacts seen that an event_time counts
};

}  // namespace

CheckReport check_scene(const Scene& scene, const CheckOptions& options)
{
    CheckReport report;
    Lookout lookout(scene, report.run.sights);
    RunStudyOptions run;
    run.run.max_seconds = options.max_seconds;
    run.on_progress = options.on_progress;
    run.more_times = lookout.times();
    if (!run.more_times.empty())
        run.on_state = [&](double time, std::span<const BodyState> states) { lookout.see(time, states); };
    if (lookout.looks_at_events()) run.on_event = [&](const Event& event) { lookout.see(event); };
    report.run.study = run_study(scene, options.method, run);
    Outcome& outcome = report.run.study.outcome;
    for (std::size_t k = 0; k < scene.checks.size() && outcome.status == Status::reached_end; ++k) {
        if (!study::asks_for_repeat(scene.checks[k].type)) continue;
        const Repeat& repeat =
            report.run.sights[k].repeat.emplace(study::repeat_run(scene, scene.checks[k], outcome, options));
        if (repeat.outcome.status == Status::interrupted) outcome.status = Status::interrupted;
    }
    report.results = evaluate_checks(scene, report.run);
    return report;
}

}  // namespace carom
