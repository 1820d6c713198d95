#include "io/recording_head.hpp"

#include "io/json.hpp"
#include "scene/tolerances.hpp"

#include <carom/error.hpp>

#include <charconv>
#include <cmath>

namespace carom::io {

namespace {

template <class T>
T parse(const Meta& meta, const char* key, const std::string& file, int base = 10)
{
    const auto found = meta.find(key);
    T value{};
    if (found != meta.end()) {
        const char *begin = found->second.data(), *end = begin + found->second.size();
        std::from_chars_result result{};
        if constexpr (std::is_floating_point_v<T>)
            result = std::from_chars(begin, end, value);
        else
            result = std::from_chars(begin, end, value, base);
        if (result.ec == std::errc() && result.ptr == end) return value;
    }
    throw InputError({file + ": damaged: meta has no good " + key});
}

bool is_power_of_two(double x)
{
    int exponent = 0;
    return x > 0 && std::isfinite(x) && std::frexp(x, &exponent) == 0.5;
}

/// impact.tie of the scene in a recording; 0 if it says none.
double tie_of(const std::string& document, const std::string& file)
{
    Json scene;
    try {
        scene = parse_json(document, "scene");
    } catch (const InputError&) {
        damaged(file, "its scene is no JSON");
    }
    const Json* impact = scene.find("impact");
    const Json* tie = impact == nullptr ? nullptr : impact->find("tie");
    if (tie == nullptr) return 0;
    if (tie->kind != Json::Kind::number || !(tie->number >= 0 && tie->number <= largest_contact_gap))
        damaged(file, "a tie that cannot be");
    return tie->number;
}

BodiesRow bodies_row(const Statement& rows)
{
    BodiesRow row;
    int column = 0;
    each_bodies_value(row, [&](auto& value) { rows.get(column++, value); });
    return row;
}

class HeadReader {
public:
    explicit HeadReader(Database& database) : database_(database) {}
    RecordingHead go()
    {
        check_file();
        read_meta();
        read_head();
        return std::move(out_);
    }

private:
    void check_file()
    {
        if (database_.text_of("PRAGMA application_id") != std::to_string(recording_application_id))
            throw InputError({database_.file + ": no carom recording"});
        if (const std::string version = database_.text_of("PRAGMA user_version");
            version != std::to_string(recording_version))
            throw InputError({database_.file + ": a recording of version " + version + ", not " +
                              std::to_string(recording_version)});
        if (const std::string problem = database_.text_of("PRAGMA integrity_check"); problem != "ok")
            damaged(database_.file, "its pages do not fit together");
        Statement tables(database_, "SELECT type, name, tbl_name, sql FROM sqlite_schema ORDER BY rowid");
        std::size_t n = 0;
        for (; tables.step(); ++n) {
            const std::string sql = tables.text(3);
            if (n >= recording_tables.size() || sql != create_table(recording_tables[n]) || tables.text(0) != "table" ||
                tables.text(1) != tables.text(2) || !sql.starts_with("CREATE TABLE " + tables.text(1) + "("))
                damaged(database_.file, "not the tables of a recording");
        }
        if (n != recording_tables.size()) damaged(database_.file, "not the tables of a recording");
    }

    void read_meta()
    {
        Statement rows(database_, select_all(meta_table).c_str());
        std::size_t n = 0;
        for (; rows.step(); ++n) out_.meta[rows.text(0)] = rows.text(1);
        const std::size_t head = head_keys().size() + 1, all = head + end_keys().size() + 1;
        if (n != out_.meta.size() || (n != head && n != all)) damaged(database_.file, "rows of meta are missing");
        const auto expect = [&](const std::string& key) {
            if (!out_.meta.contains(key)) damaged(database_.file, "meta has no " + key);
        };
        for (const std::string& key : head_keys()) expect(key);
        expect("head_checksum");
        out_.finished = n == all;
        if (!out_.finished) return;
        for (const std::string& key : end_keys()) expect(key);
        expect("end_checksum");
    }

