#include <carom/io.hpp>

#include "io/limits.hpp"
#include "io/numbers.hpp"
#include "io/recording_bodies.hpp"
#include "io/recording_columns.hpp"
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
        const FrameRow row{frame.epoch_length,
                           frame.cell_size,
                           frame.drag,
                           bytes_of(std::span(&scene_.gravity, 1)),
                           bytes_of(frame.accelerations),
                           rest.closing_speed,
                           window};
        const std::vector<BodiesRow> bodies = bodies_rows(scene_);
        checksum_ = head_checksum(meta_, document, row, bodies);

        database_.execute("BEGIN");
        for (const RecordingTable& table : recording_tables) database_.execute(create_table(table).c_str());
        insert_meta(head_keys());
        insert_meta("head_checksum", std::to_string(checksum_));
        Statement(database_, insert_into(scene_table).c_str()).bind(0, document).step();
        Statement insert_frame(database_, insert_into(frame_table).c_str());
        int parameter = 0;
        each_frame_value(row, [&](const auto& value) { insert_frame.bind(parameter++, value); });
        insert_frame.step();
        for (const BodiesRow& each : bodies) {
            Statement insert(database_, insert_into(bodies_table).c_str());
            parameter = 0;
            each_bodies_value(each, [&](const auto& value) { insert.bind(parameter++, value); });
            insert.step();
        }
        database_.execute("COMMIT");
        insert_chunk_.emplace(database_, insert_into(chunks_table).c_str());
        last_write_ = Clock::now();
    }

    void add(const Event& event)
    {
        // A chunk ends where an instant does: its events are never parted from its flights.
        if (flight_was_last_ && is_time_to_write()) write();
        flight_was_last_ = false;
        events_.push_back(event);
        ++event_count_;
    }

    void add(const FlightRecord& flight)
    {
        if (event_count_ == 0 && flights_.size() >= chunk_rows) write();  // of the start there may be millions
        flight_was_last_ = true;
        flights_.push_back({flight, event_count_});
        ++flight_count_;
    }

    void finish(const Outcome& outcome)
    {
        if (!insert_chunk_) begin({});
        if (events_.size() + flights_.size() > 0) write();
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
        if (flights_.size() + events_.size() >= chunk_rows) return true;
        if (++looked_ % clock_look_every != 0) return false;
        return Clock::now() - last_write_ >= chunk_time;
    }

    void insert_meta(const std::string& key, const std::string& value)
    {
        Statement(database_, insert_into(meta_table).c_str()).bind(0, key).bind(1, value).step();
    }
    void insert_meta(const std::vector<std::string>& keys)
    {
        for (const std::string& key : keys) insert_meta(key, meta_[key]);
    }

    /// Always a pair, events and flights, though one may be empty: what stands in the file is whole instants.
    void write()
    {
        database_.execute("BEGIN");
        insert("events", events_);
        insert("flights", flights_);
        database_.execute("COMMIT");
        events_.clear();
        flights_.clear();
        last_write_ = Clock::now();
    }

    static BodyId body_of(const Event& event) { return event.a; }
    static BodyId body_of(const FlightRow& row) { return row.flight.body; }
    static EpochTime time_of(const Event& event) { return event.at; }
    static EpochTime time_of(const FlightRow& row) { return row.flight.start; }

    template <class Record>
    void insert(const char* kind, const std::vector<Record>& records)
    {
        ChunkRow row;
        row.seq = next_chunk_++;
        row.kind = kind;
        row.count = static_cast<std::int64_t>(records.size());
        if (!records.empty()) {
            row.first = time_of(records.front());
            row.last = time_of(records.back());
            row.lowest_body = row.highest_body = body_of(records.front());
        }
        for (const Record& record : records) {
            row.lowest_body = std::min<std::int64_t>(row.lowest_body, body_of(record));
            row.highest_body = std::max<std::int64_t>(row.highest_body, body_of(record));
        }
        const Bytes data = packed(std::span(records));
        checksum_ = chunk_checksum(row, data, checksum_);
        int parameter = 0;
        each_chunk_value(row, [&](const auto& value) { insert_chunk_->bind(parameter++, value); });
        insert_chunk_->bind(parameter, static_cast<std::int64_t>(checksum_)).bind(parameter + 1, data);
        insert_chunk_->step();
        insert_chunk_->reset();
    }

    const Scene& scene_;
    Database database_;
    Meta meta_;
    std::optional<Statement> insert_chunk_;
    std::uint32_t checksum_ = 0;
    std::vector<Event> events_;
    std::vector<FlightRow> flights_;
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
