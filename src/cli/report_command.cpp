#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/page_files.hpp"
#include "cli/session.hpp"
#include "core/patience.hpp"
#include "io/command_facts.hpp"
#include "report/page.hpp"
#include "report/page_data.hpp"

#include <carom/error.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <ostream>

#ifndef CAROM_VERSION
#define CAROM_VERSION "0"
#endif

namespace carom::cli {

namespace {

using Json = nlohmann::ordered_json;

/// The page data of a folder that `compare` wrote; of no use once the patience has ended.
Json folder_data(const std::filesystem::path& folder, Patience& patience)
{
    const std::filesystem::path file = folder / page_data_file;
    if (!std::filesystem::is_regular_file(file))
        throw InputError(
            {folder.string() + ": not a folder that carom compare wrote (it has no " + page_data_file + ")"});
    const std::string text = read_file(file);
    // A parse whose patience has ended leaves the rest out, and soon returns an empty document.
    const auto keep = [&](int, Json::parse_event_t, Json&) { return patience.lasts_for(1); };
    constexpr bool no_exceptions = false;
    Json data = Json::parse(text, keep, no_exceptions);
    if (!patience.ended() && !data.is_object())
        throw InputError({file.string() + ": damaged (run carom compare again)"});
    return data;
}

/// Comparisons of one scene get their folders into their titles: nobody could tell them apart otherwise.
void tell_apart(const std::vector<std::string>& folders, std::vector<Json>& comparisons)
{
    std::map<std::string, int> count;
    for (const Json& each : comparisons) ++count[each.value("title", "")];
    for (std::size_t i = 0; i < comparisons.size(); ++i) {
        const std::string title = comparisons[i].value("title", "");
        if (count[title] > 1) comparisons[i]["title"] = title + " (" + folders[i] + ")";
    }
}

/// Comparisons that `report` read, each as text again.
std::vector<std::string> read_comparisons(const std::vector<std::string>& folders, Session& session)
{
    Patience patience(session.on_progress());
    patience.begin("report", static_cast<double>(folders.size()), "folders");
    std::vector<Json> comparisons;
    for (const std::string& folder : folders) {
        patience.name(folder);
        comparisons.push_back(folder_data(folder, patience));
        if (!patience.lasts(static_cast<double>(comparisons.size()))) break;
    }
    std::vector<std::string> texts;
    if (!patience.ended()) tell_apart(folders, comparisons);
    for (const Json& each : comparisons)
        if (patience.lasts()) texts.push_back(each.dump());
    session.progress.clear();
    if (patience.ended()) throw CommandEnded(*session.watch.ended(), session.watch.reason() + ": no page was written");
    return texts;
}

}  // namespace

std::string page_generator()
{
    return std::string("carom ") + CAROM_VERSION;
}

void write_page(const std::filesystem::path& file, const std::vector<std::string>& comparisons)
{
    write_file(file, comparison_page(report::page_data(comparisons, page_generator())));
}

int do_report(const ReportArguments& args, const GlobalArguments& global, const Console& console)
{
    Session session(args.given, global, console);
    const std::vector<std::string> comparisons = read_comparisons(args.folders, session);
    std::filesystem::path file = args.out;
    if (args.out.empty())
        file = std::filesystem::path(args.folders.size() == 1 ? args.folders.front() : "out") / "report.html";
    write_page(file, comparisons);
    if (global.json) {
        Json json = {{"format", "carom-report/1"}, {"page", file.string()}};
        io::put_seconds(json, session.watch.facts());
        console.out << json.dump() << '\n';
    } else {
        console.out << file.string() << '\n';
    }
    return exit_ok;
}

}  // namespace carom::cli
