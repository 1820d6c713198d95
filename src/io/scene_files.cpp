#include <algorithm>
#include <array>
#include <carom/io.hpp>
#include <fstream>
#include <system_error>

#include "core/text.hpp"
#include "io/json.hpp"
#include "io/limits.hpp"
#include "io/problems.hpp"

namespace carom {

namespace fs = std::filesystem;

namespace {

std::string read_text(const fs::path& file)
{
    std::error_code error;
    const std::string name = file.string();
    if (fs::is_directory(file, error)) throw InputError({name + ": is a directory (name a scene file in it)"});
    if (!fs::exists(file, error)) throw InputError({name + ": no such file"});
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw InputError({name + ": cannot be opened (check its permissions)"});
    std::string text;
    std::array<char, io::read_at_once> chunk;
    while (stream.read(chunk.data(), chunk.size()) || stream.gcount() > 0) {
        text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
        if (text.size() > io::most_scene_bytes)
            throw InputError({name + ": is larger than 1 GiB (use \"fill\" for many spheres)"});
    }
    if (stream.bad()) throw InputError({name + ": cannot be read"});
    return text;
}

bool is_scene_file(const fs::path& path)
{
    const std::string name = path.filename().string();
    return path.extension() == ".json" && !name.ends_with(".schema.json");
}

std::string string_member(const io::Json& json, std::string_view key)
{
    const io::Json* member = json.find(key);
    return member && member->kind == io::Json::Kind::string ? member->text : "";
}

}  // namespace

Scene read_scene(const fs::path& file, const ReadOptions& options)
{
    return parse_scene(read_text(file), file.string(), options);
}

std::vector<fs::path> scene_files(const fs::path& root)
{
    std::vector<fs::path> files;
    std::error_code error;
    const auto skip = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator it(root, skip, error), end; !error && it != end; it.increment(error))
        if (is_scene_file(it->path())) files.push_back(it->path());
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<CatalogueEntry> list_scenes(const fs::path& root)
{
    std::vector<CatalogueEntry> entries;
    for (const fs::path& file : scene_files(root)) {
        try {
            const io::Json json = io::parse_json(read_text(file), file.string());
            entries.push_back(
                {file.stem().string(), file, string_member(json, "name"), string_member(json, "description")});
        } catch (const InputError&) {
            continue;  // unreadable ones are no part of the catalogue; reading one by name says why
        }
    }
    std::sort(entries.begin(), entries.end(), [](const CatalogueEntry& a, const CatalogueEntry& b) {
        return a.name != b.name ? a.name < b.name : a.path < b.path;
    });
    return entries;
}

fs::path find_scene(const std::string& what, const fs::path& root)
{
    std::error_code error;
    if (fs::exists(what, error) && !fs::is_directory(what, error)) return what;
    for (const fs::path& file : scene_files(root))
        if (file.stem() == what) return file;
    std::vector<std::string> names;
    for (const auto& entry : list_scenes(root)) names.push_back(entry.name);
    if (fs::is_directory(what, error)) throw InputError({what + ": is a directory (name a scene file in it)"});
    if (fs::exists(what + ".json", error))
        throw InputError({what + ": no such file and no scene of the catalogue (did you mean \"" + what + ".json\"?)"});
    throw InputError(
        {what + ": no such file and no scene of the catalogue" + io::suggestion(what, names, "there are")});
}

}  // namespace carom
