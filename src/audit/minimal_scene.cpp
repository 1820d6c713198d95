#include "audit/minimal_scene.hpp"

#include "audit/tolerances.hpp"
#include "core/text.hpp"

#include <algorithm>

namespace carom::audit {

namespace {

std::string words(const Scene& scene, const Finding& finding)
{
    const std::string a = scene.body_name(finding.a), at = " at t = " + to_text(finding.time);
    const std::string begun = " of the trace; this scene begins with its frame t = " + to_text(finding.begin) + ".";
    const std::string b = finding.b == no_body ? "" : scene.body_name(finding.b);
    switch (finding.kind) {
        case FindingKind::missed:
            return a + " and " + b + " touch" + at + begun + " There they fly on as if they had not.";
        case FindingKind::late:
            return a + " and " + b + " touch" + at + begun + " There they answer " +
                   (finding.at_least ? "at least " : "") + to_text(finding.by) + " later.";
        case FindingKind::early:
            return a + " and " + b + " touch" + at + begun + " There they answer " + to_text(finding.by) + " earlier.";
        case FindingKind::invented:
            return a + " touches nothing" + at + begun + " There its velocity changes.";
        case FindingKind::overlap:
            return a + " and " + b + " overlap by " + to_text(finding.depth) + ", from t = " + to_text(finding.time) +
                   " on" + begun;
    }
    return "";
}

/// Index in the minimal scene of a body of the whole one.
BodyId body_in(const Scene& scene, const Finding& finding, BodyId body)
{
    if (body >= static_cast<BodyId>(scene.spheres.size())) return static_cast<BodyId>(finding.bodies.size());
    const auto found = std::find_if(finding.bodies.begin(), finding.bodies.end(),
                                    [&](const Begin& each) { return each.body == body; });
    return static_cast<BodyId>(found - finding.bodies.begin());
}

Check no_contact()
{
    Check check;
    check.type = CheckType::event_count;
    check.kind = EventKind::impact;
    check.count = 0;
    return check;
}

Check touches_in_time(const Scene& scene, const Finding& finding)
{
    Check check;
    check.type = CheckType::event_time;
    check.between = {body_in(scene, finding, finding.a), body_in(scene, finding, finding.b)};
    check.time = finding.time - finding.begin;
    // Beside the errors of the frames there is the rounding of the two times.
    check.abs = finding.time_error + spacing_roundings * double_rounding * std::abs(finding.time);
    return check;
}

}  // namespace

Scene minimal_scene(const Scene& scene, const Finding& finding)
{
    Scene small;
    small.name = std::string(finding_kind_names[static_cast<std::size_t>(finding.kind)]) + " " +
                 std::to_string(finding.number) + (scene.name.empty() ? "" : " of " + scene.name);
    small.description = words(scene, finding);
    small.units = scene.units;
    small.gravity = scene.gravity;
    small.drag = scene.drag;
    small.origin = scene.origin;
    small.end_time = finding.span > 0 ? finding.span : scene.end_time;
    small.seed = scene.seed;
    small.materials = scene.materials;
    small.contacts = scene.contacts;
    small.rest = scene.rest;
    small.impact = scene.impact;
    small.guard = scene.guard;
    for (const Begin& begin : finding.bodies) {
        Sphere sphere = scene.spheres[static_cast<std::size_t>(begin.body)];
        sphere.position = begin.place;
        sphere.velocity = begin.velocity;
        small.spheres.push_back(sphere);
    }
    const auto n = static_cast<BodyId>(scene.spheres.size());
    if (finding.kind == FindingKind::invented)
        small.planes = scene.planes;
    else if (finding.b >= n)
        small.planes.push_back(scene.planes[static_cast<std::size_t>(finding.b - n)]);
    if (finding.kind == FindingKind::invented)
        small.checks.push_back(no_contact());
    else if (finding.kind != FindingKind::overlap)
        small.checks.push_back(touches_in_time(scene, finding));
    return small;
}

}  // namespace carom::audit
