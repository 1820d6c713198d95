#include "cli/define.hpp"

#include <CLI/CLI.hpp>

namespace carom::cli {

void define_audit(CLI::App& app, AuditArguments& audit)
{
    app.add_option("trace", audit.trace, "Table t,id,x,y,z: the place of every sphere that moves, frame by frame")
        ->required()
        ->type_name("TRACE.csv");
    app.add_option("--scene", audit.scene, "Scene file, or a name of the catalogue, whose frames these are")
        ->required()
        ->type_name("SCENE");
    add_given(app, audit.given, "--step", "H",
              "Step of the engine: frames that fall on no step are left out [each frame is judged]");
    add_scene_options(app, audit.allow_overlap, audit.set);
    app.add_option("-o,--out", audit.out, "Write DIR/audit.json, and for each finding the smallest scene that shows it")
        ->type_name("DIR");
    add_time_limit(app, audit.given);
    app.footer(
        "Judges each interval between two frames by itself: the parabolas through the frames before it are flown on\n"
        "exactly, and what touches must answer. docs/audit.md has the rules.\n"
        "  missed    two bodies touch and fly on, or a centre changes the side of a plate\n"
        "  late      they answer, but later than they touch; early: before\n"
        "  invented  a velocity or a place changes as no contact changes it\n"
        "  overlap   frames show bodies inside each other\n"
        "What has several contacts in an interval, or frames too coarse, is undecided and counted.\n"
        "Examples:\n"
        "  carom run gas_1000 --method pbd --dt 1/240 --frames 240 -o out/pbd\n"
        "  carom audit out/pbd/frames.csv --scene gas_1000\n"
        "  carom audit bullet.csv --scene bullet -o out/audit --json\n"
        "Exit: 0 nothing wrong was found, 4 findings, or nothing could be decided, 3 bad scene or trace, 2 usage,\n"
        "5 a limit was reached, 130 interrupted.");
}

}  // namespace carom::cli
