#include "cli/cli.hpp"

#include "cli/exit_codes.hpp"
#include "io/output_file.hpp"

#include <carom/error.hpp>
#include <carom/io.hpp>

#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <ostream>

#ifndef CAROM_SCENE_DIR
#define CAROM_SCENE_DIR "scenes"
#endif

namespace carom::cli {

namespace {

int dispatch(const Arguments& arguments, const Console& console)
{
    switch (arguments.command) {
        case Command::run:
            return do_run(arguments.run, arguments.global, console);
        case Command::compare:
            return do_compare(arguments.compare, arguments.global, console);
        case Command::check:
            return do_check(arguments.check, arguments.global, console);
        case Command::explain:
            return do_explain(arguments.explain, arguments.global, console);
        case Command::stress:
            return do_stress(arguments.stress, arguments.global, console);
        case Command::tunnel:
            return do_tunnel(arguments.tunnel, arguments.global, console);
        case Command::verify:
            return do_verify(arguments.verify, arguments.global, console);
        case Command::audit:
            return do_audit(arguments.audit, arguments.global, console);
        case Command::report:
            return do_report(arguments.report, arguments.global, console);
        case Command::scenes:
            return do_scenes(arguments.scenes, arguments.global, console);
        case Command::toi:
            return do_toi(console);
    }
    return exit_usage;
}

bool wants_color()
{
    const char* no_color = std::getenv("NO_COLOR");
    return isatty(STDERR_FILENO) != 0 && (no_color == nullptr || *no_color == '\0');
}

}  // namespace

std::filesystem::path scene_folder()
{
    const char* folder = std::getenv("CAROM_SCENES");
    return folder != nullptr && *folder != '\0' ? folder : CAROM_SCENE_DIR;
}

Scene read_with_options(const std::filesystem::path& file, bool allow_overlap, const std::vector<std::string>& set,
                        const GlobalArguments& global, const OnProgress& on_progress)
{
    ReadOptions options;
    options.on_progress = on_progress;
    options.allow_overlap = allow_overlap;
    options.seed = global.seed;
    options.set = set;
    return read_scene(file, options);
}

int run_cli(const std::vector<std::string>& args, const Console& console)
{
    const ParseResult parsed = parse_arguments(args);
    if (!parsed.arguments) {
        console.out << parsed.out;
        console.err << parsed.err;
        return parsed.exit_code;
    }
    try {
        return dispatch(*parsed.arguments, console);
    } catch (const UsageError& error) {
        print_error(console, error.what());
        return exit_usage;
    } catch (const InputError& error) {
        for (const std::string& problem : error.problems()) print_error(console, problem);
        return exit_bad_input;
    } catch (const CommandEnded& ended) {
        print_error(console, ended.what());
        return exit_code(ended.why());
    } catch (const std::bad_alloc&) {
        print_error(console,
                    "out of memory (take fewer spheres, in compare fewer methods and steps; ulimit -v says whether the "
                    "process is limited)");
        return exit_failed;
    } catch (const std::exception& error) {
        print_error(console, std::string("failed: ") + error.what());
        return exit_failed;
    }
}

int run_cli(int argc, char** argv)
{
    io::DescriptorBuffer buffer(STDOUT_FILENO);
    std::ostream out(&buffer);
    if (isatty(STDOUT_FILENO) != 0) out.setf(std::ios::unitbuf);  // people read along
    const Console console{out, std::cerr, isatty(STDERR_FILENO) != 0, wants_color()};
    const std::vector<std::string> args(argv + (argc > 0 ? 1 : 0), argv + argc);
    const int code = run_cli(args, console);
    out.flush();
    if (out) return code;
    print_error(console, "stdout: cannot be written: " + buffer.failure());
    return exit_failed;
}

}  // namespace carom::cli
