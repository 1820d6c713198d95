#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/page_files.hpp"
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

/// The page data of a folder that `compare` wrote.
std::string folder_data(const std::filesystem::path& folder)
{
    const std::filesystem::path file = folder / page_data_file;
    if (!std::filesystem::is_regular_file(file))
        throw InputError(
            {folder.string() + ": not a folder that carom compare wrote (it has no " + page_data_file + ")"});
    std::string data = read_file(file);
    if (!nlohmann::json::accept(data)) throw InputError({file.string() + ": damaged (run carom compare again)"});
    return data;
}

}  // namespace

namespace {

/// Comparisons of one scene get their folders into their titles: nobody could tell them apart otherwise.
void tell_apart(const std::vector<std::string>& folders, std::vector<std::string>& comparisons)
{
    std::vector<nlohmann::ordered_json> parsed;
    std::map<std::string, int> count;
    for (const std::string& each : comparisons) {
        parsed.push_back(nlohmann::ordered_json::parse(each));
        ++count[parsed.back().value("title", "")];
    }
    for (std::size_t i = 0; i < parsed.size(); ++i) {
        const std::string title = parsed[i].value("title", "");
        if (count[title] < 2) continue;
        parsed[i]["title"] = title + " (" + folders[i] + ")";
        comparisons[i] = parsed[i].dump();
    }
}

}  // namespace

void write_page(const std::filesystem::path& file, const std::vector<std::string>& comparisons)
{
    write_file(file, comparison_page(report::page_data(comparisons, std::string("carom ") + CAROM_VERSION)));
}

int do_report(const ReportArguments& args, const GlobalArguments& global, const Console& console)
{
    std::vector<std::string> comparisons;
    for (const std::string& folder : args.folders) comparisons.push_back(folder_data(folder));
    tell_apart(args.folders, comparisons);
    std::filesystem::path file = args.out;
    if (args.out.empty())
        file = std::filesystem::path(args.folders.size() == 1 ? args.folders.front() : "out") / "report.html";
    write_page(file, comparisons);
    if (global.json)
        console.out << nlohmann::ordered_json({{"format", "carom-report/1"}, {"page", file.string()}}).dump() << '\n';
    else
        console.out << file.string() << '\n';
    return exit_ok;
}

}  // namespace carom::cli
