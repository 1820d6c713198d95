#include <carom/io.hpp>

#include "io/recording_bodies.hpp"

#include <charconv>
#include <cmath>
#include <new>

namespace carom {

namespace io {

namespace {

/// A process that was killed while it wrote a chunk leaves a journal: opening the file for writing takes that chunk
/// back.
void recover(const std::filesystem::path& file)
{
    std::error_code none;
    if (std::filesystem::file_size(file.string() + "-journal", none) == 0 || none) return;
    Database(file, Access::recover).text_of("SELECT count(*) FROM sqlite_schema");
}

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

}  // namespace

}  // namespace io

using namespace io;

class RecordingReader::Implementation {
public:
    explicit Implementation(const std::filesystem::path& file) : database_((recover(file), file), Access::read)
    {
        read_safely([&] {
            check_file();
            read_meta();
            read_head();
            chunks_.emplace(database_,
                            "SELECT seq, kind, count, first_epoch, first_offset, last_epoch, last_offset, "
                            "lowest_body, highest_body, checksum, data FROM chunks ORDER BY seq");
        });
    }

    bool next(Instant& instant)
    {
        while (flight_ == flights_.size()) {
            bool more = false;
            read_safely([&] { more = read_pair(); });
            if (!more) return false;
        }
        // The flights of one instant began at one time, after the same event.
        const std::size_t first = flight_;
        do {
            ++flight_;
        } while (flight_ < flights_.size() && after_[flight_] == after_[first] &&
                 flights_[flight_].start == flights_[first].start);
        const std::int64_t until = after_[first] - events_before_;
        if (until < static_cast<std::int64_t>(event_) || until > static_cast<std::int64_t>(events_.size()))
            damaged("flights and events do not fit together");
        const auto last = static_cast<std::size_t>(until);
        instant.events = std::span(events_).subspan(event_, last - event_);
        instant.flights = std::span(flights_).subspan(first, flight_ - first);
        event_ = last;
        return true;
    }

    std::string body_name(BodyId body)
    {
        const auto n = static_cast<BodyId>(run.spheres.size());
        const bool is_sphere = body < n;
        const std::string kind = is_sphere ? "sphere_ids" : "plane_ids";
        const auto index = static_cast<std::size_t>(is_sphere ? body : body - n);
        std::vector<std::string> ids;
        read_safely([&] {
            Statement rows(database_, "SELECT kind, count, data FROM bodies ORDER BY rowid");
            while (rows.step())
                if (const BodiesRow row = bodies_row(rows); row.kind == kind) ids = ids_of(row, database_.file);
        });
        if (index >= ids.size()) damaged("an id is missing");
        return ids[index];
    }

    RecordedRun run;
    Meta meta;
    std::string scene;

private:
    [[noreturn]] void damaged(const std::string& why) const
    {
        throw InputError({database_.file + ": damaged: " + why});
    }

    /// A length that makes no sense may ask for more memory than there is.
    template <class Read>
    void read_safely(const Read& read)
    {
        try {
            read();
        } catch (const std::bad_alloc&) {
            damaged("sizes beyond all memory");
        } catch (const std::length_error&) {
            damaged("sizes beyond all memory");
        }
    }

    void check_file()
    {
        if (database_.text_of("PRAGMA application_id") != std::to_string(recording_application_id))
            throw InputError({database_.file + ": no carom recording"});
        if (const std::string version = database_.text_of("PRAGMA user_version");
            version != std::to_string(recording_version))
            throw InputError({database_.file + ": a recording of version " + version + ", not " +
                              std::to_string(recording_version)});
        if (const std::string problem = database_.text_of("PRAGMA integrity_check"); problem != "ok")
            damaged("its pages do not fit together");
        Statement tables(database_, "SELECT type, name, tbl_name, sql FROM sqlite_schema ORDER BY rowid");
        std::size_t n = 0;
        for (; tables.step(); ++n) {
            const std::string sql = tables.text(3);
            if (n >= recording_tables().size() || sql != recording_tables()[n] || tables.text(0) != "table" ||
                tables.text(1) != tables.text(2) || !sql.starts_with("CREATE TABLE " + tables.text(1) + "("))
                damaged("not the tables of a recording");
        }
        if (n != recording_tables().size()) damaged("not the tables of a recording");
    }

