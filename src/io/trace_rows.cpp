#include "io/trace_rows.hpp"

#include "core/text.hpp"
#include "io/limits.hpp"
#include "io/problems.hpp"

#include <carom/error.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace carom::io {

namespace {

constexpr std::array<std::string_view, 5> column_names{"t", "id", "x", "y", "z"};
enum Column : std::size_t { time_column, id_column, first_place_column };

std::string_view trimmed(std::string_view text)
{
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    return text;
}

}  // namespace

void split_fields(std::string_view line, std::vector<std::string>& fields)
{
    std::size_t count = 0;
    const auto field = [&]() -> std::string& {
        if (count == fields.size()) fields.emplace_back();
        return fields[count++];
    };
    for (std::size_t at = 0; at <= line.size();) {
        std::string& text = field();
        text.clear();
        const std::size_t start = line.find_first_not_of(" \t", at);
        if (start != std::string_view::npos && line[start] == '"') {
            for (at = start + 1; at < line.size(); ++at) {
                if (line[at] == '"' && (at + 1 >= line.size() || line[at + 1] != '"')) break;
                if (line[at] == '"') ++at;
                text += line[at];
            }
            at = std::min(line.find(',', at), line.size());
        } else {
            const std::size_t end = std::min(line.find(',', at), line.size());
            text = trimmed(line.substr(at, end - at));
            at = end;
        }
        ++at;
    }
    fields.resize(count);
}

TraceRows::TraceRows(const std::filesystem::path& file, const Scene& scene)
    : scene_(scene), file_(file.string()), seen_at_(scene.spheres.size())
{
    // It is read twice, and a device might never end.
    if (std::error_code ignored; !std::filesystem::is_regular_file(file, ignored))
        throw InputError({file_ + ": no such file (give the path of a table t,id,x,y,z)"});
    stream_.open(file);
    if (!stream_) throw InputError({file_ + ": cannot be read"});
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) spheres_.emplace(scene.spheres[i].id, i);
    read_header();
}

void TraceRows::fail(std::size_t line, const std::string& what) const
{
    throw InputError({file_ + ":" + std::to_string(line) + ": " + what});
}

bool TraceRows::read_line()
{
    do {
        if (!std::getline(stream_, line_)) return false;
        ++line_number_;
        bytes_ += line_.size() + 1;
    } while (trimmed(line_).empty() || trimmed(line_).front() == '#');
    return true;
}

void TraceRows::read_header()
{
    if (!read_line()) fail(1, "an empty trace (a head line t,id,x,y,z and the rows of frames are wanted)");
    split_fields(line_, fields_);
    for (std::size_t c = 0; c < column_names.size(); ++c) {
        const auto found = std::find(fields_.begin(), fields_.end(), column_names[c]);
        if (found == fields_.end())
            fail(line_number_, "no column " + quoted(std::string(column_names[c])) +
                                   " (the first line names the columns: t,id,x,y,z)");
        column_[c] = static_cast<std::size_t>(found - fields_.begin());
    }
    columns_ = fields_.size();
}

double TraceRows::number(std::size_t column, audit::Rounding& rounding)
{
    const std::string& text = fields_[column_[column]];
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    double value = 0;
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        fail(line_number_, std::string(column_names[column]) + ": " + quoted(text.substr(0, longest_quoted)) +
                               " is no finite number");
    rounding.see({begin, end});
    return value;
}

std::size_t TraceRows::sphere_of(const std::string& id) const
{
    if (const auto found = spheres_.find(id); found != spheres_.end()) return found->second;
    for (const Plane& plane : scene_.planes)
        if (plane.id == id) fail(line_number_, quoted(id) + " is a plane of the scene (leave it out)");
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < std::min(scene_.spheres.size(), most_candidates); ++i)
        ids.push_back(scene_.spheres[i].id);
    fail(line_number_,
         "no sphere " + quoted(id.substr(0, longest_quoted)) + " in the scene" + suggestion(id, ids, "spheres"));
}

bool TraceRows::read_row()
{
    if (!read_line()) return false;
    split_fields(line_, fields_);
    if (fields_.size() != columns_)
        fail(line_number_,
             std::to_string(fields_.size()) + " fields, but the head line has " + std::to_string(columns_));
    row_.line = line_number_;
    row_.time = number(time_column, times_);
    row_.sphere = sphere_of(fields_[column_[id_column]]);
    for (std::size_t axis = 0; axis < 3; ++axis)
        row_.place[static_cast<int>(axis)] = number(first_place_column + axis, places_);
    return true;
}

void TraceRows::enter(audit::Frame& frame)
{
    std::size_t& seen = seen_at_[row_.sphere];
    const std::string id = quoted(scene_.spheres[row_.sphere].id);
    if (seen != 0)
        fail(row_.line, "sphere " + id + " twice in the frame t = " + to_text(row_.time) + ", here and in line " +
                            std::to_string(seen));
    seen = row_.line;
    frame.places[row_.sphere] = row_.place;
}

void TraceRows::check_complete(const audit::Frame& frame) const
{
    std::size_t missing = 0, first = 0;
    for (std::size_t i = scene_.spheres.size(); i-- > 0;)
        if (seen_at_[i] == 0 && !scene_.spheres[i].fixed) {
            ++missing;
            first = i;
        }
    if (missing == 0) return;
    fail(frame_line_, "the frame t = " + to_text(frame.time) + " has no sphere " + quoted(scene_.spheres[first].id) +
                          (missing > 1 ? " and lacks " + std::to_string(missing - 1) + " more" : "") +
                          " (each frame needs every sphere that can move)");
}

bool TraceRows::next(audit::Frame& frame)
{
    if (!has_row_ && !(has_row_ = read_row())) return false;
    frame.time = row_.time;
    frame.places.clear();
    for (const Sphere& sphere : scene_.spheres) frame.places.push_back(sphere.position);
    frame_line_ = row_.line;
    std::fill(seen_at_.begin(), seen_at_.end(), std::size_t{0});
    do {
        enter(frame);
        has_row_ = read_row();
    } while (has_row_ && row_.time == frame.time);
    check_complete(frame);
    if (has_row_ && row_.time < frame.time)
        fail(row_.line, "t = " + to_text(row_.time) + " after t = " + to_text(frame.time) +
                            " (frames must come in the order of time)");
    return true;
}

}  // namespace carom::io
