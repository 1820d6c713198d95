#include "fuzz/mutate_recording.hpp"

#include "io/recording_columns.hpp"

#include <carom/error.hpp>

#include <algorithm>
#include <array>
#include <cstring>

namespace carom::fuzz {

using namespace io;

namespace {

std::int64_t odd_integer(Random& random, std::int64_t near)
{
    static constexpr std::array<std::int64_t, 8> odd{0, 1, -1, 2, 1 << 14, INT32_MAX, INT64_MAX, INT64_MIN};
    if (random.below(2) == 0) return odd[random.below(odd.size())];
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(near) + random.below(9) - 4);
}

/// Also what is not finite: nothing but the reader stands between it and the examination.
void change(double& x, Random& random)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    switch (random.below(16)) {
        case 0:
            x = infinity;
            break;
        case 1:
            x = std::numeric_limits<double>::quiet_NaN();
            break;
        default:
            x = odd_number(random, x);
    }
}

template <class Integer>
void change_integer(Integer& i, Random& random)
{
    i = static_cast<Integer>(odd_integer(random, static_cast<std::int64_t>(i)));
}

void change_bytes(Bytes& bytes, Random& random)
{
    constexpr std::size_t growth = 16;
    const std::size_t size = bytes.size();
    if (size >= sizeof(double) && random.below(2) == 0) {  // a double in the middle
        const std::size_t at = random.below(size / sizeof(double)) * sizeof(double);
        double x = 0;
        std::memcpy(&x, bytes.data() + at, sizeof x);
        change(x, random);
        std::memcpy(bytes.data() + at, &x, sizeof x);
        return;
    }
    bytes.resize(size + growth);
    bytes.resize(LLVMFuzzerMutate(bytes.data(), size, bytes.size()));
}

void change(EpochTime& time, Random& random)
{
    if (random.below(2) == 0)
        change_integer(time.epoch, random);
    else
        change(time.offset, random);
}

void change(Event& e, Random& random)
{
    switch (random.below(6)) {
        case 0:
            e.kind = static_cast<EventKind>(random.below(5));
            break;
        case 1:
            change_integer(e.a, random);
            break;
        case 2:
            change_integer(e.b, random);
            break;
        case 3:
            change(e.at, random);
            break;
        case 4:
            change(e.normal[static_cast<int>(random.below(3))], random);
            break;
        default:
            change(e.impulse[static_cast<int>(random.below(3))], random);
    }
}

void change(SeriesRecord& s, Random& random)
{
    const std::size_t k = random.below(3);
    const std::array<double*, 6> numbers{&s.normal_speed,
                                         &s.gravity,
                                         &s.restitution,
                                         &s.tangential,
                                         &s.velocity[static_cast<int>(k)],
                                         &s.acceleration[static_cast<int>(k)]};
    change(*numbers[random.below(numbers.size())], random);
}

void change(FlightRow& row, Random& random)
{
    FlightRecord& f = row.flight;
    const std::size_t k = random.below(3);
    switch (random.below(13)) {
        case 11:
            f.acceleration = own_acceleration;
            return change(f.own[k], random);
        case 12:
            f.guarded = !f.guarded;
            return;
        case 0:
            return change_integer(f.body, random);
        case 1:
            return change(f.start, random);
        case 2:
            return change_integer(f.cell[k], random);
        case 3:
            return change(f.local[k], random);
        case 4:
            return change(f.local_low[k], random);
        case 5:
            return change(f.velocity[k], random);
        case 6:
            return change(f.velocity_low[k], random);
        case 7:
            return change_integer(f.acceleration, random);
        case 8:
            return change_integer(f.support, random);
        case 9:
            f.mode = static_cast<Mode>(random.below(7));
            if (f.mode == Mode::series && !f.series) f.series = SeriesRecord{1, 1, 0.5, 1, Vec3::Zero(), Vec3::Zero()};
            return;
        default:
            if (f.series) return change(*f.series, random);
            return change_integer(row.after, random);
    }
}

template <class Row>
void change_rows(std::vector<Row>& rows, Random& random)
{
    if (rows.empty()) return;
    const std::size_t i = random.below(rows.size()), j = random.below(rows.size());
    switch (random.below(8)) {
        case 0:
            rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(i));
            return;
        case 1: {
            const Row copy = rows[i];
            rows.insert(rows.begin() + static_cast<std::ptrdiff_t>(j), copy);
            return;
        }
        case 2:
            std::swap(rows[i], rows[j]);
            return;
        default:
            change(rows[i], random);
    }
}

void change_events(Chunk& chunk, Random& random)
{
    std::vector<Event> rows = unpacked_events(chunk.data, static_cast<std::size_t>(chunk.row.count), "");
    change_rows(rows, random);
    chunk.data = packed(std::span<const Event>(rows));
    chunk.row.count = static_cast<std::int64_t>(rows.size());
}

void change_flights(Chunk& chunk, Random& random)
{
    std::vector<FlightRow> rows = unpacked_flights(chunk.data, static_cast<std::size_t>(chunk.row.count), "");
    change_rows(rows, random);
    chunk.data = packed(std::span<const FlightRow>(rows));
    chunk.row.count = static_cast<std::int64_t>(rows.size());
}

void change_chunk(std::vector<Chunk>& chunks, Random& random)
{
    if (chunks.empty()) return;
    const std::size_t i = random.below(chunks.size());
    constexpr std::int64_t most_rows = 4096;
    switch (random.below(12)) {
        case 0:
            chunks.erase(chunks.begin() + static_cast<std::ptrdiff_t>(i));
            return;
        case 1:
            return change_integer(chunks[i].row.count, random);
        case 2:
            return change_bytes(chunks[i].data, random);
        default:
            if (chunks[i].row.count < 0 || chunks[i].row.count > most_rows) return;
            return chunks[i].row.kind == "events" ? change_events(chunks[i], random)
                                                  : change_flights(chunks[i], random);
    }
}

void change_meta(Meta& meta, Random& random)
{
    if (meta.empty()) return;
    auto each = std::next(meta.begin(), static_cast<std::ptrdiff_t>(random.below(meta.size())));
    switch (random.below(4)) {
        case 0:
            meta.erase(each);
            return;
        case 1:
            each->second = std::to_string(odd_integer(random, 0));
            return;
        case 2:
            each->second = random.below(2) == 0 ? "double-double" : "double";
            return;
        default:
            each->second = std::to_string(odd_number(random, 1));
    }
}

void change_frame(FrameRow& frame, Random& random)
{
    switch (random.below(5)) {
        case 0:
            return change(frame.epoch_length, random);
        case 1:
            return change(frame.cell_size, random);
        case 4:
            return change(frame.drag, random);
        case 2:
            return change_bytes(frame.gravity, random);
        default:
            return change_bytes(frame.accelerations, random);
    }
}

void change_bodies(std::vector<BodiesRow>& bodies, Random& random)
{
    if (bodies.empty()) return;
    BodiesRow& row = bodies[random.below(bodies.size())];
    if (random.below(6) == 0)
        change_integer(row.count, random);
    else
        change_bytes(row.data, random);
}

}  // namespace

void mutate_recording(RecordingParts& parts, Random& random)
{
    switch (random.below(12)) {
        case 0:
            return change_meta(parts.meta, random);
        case 1:
            return change_frame(parts.frame, random);
        case 2:
        case 3:
            return change_bodies(parts.bodies, random);
        default:
            change_chunk(parts.chunks, random);
    }
}

}  // namespace carom::fuzz