    void read_head()
    {
        const std::string& file = database_.file;
        Statement documents(database_, select_all(scene_table).c_str());
        if (!documents.step()) damaged(database_.file, "no scene");
        const auto document = documents.blob(0);
        out_.scene.assign(document.begin(), document.end());
        if (documents.step()) damaged(database_.file, "several scenes");

        Statement frames(database_, select_all(frame_table).c_str());
        if (!frames.step()) damaged(database_.file, "no frame");
        FrameRow frame;
        int column = 0;
        each_frame_value(frame, [&](auto& value) { frames.get(column++, value); });
        if (frames.step()) damaged(database_.file, "several frames");

        std::vector<BodiesRow> bodies;
        Statement rows(database_, select_all(bodies_table).c_str());
        while (rows.step()) bodies.push_back(bodies_row(rows));
        out_.checksum = head_checksum(out_.meta, Bytes(out_.scene.begin(), out_.scene.end()), frame, bodies);
        if (out_.checksum != parse<std::uint32_t>(out_.meta, "head_checksum", file))
            damaged(database_.file, "wrong checksum of the head");
        if (out_.meta["format"] != recording_format) damaged(database_.file, "unknown format");

        out_.run.frame = {frame.epoch_length, frame.cell_size, frame.drag, vectors_of(frame.accelerations, file)};
        if (!is_power_of_two(out_.run.frame.epoch_length) || !is_power_of_two(out_.run.frame.cell_size))
            damaged(database_.file, "a frame that is no power of two");
        if (!(frame.drag >= 0) || !std::isfinite(frame.drag)) damaged(database_.file, "a drag that cannot be");
        out_.run.tie = tie_of(out_.scene, file);
        out_.run.closing_speed = frame.closing_speed;
        out_.run.window = frame.window;
        if (!(frame.closing_speed >= 0) || !(frame.window >= 0)) damaged(database_.file, "thresholds that cannot be");
        const std::vector<Vec3> gravity = vectors_of(frame.gravity, file);
        if (gravity.size() != 1) damaged(database_.file, "gravity is no vector");
        out_.run.gravity = gravity.front();
        if (bodies.size() != bodies_kinds().size()) damaged(database_.file, "rows of bodies are missing");
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (bodies[i].kind != bodies_kinds()[i]) damaged(database_.file, "rows of bodies are not in their order");
            if (bodies[i].count < 0 || bodies[i].count > most_in_row(bodies[i].kind))
                damaged(database_.file, "too many " + bodies[i].kind);
            read_bodies_row(out_.run, bodies[i], file);
            bodies[i].data = {};
        }
        check_bodies(out_.run, file);
        if (out_.meta["number"] != "double" && out_.meta["number"] != "double-double")
            damaged(database_.file, "unknown numbers");
        out_.run.certified = out_.meta["number"] == "double-double";
        if (out_.finished) read_end();
    }

    void read_end()
    {
        const std::string& file = database_.file;
        RecordedEnd end;
        end.time = parse<double>(out_.meta, "time", file);
        end.event_hash = parse<std::uint64_t>(out_.meta, "event_hash", file, 16);
        end.events = parse<std::int64_t>(out_.meta, "events", file);
        end.flights = parse<std::int64_t>(out_.meta, "flights", file);
        if (!(end.time >= 0) || !std::isfinite(end.time)) damaged(database_.file, "an end that cannot be");
        out_.run.end = end;
    }

    Database& database_;
    RecordingHead out_;
};

}  // namespace

void damaged(const std::string& file, const std::string& why)
{
    throw InputError({file + ": damaged: " + why});
}

RecordingHead read_head(Database& database)
{
    return HeadReader(database).go();
}

std::string read_body_name(Database& database, const RecordedRun& run, BodyId body)
{
    const auto n = static_cast<BodyId>(run.spheres.size());
    const bool is_sphere = body < n;
    const std::string kind = is_sphere ? "sphere_ids" : "plane_ids";
    const auto index = static_cast<std::size_t>(is_sphere ? body : body - n);
    std::vector<std::string> ids;
    Statement rows(database, select_all(bodies_table).c_str());
    while (rows.step())
        if (const BodiesRow row = bodies_row(rows); row.kind == kind) ids = ids_of(row, database.file);
    if (index >= ids.size()) damaged(database.file, "an id is missing");
    return ids[index];
}

std::int64_t whole_number(const Meta& meta, const char* key, const std::string& file)
{
    return parse<std::int64_t>(meta, key, file);
}

}  // namespace carom::io
