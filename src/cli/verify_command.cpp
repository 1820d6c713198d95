#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/session.hpp"
#include "cli/tables.hpp"
#include "io/verify_json.hpp"
#include "study/words.hpp"

#include <carom/io.hpp>
#include <carom/verify.hpp>

#include <fmt/format.h>

#include <ostream>

namespace carom::cli {

namespace {

std::string share(double part, double whole)
{
    return fmt::format("{:.6g} ({:.4g} %)", part, whole > 0 ? 100 * part / whole : 0);
}

std::string certificate_text(const Certificate& c)
{
    if (!c.holds()) return fmt::format("DOES NOT HOLD: {} violations", c.violated);
    return c.stopped ? "none: nothing wrong was found before the examination stopped" : "holds";
}

std::string recording_text(const Certificate& c)
{
    const char* const how = c.stopped ? "examined to" : c.complete ? "complete, to" : "cut off at";
    return fmt::format("{} t = {:.10g}", how, c.until);
}

std::string verify_table(const Certificate& c, double drag, const io::CommandFacts& command)
{
    const CertifiedSeconds& s = c.body_seconds;
    const double all = s.exact + s.bounded + s.in_contact + s.numeric + s.guarded + s.not_certified;
    std::vector<std::vector<std::string>> rows{
        {"certificate", certificate_text(c)},
        {"recording", recording_text(c)},
        {"bodies", fmt::format("{} spheres, {} planes", c.spheres, c.planes)},
        {"read", fmt::format("{} flights, {} events, hash {:016x}", c.flights, c.events, c.event_hash)},
        {"pairs", fmt::format("{}, examined in {} segments", c.pairs, c.segments)},
        {"arithmetic",
         fmt::format("{} segments needed double-double, {} exact", c.needed_double_double, c.needed_exact)},
        {"smallest gap", fmt::format("{:.3g} at t = {:.10g}", c.smallest_gap, c.smallest_gap_time)},
        {"impulses", fmt::format("{}, at gaps of at most {:.2g}", c.impulses, c.largest_impact_gap)},
        {"largest errors",
         fmt::format("impulse {:.2g}, law {:.2g}, momentum {:.2g}, energy {:.2g}, place {:.2g} of its bound",
                     c.largest_impulse_error, c.largest_law_error, c.largest_momentum_error, c.largest_energy_error,
                     c.largest_jump)},
        {"body-seconds >= 0", share(s.exact, all)},
        {"body-seconds >= -b", share(s.bounded, all)},
        {"in contact", share(s.in_contact, all)},
        {"numeric", share(s.numeric, all)},
        {"guarded", share(s.guarded, all)},
        {"not certified", share(s.not_certified, all)}};
    if (drag > 0) rows.insert(rows.begin() + 3, {"drag", fmt::format("{:.10g}", drag)});
    if (c.clusters > 0) rows.push_back({"clusters", fmt::format("{} impacts of several contacts at once", c.clusters)});
    if (c.rests_on_spheres + c.releases_of_spheres > 0)
        rows.push_back(
            {"sphere on sphere", fmt::format("{} rests, {} releases", c.rests_on_spheres, c.releases_of_spheres)});
    if (c.largest_absorbed > 0)
        rows.push_back({"absorbed", fmt::format("at most {:.2g} of speed where contacts persist", c.largest_absorbed)});
    if (s.numeric > 0)
        rows.push_back(
            {"numeric pieces", fmt::format("overlap at most {:.2g}, at their ends {:.2g} of place, {:.2g} of "
                                           "speed",
                                           c.numeric_depth, c.largest_numeric_jump, c.largest_numeric_kick)});
    if (c.settles > 0)
        rows.push_back({"settled", fmt::format("{} contacts that opened slowly, by impulses", c.settles)});
    if (c.guards > 0)
        rows.push_back({"guard", fmt::format("{} windows, overlap at most {:.2g}", c.guards, c.guarded_depth)});
    rows.push_back({"clock", fmt::format("{} (CPU {})", study::seconds_text(command.seconds),
                                         study::seconds_text(command.cpu_seconds))});
    return aligned(rows, 2);
}

}  // namespace

int do_verify(const VerifyArguments& args, const GlobalArguments& global, const Console& console)
{
    Session session(args.given, global, console);
    RecordingReader recording(find_recording(args.run));
    VerifyOptions options;
    options.all_pairs = args.all_pairs;
    options.on_progress = session.on_progress();
    const Certificate certificate = verify(recording, options);
    session.progress.clear();
    const io::CommandFacts facts = session.watch.facts();
    console.out << (global.json ? io::verify_json(certificate, recording, facts)
                                : verify_table(certificate, recording.run().frame.drag, facts));
    if (facts.stopped && !global.quiet) print_error(console, session.watch.reason());
    if (!global.quiet)
        for (const Violation& v : certificate.violations)
            print_error(console, fmt::format("{}, at t = {:.17g}", v.what, v.time));
    if (facts.stopped == Status::interrupted) return exit_interrupted;
    if (!certificate.holds()) return exit_check_failed;
    return facts.stopped ? exit_limit : exit_ok;
}

}  // namespace carom::cli
