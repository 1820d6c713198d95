#include <carom/io.hpp>

#include "io/limits.hpp"
#include "io/numbers.hpp"
#include "io/recording_bodies.hpp"
#include "io/scene_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace carom {

namespace io {

namespace {

void make_folder_and_remove_old(const std::filesystem::path& file)
{
    std::error_code ignored;  // opening tells
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
    for (const char* suffix : {"", "-journal", "-wal", "-shm"})
        std::filesystem::remove(file.string() + suffix, ignored);
}

/// Pages are small, so that little is unused in a short recording. The file is to survive the death of the process,
/// which needs no waiting for the disk.
constexpr const char* settings = "PRAGMA page_size = 1024; PRAGMA journal_mode = DELETE; PRAGMA synchronous = OFF;";

}  // namespace

}  // namespace io

using namespace io;

class RecordingWriter::Implementation {
public:
    Implementation(const std::filesystem::path& file, const Scene& scene, const RecordingOptions& options)
        : scene_(scene), database_((make_folder_and_remove_old(file), file), Access::create)
    {
        database_.execute(settings);
        database_.execute(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {};", recording_application_id,
                                      recording_version)
                              .c_str());
        meta_ = {{"format", recording_format},
                 {"scene", scene.name},
                 {"method", options.method},
                 {"number", options.certified ? "double-double" : "double"},
                 {"until", number_text(options.until)}};
    }

    void begin(const RunFrame& frame)
    {
        const Bytes document = bytes_of_text(scene_json_without_spheres(scene_));
        const RestThresholds rest = rest_thresholds(scene_);
        const double least = std::numeric_limits<double>::min();  // 0 means policy micro
        const double window = scene_.rest.policy == RestPolicy::micro ? 0 : std::max(least, rest.window);
        const FrameRow row{
            frame.epoch_length, frame.cell_size, bytes_of(std::span(&scene_.gravity, 1)), bytes_of(frame.accelerations),
            rest.closing_speed, window};
        const std::vector<BodiesRow> bodies = bodies_rows(scene_);
        checksum_ = head_checksum(meta_, document, row, bodies);

        database_.execute("BEGIN");
        for (const std::string& table : recording_tables()) database_.execute(table.c_str());
        insert_meta(head_keys());
        insert_meta("head_checksum", std::to_string(checksum_));
        Statement(database_, "INSERT INTO scene VALUES (?)").bind(0, document).step();
        Statement(database_, "INSERT INTO frame VALUES (?, ?, ?, ?, ?, ?)")
            .bind(0, row.epoch_length)
            .bind(1, row.cell_size)
            .bind(2, row.gravity)
            .bind(3, row.accelerations)
            .bind(4, row.closing_speed)
            .bind(5, row.window)
            .step();
        for (const BodiesRow& each : bodies)
            Statement(database_, "INSERT INTO bodies VALUES (?, ?, ?)")
                .bind(0, each.kind)
                .bind(1, each.count)
                .bind(2, each.data)
                .step();
        database_.execute("COMMIT");
        insert_chunk_.emplace(database_, "INSERT INTO chunks VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
        last_write_ = Clock::now();
    }

    void add(const Event& event)
    {
        // A chunk ends where an instant does: its events are never parted from its flights.
        if (flight_was_last_ && is_time_to_write()) write();
        flight_was_last_ = false;
        events_.add(event);
        ++event_count_;
    }

    void add(const FlightRecord& flight)
    {
        if (event_count_ == 0 && flights_.rows() >= chunk_rows) write();  // of the start there may be millions
        flight_was_last_ = true;
        flights_.add(flight, event_count_);
        ++flight_count_;
    }

    void finish(const Outcome& outcome)
    {
        if (!insert_chunk_) begin({});
        if (events_.rows() + flights_.rows() > 0) write();
        meta_["status"] = name(outcome.status);
        meta_["message"] = outcome.message;
        meta_["time"] = number_text(outcome.time);
        meta_["event_hash"] = fmt::format("{:016x}", outcome.event_hash);
        meta_["events"] = std::to_string(event_count_);
        meta_["flights"] = std::to_string(flight_count_);
        meta_["chunks"] = std::to_string(next_chunk_);
        database_.execute("BEGIN");
        insert_meta(end_keys());
        insert_meta("end_checksum", std::to_string(end_checksum(meta_, checksum_)));
        database_.execute("COMMIT");
    }

private:
    using Clock = std::chrono::steady_clock;

    static Bytes bytes_of_text(const std::string& text) { return {text.begin(), text.end()}; }

    bool is_time_to_write()
    {
        if (flights_.rows() + events_.rows() >= chunk_rows) return true;
        if (++looked_ % clock_look_every != 0) return false;
        return Clock::now() - last_write_ >= chunk_time;
    }

    void insert_meta(const std::string& key, const std::string& value)
    {
        Statement(database_, "INSERT INTO meta VALUES (?, ?)").bind(0, key).bind(1, value).step();
    }
    void insert_meta(const std::vector<std::string>& keys)
    {
        for (const std::string& key : keys) insert_meta(key, meta_[key]);
    }

    /// Always a pair, events and flights, though one may be empty: what stands in the file is whole instants.
    void write()
    {
        database_.execute("BEGIN");
        insert("events", events_, events_.a);
        insert("flights", flights_, flights_.body);
        database_.execute("COMMIT");
        events_.clear();
        flights_.clear();
        last_write_ = Clock::now();
    }

    template <class Columns>
    void insert(const char* kind, const Columns& columns, const std::vector<BodyId>& bodies)
    {
        ChunkRow row;
        row.seq = next_chunk_++;
        row.kind = kind;
        row.count = static_cast<std::int64_t>(columns.rows());
        if (row.count > 0) {
            row.first = {columns.epoch.front(), columns.offset.front()};
            row.last = {columns.epoch.back(), columns.offset.back()};
            row.lowest_body = *std::min_element(bodies.begin(), bodies.end());
            row.highest_body = *std::max_element(bodies.begin(), bodies.end());
        }
        const Bytes data = packed(columns);
        checksum_ = chunk_checksum(row, data, checksum_);
        insert_chunk_->bind(0, row.seq).bind(1, row.kind).bind(2, row.count);
        insert_chunk_->bind(3, row.first.epoch).bind(4, row.first.offset);
        insert_chunk_->bind(5, row.last.epoch).bind(6, row.last.offset);
        insert_chunk_->bind(7, row.lowest_body).bind(8, row.highest_body);
        insert_chunk_->bind(9, static_cast<std::int64_t>(checksum_)).bind(10, data);
        insert_chunk_->step();
        insert_chunk_->reset();
    }

    const Scene& scene_;
    Database database_;
    Meta meta_;
    std::optional<Statement> insert_chunk_;
    std::uint32_t checksum_ = 0;
    EventColumns events_;
    FlightColumns flights_;
    std::int64_t event_count_ = 0, flight_count_ = 0, next_chunk_ = 0;
    bool flight_was_last_ = false;
    std::int64_t looked_ = 0;
    Clock::time_point last_write_;
};

RecordingWriter::RecordingWriter(const std::filesystem::path& file, const Scene& scene, const RecordingOptions& options)
    : implementation_(std::make_unique<Implementation>(file, scene, options))
{
}

RecordingWriter::~RecordingWriter() = default;

void RecordingWriter::on_frame(const RunFrame& frame)
{
    implementation_->begin(frame);
}

void RecordingWriter::on_event(const Event& event)
{
    implementation_->add(event);
}

void RecordingWriter::on_flight(const FlightRecord& flight)
{
    implementation_->add(flight);
}

void RecordingWriter::finish(const Outcome& outcome)
{
    implementation_->finish(outcome);
}

}  // namespace carom
