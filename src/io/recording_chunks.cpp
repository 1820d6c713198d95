#include "io/recording_chunks.hpp"

#include "io/recording_columns.hpp"

namespace carom::io {

ChunkReader::ChunkReader(Database& database, const RecordingHead& head)
    : file_(database.file),
      head_(head),
      chunks_(database, select_all(chunks_table, "seq").c_str()),
      checksum_(head.checksum)
{
}

bool ChunkReader::next(Instant& instant)
{
    while (flight_ == flights_.size())
        if (!read_pair()) return false;
    // The flights of one instant began at one time, after the same event.
    const std::size_t first = flight_;
    do {
        ++flight_;
    } while (flight_ < flights_.size() && after_[flight_] == after_[first] &&
             flights_[flight_].start == flights_[first].start);
    const std::int64_t until = after_[first] - events_before_;
    if (until < static_cast<std::int64_t>(event_) || until > static_cast<std::int64_t>(events_.size()))
        damaged(file_, "flights and events do not fit together");
    const auto last = static_cast<std::size_t>(until);
    instant.events = std::span(events_).subspan(event_, last - event_);
    instant.flights = std::span(flights_).subspan(first, flight_ - first);
    event_ = last;
    return true;
}

/// The next chunk of events and the chunk of flights that belongs to it.
bool ChunkReader::read_pair()
{
    if (done_) return false;
    if (event_ != events_.size()) damaged(file_, "events without flights");
    events_before_ += static_cast<std::int64_t>(events_.size());
    event_ = flight_ = 0;
    if (!chunks_.step()) {
        check_end();
        return false;
    }
    const Chunk events = read_chunk("events");
    events_ = unpacked_events(events.data, events.count, file_);
    if (!chunks_.step()) damaged(file_, "a chunk is missing");
    const Chunk flights = read_chunk("flights");
    flights_.clear();
    after_.clear();
    for (FlightRow& row : unpacked_flights(flights.data, flights.count, file_)) {
        flights_.push_back(std::move(row.flight));
        after_.push_back(row.after);
    }
    flights_before_ += static_cast<std::int64_t>(flights_.size());
    return true;
}

ChunkReader::Chunk ChunkReader::read_chunk(const char* kind)
{
    ChunkRow row;
    int column = 0;
    each_chunk_value(row, [&](auto& value) { chunks_.get(column++, value); });
    const std::int64_t checksum = chunks_.integer(column++);
    const auto data = chunks_.blob(column);
    checksum_ = chunk_checksum(row, data, checksum_);
    const std::string where = "chunk " + std::to_string(row.seq);
    if (checksum != static_cast<std::int64_t>(checksum_)) damaged(file_, "wrong checksum of " + where);
    if (row.seq != next_chunk_++ || row.kind != kind) damaged(file_, where + " is out of place");
    if (row.count < 0 || row.count > most_chunk_rows) damaged(file_, where + " is too large");
    return {data, static_cast<std::size_t>(row.count)};
}

void ChunkReader::check_end()
{
    done_ = true;
    flights_.clear();
    flight_ = 0;
    if (!head_.finished) return;
    if (end_checksum(head_.meta, checksum_) !=
        static_cast<std::uint64_t>(whole_number(head_.meta, "end_checksum", file_)))
        damaged(file_, "wrong checksum of the end");
    if (whole_number(head_.meta, "chunks", file_) != next_chunk_ || head_.run.end->events != events_before_ ||
        head_.run.end->flights != flights_before_)
        damaged(file_, "chunks are missing");
}

}  // namespace carom::io
