#include "cli/define.hpp"

#include <CLI/CLI.hpp>

namespace carom::cli {

void define_tunnel(CLI::App& app, TunnelArguments& tunnel)
{
    app.add_option(
           "scene", tunnel.scene,
           "Scene whose fastest body is thrown at what it meets first [a matrix of plates, fixed spheres, walls]")
        ->type_name("SCENE");
    const auto add = [&](const char* flag, const char* value, const char* help) {
        add_given(app, tunnel.given, flag, value, help);
    };
    add("--speed", "LIST",
        "Speeds: a,b,c or start:stop:logN or start:stop:linN [1,3.16,10,31.6,100,316,1000,3160,10000]");
    add("--thickness", "LIST", "Thicknesses of plates, diameters of fixed spheres [0.002,0.02,0.2]");
    add("--radius", "LIST", "Radii of the ball [0.01,0.1]");
    add("--dt", "LIST", "Steps [1/60,1/240,1/1000]");
    add("--target", "LIST", "plate, sphere, wall (a plane with one side, as those of a box) [all]");
    add("--methods", "LIST",
        "Methods, collision libraries (fcl_naive, fcl_advancement, libccd_advancement), and engines of others when "
        "asked for: bullet, bullet_ccd, bullet_defaults, ode, ode_defaults [methods and libraries]");
    add("--trials", "N", "Throws of each method at each cell [1000]");
    app.add_flag_callback(
        "--bisect", [&tunnel] { tunnel.given["bisect"] = "true"; },
        "Find the critical speed of each method at plates and spheres, or of a scene, within 1 %");
    add("--offset", "LIST", "Offsets of spheres with --bisect, in the sum of the radii, below 1 [0,0.5,0.9]");
    add_time_limit(app, tunnel.given);
    add_scene_options(app, tunnel.allow_overlap, tunnel.set);
    app.add_option("-o,--out", tunnel.out,
                   "Write tunnel.csv, tunnel.json, report.html, with --bisect critical.csv, and for each method that "
                   "tunnels a scene that shows it, throws/METHOD.json")
        ->type_name("DIR");
    app.footer(
        "A throw begins a random part of a step before the contact. It tunnelled if the method answers within two "
        "steps\n"
        "nothing, or the ball is behind the plate at last; it is wrong if it is answered late or with another "
        "velocity.\n"
        "Examples:\n"
        "  carom tunnel                                      the whole matrix, half a minute\n"
        "  carom tunnel --bisect -o out/tunnel               critical speeds beside the law, and a page\n"
        "  carom tunnel --target plate --speed 1:1e3:log4 --thickness 0.02 --radius 0.1 --dt 1/60 --methods event,pbd\n"
        "  carom tunnel bullet --methods velocity,toi        the bullet of a scene at other speeds\n"
        "  carom tunnel bullet --bisect -o out/bullet        from which speed on it is missed, and throws that show "
        "it\n"
        "Exit: 0 event hit every time, 4 it did not, 2 usage, 3 bad scene, 5 a limit was reached, 130 interrupted.");
}

}  // namespace carom::cli
