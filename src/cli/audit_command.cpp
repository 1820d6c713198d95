#include "audit/audit_trace.hpp"
#include "audit/frames_at_steps.hpp"
#include "cli/choices.hpp"
#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/session.hpp"
#include "cli/tables.hpp"
#include "io/audit_files.hpp"
#include "io/trace_reader.hpp"

#include <carom/error.hpp>
#include <carom/io.hpp>

#include <fmt/format.h>

#include <ostream>

namespace carom::cli {

namespace {

audit::TraceAudit audited(const AuditArguments& args, const Scene& scene, Session& session)
{
    try {
        io::TraceReader trace(args.trace, scene, session.on_progress());
        const CommandDefaults none;
        const Choices choices(args.given, none, "");
        const double step = choices.has("step") ? choices.number("step", 0) : 0;
        audit::FramesAtSteps at_steps(trace, step);
        audit::FrameSource& frames = choices.has("step") ? static_cast<audit::FrameSource&>(at_steps) : trace;
        audit::TraceAudit result = audit::audit_trace(scene, frames, session.on_progress());
        session.progress.clear();
        return result;
    } catch (const Stopped&) {
        session.progress.clear();
        throw CommandEnded(*session.watch.ended(),
                           fmt::format("{}: {}, while it was read", args.trace, session.watch.reason()));
    }
}

std::string why_nothing(const audit::TraceAudit& audit)
{
    if (audit.frames < 2) return "fewer than two frames fall on steps (give the step that the engine took)";
    if (audit.bodies.straight > audit.bodies.without_flight)
        return "spheres move on straight lines between kinks (if frames are denser than the engine's steps, say its "
               "step: "
               "--step H)";
    return "no sphere is in flight for three frames (take more frames per unit of time)";
}

}  // namespace

int do_audit(const AuditArguments& args, const GlobalArguments& global, const Console& console)
{
    Session session(args.given, global, console);
    const std::filesystem::path file = find_scene(args.scene, scene_folder());
    const Scene scene = session.read(file, args.allow_overlap, args.set);
    const audit::TraceAudit audit = audited(args, scene, session);
    const io::CommandFacts facts = session.watch.facts();
    const std::string json = io::audit_json(scene, args.trace, audit, facts);
    if (!args.out.empty()) {
        const std::filesystem::path folder = args.out;
        for (const audit::Finding& finding : audit.findings)
            write_file(folder / io::finding_file(finding), io::finding_scene_json(scene, finding));
        write_file(folder / "audit.json", json);
    }
    console.out << (global.json ? json : audit_table(scene, audit));
    if (!args.out.empty() && !global.json)
        console.out << (std::filesystem::path(args.out) / "audit.json").string() << '\n';
    if (facts.stopped && !global.quiet) print_error(console, session.watch.reason());
    if (facts.stopped == Status::interrupted) return exit_interrupted;
    if (audit.found_wrong() > 0) return exit_check_failed;
    if (facts.stopped) return exit_limit;
    if (audit.frames >= 2 && audit.says_something()) return exit_ok;
    print_error(console, args.trace + ": nothing could be decided: " + why_nothing(audit));
    return exit_check_failed;
}

}  // namespace carom::cli