    void read_meta()
    {
        Statement rows(database_, "SELECT key, value FROM meta ORDER BY rowid");
        std::size_t n = 0;
        for (; rows.step(); ++n) meta[rows.text(0)] = rows.text(1);
        const std::size_t head = head_keys().size() + 1, all = head + end_keys().size() + 1;
        if (n != meta.size() || (n != head && n != all)) damaged("rows of meta are missing");
        const auto expect = [&](const std::string& key) {
            if (!meta.contains(key)) damaged("meta has no " + key);
        };
        for (const std::string& key : head_keys()) expect(key);
        expect("head_checksum");
        finished_ = n == all;
        if (!finished_) return;
        for (const std::string& key : end_keys()) expect(key);
        expect("end_checksum");
    }

    static BodiesRow bodies_row(const Statement& row)
    {
        const auto data = row.blob(2);
        return {row.text(0), row.integer(1), Bytes(data.begin(), data.end())};
    }

    void read_head()
    {
        const std::string& file = database_.file;
        Statement documents(database_, "SELECT document FROM scene");
        if (!documents.step()) damaged("no scene");
        const auto document = documents.blob(0);
        scene.assign(document.begin(), document.end());
        if (documents.step()) damaged("several scenes");

        Statement frames(database_, "SELECT epoch_length, cell_size, gravity, accelerations FROM frame");
        if (!frames.step()) damaged("no frame");
        FrameRow frame{frames.real(0), frames.real(1), {}, {}};
        frame.gravity.assign(frames.blob(2).begin(), frames.blob(2).end());
        frame.accelerations.assign(frames.blob(3).begin(), frames.blob(3).end());
        if (frames.step()) damaged("several frames");

        std::vector<BodiesRow> bodies;
        Statement rows(database_, "SELECT kind, count, data FROM bodies ORDER BY rowid");
        while (rows.step()) bodies.push_back(bodies_row(rows));
        checksum_ = head_checksum(meta, Bytes(scene.begin(), scene.end()), frame, bodies);
        if (checksum_ != parse<std::uint32_t>(meta, "head_checksum", file)) damaged("wrong checksum of the head");
        if (meta["format"] != recording_format) damaged("unknown format");

        run.frame = {frame.epoch_length, frame.cell_size, vectors_of(frame.accelerations, file)};
        if (!is_power_of_two(run.frame.epoch_length) || !is_power_of_two(run.frame.cell_size))
            damaged("a frame that is no power of two");
        const std::vector<Vec3> gravity = vectors_of(frame.gravity, file);
        if (gravity.size() != 1) damaged("gravity is no vector");
        run.gravity = gravity.front();
        if (bodies.size() != bodies_kinds().size()) damaged("rows of bodies are missing");
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (bodies[i].kind != bodies_kinds()[i]) damaged("rows of bodies are not in their order");
            if (bodies[i].count < 0 || bodies[i].count > most_in_row(bodies[i].kind))
                damaged("too many " + bodies[i].kind);
            read_bodies_row(run, bodies[i], file);
            bodies[i].data = {};
        }
        check_bodies(run, file);
        if (meta["number"] != "double" && meta["number"] != "double-double") damaged("unknown numbers");
        run.certified = meta["number"] == "double-double";
        if (finished_) read_end();
    }

    void read_end()
    {
        const std::string& file = database_.file;
        RecordedEnd end;
        end.time = parse<double>(meta, "time", file);
        end.event_hash = parse<std::uint64_t>(meta, "event_hash", file, 16);
        end.events = parse<std::int64_t>(meta, "events", file);
        end.flights = parse<std::int64_t>(meta, "flights", file);
        if (!(end.time >= 0) || !std::isfinite(end.time)) damaged("an end that cannot be");
        run.end = end;
    }

