#include "cli/define.hpp"

#include <CLI/CLI.hpp>

namespace carom::cli {

void define_verify(CLI::App& app, VerifyArguments& verify)
{
    app.add_option("run", verify.run, "Folder that run -o wrote, or the recording in it")->required()->type_name("RUN");
    app.add_flag("--all-pairs", verify.all_pairs, "Examine all pairs without a grid: slow, another opinion");
    add_time_limit(app, verify.given);
    app.footer(
        "Examines every pair of bodies at every time of a recorded run, every impulse, and the energy and momentum of\n"
        "every impact, with code that shares nothing with the engine. A recording that was cut off is examined up to\n"
        "its last chunk.\n"
        "Examples:\n"
        "  carom run gas_1000 -o out/gas\n"
        "  carom verify out/gas\n"
        "  carom verify out/gas/run.carom --json\n"
        "Exit: 0 the run holds, 3 no recording or a damaged one, 4 it does not hold, 5 a limit was reached\n"
        "before its end, 130 interrupted.");
}

}  // namespace carom::cli
