#include "io/recording_chunks.hpp"

namespace carom::io {

ChunkReader::ChunkReader(Database& database, const RecordingHead& head)
    : file_(database.file),
      head_(head),
      chunks_(database,
              "SELECT seq, kind, count, first_epoch, first_offset, last_epoch, last_offset, lowest_body, highest_body, "
              "checksum, data FROM chunks ORDER BY seq"),
      checksum_(head.checksum)
{
}

bool ChunkReader::next(Instant& instant)
{
    while (flight_ == flights_.size())
        if (!read_pair()) return false;
    // The flights of one instant began at one time, after the same event.
    const std::vector<std::int64_t>& after = flight_columns_.after;
    const std::size_t first = flight_;
    do {
        ++flight_;
    } while (flight_ < flights_.size() && after[flight_] == after[first] &&
             flights_[flight_].start == flights_[first].start);
    const std::int64_t until = after[first] - events_before_;
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
    read_chunk("events", event_columns_);
    events_.clear();
    for (std::size_t i = 0; i < event_columns_.rows(); ++i) events_.push_back(event_columns_.row(i));
    if (!chunks_.step()) damaged(file_, "a chunk is missing");
    read_chunk("flights", flight_columns_);
    flights_.clear();
    for (std::size_t i = 0; i < flight_columns_.rows(); ++i) flights_.push_back(flight_columns_.row(i));
    flights_before_ += static_cast<std::int64_t>(flights_.size());
    return true;
}

template <class Columns>
void ChunkReader::read_chunk(const char* kind, Columns& columns)
{
    ChunkRow row;
    row.seq = chunks_.integer(0);
    row.kind = chunks_.text(1);
    row.count = chunks_.integer(2);
    row.first = {chunks_.integer(3), chunks_.real(4)};
    row.last = {chunks_.integer(5), chunks_.real(6)};
    row.lowest_body = chunks_.integer(7);
    row.highest_body = chunks_.integer(8);
    const auto data = chunks_.blob(10);
    checksum_ = chunk_checksum(row, data, checksum_);
    const std::string where = "chunk " + std::to_string(row.seq);
    if (chunks_.integer(9) != static_cast<std::int64_t>(checksum_)) damaged(file_, "wrong checksum of " + where);
    if (row.seq != next_chunk_++ || row.kind != kind) damaged(file_, where + " is out of place");
    if (row.count < 0 || row.count > most_chunk_rows) damaged(file_, where + " is too large");
    unpack(columns, data, static_cast<std::size_t>(row.count), file_);
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