    /// The next chunk of events and the chunk of flights that belongs to it.
    bool read_pair()
    {
        if (done_) return false;
        if (event_ != events_.size()) damaged("events without flights");
        events_before_ += static_cast<std::int64_t>(events_.size());
        event_ = flight_ = 0;
        if (!chunks_->step()) {
            check_end();
            return false;
        }
        read_chunk("events", event_columns_);
        events_.clear();
        for (std::size_t i = 0; i < event_columns_.rows(); ++i) events_.push_back(event_columns_.row(i));
        if (!chunks_->step()) damaged("a chunk is missing");
        read_chunk("flights", flight_columns_);
        flights_.clear();
        for (std::size_t i = 0; i < flight_columns_.rows(); ++i) flights_.push_back(flight_columns_.row(i));
        after_ = flight_columns_.after;
        flights_before_ += static_cast<std::int64_t>(flights_.size());
        return true;
    }

    template <class Columns>
    void read_chunk(const char* kind, Columns& columns)
    {
        ChunkRow row;
        row.seq = chunks_->integer(0);
        row.kind = chunks_->text(1);
        row.count = chunks_->integer(2);
        row.first = {chunks_->integer(3), chunks_->real(4)};
        row.last = {chunks_->integer(5), chunks_->real(6)};
        row.lowest_body = chunks_->integer(7);
        row.highest_body = chunks_->integer(8);
        const auto data = chunks_->blob(10);
        checksum_ = chunk_checksum(row, data, checksum_);
        const std::string where = "chunk " + std::to_string(row.seq);
        if (chunks_->integer(9) != static_cast<std::int64_t>(checksum_)) damaged("wrong checksum of " + where);
        if (row.seq != next_chunk_++ || row.kind != kind) damaged(where + " is out of place");
        if (row.count < 0 || row.count > most_chunk_rows) damaged(where + " is too large");
        unpack(columns, data, static_cast<std::size_t>(row.count), database_.file);
    }

    void check_end()
    {
        done_ = true;
        flights_.clear();
        flight_ = 0;
        if (!finished_) return;
        const std::string& file = database_.file;
        if (end_checksum(meta, checksum_) != parse<std::uint32_t>(meta, "end_checksum", file))
            damaged("wrong checksum of the end");
        if (parse<std::int64_t>(meta, "chunks", file) != next_chunk_ || run.end->events != events_before_ ||
            run.end->flights != flights_before_)
            damaged("chunks are missing");
    }

    Database database_;
    std::optional<Statement> chunks_;
    bool finished_ = false, done_ = false;
    std::uint32_t checksum_ = 0;
    std::int64_t next_chunk_ = 0, events_before_ = 0, flights_before_ = 0;
    EventColumns event_columns_;
    FlightColumns flight_columns_;
    std::vector<Event> events_;
    std::vector<FlightRecord> flights_;
    std::vector<std::int64_t> after_;
    std::size_t event_ = 0, flight_ = 0;  ///< next to be given out
};

RecordingReader::RecordingReader(const std::filesystem::path& file)
{
    if (!std::filesystem::is_regular_file(file)) throw InputError({file.string() + ": no such file"});
    implementation_ = std::make_unique<Implementation>(file);
}

RecordingReader::~RecordingReader() = default;

const RecordedRun& RecordingReader::run() const
{
    return implementation_->run;
}

bool RecordingReader::next(Instant& instant)
{
    return implementation_->next(instant);
}

void RecordingReader::forget_starts()
{
    implementation_->run.starts = {};
}

const std::map<std::string, std::string>& RecordingReader::meta() const
{
    return implementation_->meta;
}

const std::string& RecordingReader::scene() const
{
    return implementation_->scene;
}

std::string RecordingReader::body_name(BodyId body) const
{
    return implementation_->body_name(body);
}

std::filesystem::path find_recording(const std::filesystem::path& what)
{
    if (std::filesystem::is_regular_file(what)) return what;
    const std::filesystem::path inside = what / recording_name;
    if (std::filesystem::is_regular_file(inside)) return inside;
    throw InputError({what.string() + ": no recording there (make one with carom run SCENE -o DIR)"});
}

}  // namespace carom
