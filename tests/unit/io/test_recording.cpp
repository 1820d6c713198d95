#include "fuzz/recording_parts.hpp"
#include "io/columns.hpp"
#include "io/recording_bodies.hpp"
#include "recording_file.hpp"
#include "support/recorded.hpp"

#include <catch2/catch.hpp>

#include <sqlite3.h>

#include <set>

using namespace carom;
using namespace carom::test;
using Catch::Matchers::Contains;

namespace {

std::string bytes_of(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void write_bytes(const std::filesystem::path& file, const std::string& bytes)
{
    std::ofstream(file, std::ios::binary) << bytes;
}

void run_sql(const std::filesystem::path& file, const char* sql)
{
    sqlite3* db = nullptr;
    REQUIRE(sqlite3_open(file.c_str(), &db) == SQLITE_OK);
    REQUIRE(sqlite3_exec(db, sql, nullptr, nullptr, nullptr) == SQLITE_OK);
    sqlite3_close(db);
}

Scene ball_with_series()
{
    Scene scene = empty_scene(5, earth, 0.8);
    scene.materials[0].tangential = 0.9;
    add_sphere(scene, 0.1, {0, 0, 1.1}, {0.2, 0, 0});
    scene.spheres.back().id = "\"ball\", \xc3\xa4";
    add_floor(scene);
    scene.contacts.push_back({0, 0, 0.75, {}, {}});
    return scene;
}

}  // namespace

TEST_CASE("columns come back to the bit, whatever is in them", "[recording]")
{
    Random random(1);
    for (const std::size_t n : {0UL, 1UL, 2UL, 1000UL, 20000UL}) {
        std::vector<double> noise(n), same(n, -0.0), steps(n);
        std::vector<std::int64_t> counts(n);
        std::vector<std::int32_t> small(n);
        for (std::size_t i = 0; i < n; ++i) {
            noise[i] = random.uniform(-1, 1);
            steps[i] = static_cast<double>(i) / 64;
            counts[i] = i % 7 == 0 ? std::numeric_limits<std::int64_t>::min() : static_cast<std::int64_t>(i * i);
            small[i] = static_cast<std::int32_t>(i % 100) - 50;
        }
        io::ColumnWriter out;
        out.add(noise);
        out.add(same);
        out.add(steps);
        out.add_differences(counts);
        out.add(small);
        std::vector<double> a, b, c;
        std::vector<std::int64_t> d;
        std::vector<std::int32_t> e;
        io::ColumnReader in(out.bytes(), n, "file");
        in.read(a);
        in.read(b);
        in.read(c);
        in.read_differences(d);
        in.read(e);
        in.finish();
        CHECK(a == noise);
        CHECK((n == 0 || std::signbit(b.back())));
        CHECK(c == steps);
        CHECK(d == counts);
        CHECK(e == small);
        if (n == 20000) CHECK(out.bytes().size() < 20000 * (8 + 0 + 4 + 4 + 2));
        // Whatever is cut off or changed is refused or read as something else, never worse.
        for (std::size_t k = 0; k + 1 < out.bytes().size() && k < 300; ++k) {
            io::ColumnReader cut(std::span(out.bytes()).first(k), n, "file");
            CHECK_THROWS_AS((cut.read(a), cut.read(b), cut.read(c), cut.read_differences(d), cut.read(e)), InputError);
        }
    }
}

TEST_CASE("a recording gives back what the run showed, to the bit", "[recording]")
{
    const RecordingFolder folder;
    for (const Scene& scene : {gas(3, 100, 5, {0, 0, -1}, 0.95), ball_with_series()}) {
        const std::filesystem::path file = folder / "run.carom";
        const Outcome outcome = record_to(file, scene);
        const MemorySource expected = recorded(scene);
        RecordingReader reader(file);
        CHECK(reader.meta().at("status") == "reached_end");
        CHECK(reader.run().end->event_hash == outcome.event_hash);
        CHECK(reader.run().end->time == outcome.time);
        CHECK(reader.run().frame.accelerations == expected.description.frame.accelerations);
        CHECK(reader.body_name(0) == scene.spheres[0].id);
        CHECK(reader.body_name(scene.plane_body(0)) == scene.planes[0].id);
        Instant instant;
        std::size_t events = 0, flights = 0, series = 0;
        while (reader.next(instant)) {
            for (const Event& e : instant.events) {
                const Event& known = expected.events.at(events++);
                CHECK((e.at == known.at && e.a == known.a && e.b == known.b && e.kind == known.kind));
                CHECK((e.impulse == known.impulse && e.normal == known.normal));
            }
            for (const FlightRecord& f : instant.flights) {
                CHECK(expected.after.at(flights) == events);
                const FlightRecord& known = expected.flights.at(flights++);
                CHECK((f.body == known.body && f.start == known.start && f.cell == known.cell));
                CHECK((f.local == known.local && f.velocity == known.velocity && f.local_low == known.local_low));
                CHECK((f.mode == known.mode && f.support == known.support && f.acceleration == known.acceleration));
                REQUIRE(f.series.has_value() == known.series.has_value());
                if (!f.series) continue;
                ++series;
                CHECK(f.series->normal_speed == known.series->normal_speed);
                CHECK(f.series->velocity == known.series->velocity);
                CHECK(f.series->acceleration == known.series->acceleration);
            }
        }
        CHECK(events == expected.events.size());
        CHECK(flights == expected.flights.size());
        CHECK((scene.spheres.size() > 1 || series == 1));
        RecordingReader again(file);
        CHECK(verify(again).holds());
    }
}

TEST_CASE("a recording says how often spheres touch what, whatever the names", "[recording]")
{
    const RecordingFolder folder;
    const Scene scene = ball_with_series();
    record_to(folder / "run.carom", scene);
    const RecordingReader reader(folder / "run.carom");
    // The scene in it is a scene, but for the spheres.
    CHECK_THAT(reader.scene(), Contains("\"carom-scene/1\"") && Contains("0.75"));
    CHECK(reader.run().contacts.at(0).restitution == 0.75);
    CHECK_FALSE(reader.run().contacts.at(0).tangential);
    CHECK(find_recording(folder / "run.carom") == find_recording((folder / "run.carom").parent_path()));
    CHECK_THROWS_AS(find_recording(folder / "nothing"), InputError);
}

TEST_CASE("of 1000 flipped bits every one that changes what is read is refused", "[recording]")
{
    const RecordingFolder folder;
    const std::filesystem::path file = folder / "run.carom", flipped = folder / "flipped.carom";
    record_to(file, gas(3, 300, 2));
    const std::string bytes = bytes_of(file), content = content_of(file);
    INFO("size " << bytes.size());
    Random random(2);
    int refused = 0, unused = 0;
    for (int i = 0; i < 1000; ++i) {
        std::string damaged = bytes;
        const auto at = static_cast<std::size_t>(random.uniform(0, static_cast<double>(bytes.size())));
        const int bit = static_cast<int>(random.uniform(0, 8));
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
        write_bytes(flipped, damaged);
        try {
            const std::string read = content_of(flipped);
            INFO("byte " << at << " bit " << bit);
            CHECK(read == content);
            ++unused;
        } catch (const InputError&) {
            ++refused;
        }
    }
    CHECK(refused + unused == 1000);
    CHECK(unused < 100);
    WARN("of 1000 flipped bits " << refused << " are refused, " << unused << " are in bytes that nobody reads");
}

TEST_CASE("flips in the pages that SQLite keeps its own books in are refused, too", "[recording]")
{
    // A short recording is little else.
    const RecordingFolder folder;
    const std::filesystem::path file = folder / "run.carom", flipped = folder / "flipped.carom";
    record_to(file, ball_with_series());
    const std::string bytes = bytes_of(file), content = content_of(file);
    Random random(3);
    int refused = 0;
    for (int i = 0; i < 1500; ++i) {
        std::string damaged = bytes;
        const auto at = static_cast<std::size_t>(random.uniform(0, static_cast<double>(bytes.size())));
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << static_cast<int>(random.uniform(0, 8))));
        write_bytes(flipped, damaged);
        try {
            const std::string read = content_of(flipped);
            INFO("byte " << at);
            CHECK(read == content);
        } catch (const InputError&) {
            ++refused;
        }
    }
    CHECK(refused > 500);
}

TEST_CASE("rows that are missing, doubled or out of order are damage", "[recording]")
{
    const RecordingFolder folder;
    const std::filesystem::path file = folder / "run.carom", changed = folder / "changed.carom";
    RunOptions options;
    options.max_events = 30000;
    record_to(file, gas(3, 100, 1e6), options);
    CHECK_NOTHROW(content_of(file));
    for (const char* sql :
         {"DELETE FROM chunks WHERE seq = 2", "DELETE FROM chunks WHERE seq = (SELECT max(seq) FROM chunks)",
          "UPDATE chunks SET seq = -1 WHERE seq = 0", "DELETE FROM meta WHERE key = 'status'",
          "UPDATE meta SET value = 'zeno' WHERE key = 'status'", "UPDATE meta SET value = '9' WHERE key = 'time'",
          "INSERT INTO meta VALUES ('extra', '1')", "UPDATE frame SET cell_size = 2 * cell_size",
          "UPDATE frame SET drag = 1e-300", "DELETE FROM bodies WHERE kind = 'planes'",
          "UPDATE bodies SET count = count + 1", "DELETE FROM scene", "UPDATE scene SET document = x'00'",
          "UPDATE chunks SET last_offset = last_offset / 2 WHERE seq = 3",
          "UPDATE chunks SET count = '7' WHERE seq = 3", "CREATE TABLE more(x)", "PRAGMA user_version = 1",
          "PRAGMA application_id = 1", "UPDATE chunks SET highest_body = 101 WHERE seq = 1"}) {
        std::filesystem::copy_file(file, changed, std::filesystem::copy_options::overwrite_existing);
        run_sql(changed, sql);
        INFO(sql);
        CHECK_THROWS_AS(content_of(changed), InputError);
    }
}

TEST_CASE("the tie of a run is that of the scene in it, in range or damage", "[recording]")
{
    const RecordingFolder folder;
    const std::filesystem::path file = folder / "run.carom", changed = folder / "changed.carom";
    Scene scene = ball_with_series();
    record_to(file, scene);
    CHECK(RecordingReader(file).run().tie == 0);
    scene.impact.tie = 1.0 / 3000;
    record_to(file, scene);
    CHECK(RecordingReader(file).run().tie == 1.0 / 3000);
    const auto with_document = [&](const std::string& document) {
        fuzz::RecordingParts parts = fuzz::read_parts(file);
        parts.scene.assign(document.begin(), document.end());
        std::filesystem::remove(changed);
        fuzz::write_parts(changed, parts);
        return RecordingReader(changed).run().tie;
    };
    CHECK(with_document("{}") == 0);
    CHECK(with_document(R"({"impact": "lcp"})") == 0);
    CHECK(with_document(R"({"impact": {"tie": 1e-2}})") == 1e-2);
    for (const char* tie : {"0.011", "-1e-9", "\"1e-3\"", "[0]", "1e999"}) {
        CAPTURE(tie);
        CHECK_THROWS_WITH(with_document(R"({"impact": {"tie": )" + std::string(tie) + "}}"), Contains("damaged: "));
    }
    CHECK_THROWS_WITH(with_document("\x1b[31m"), Contains("damaged: its scene is no JSON"));
}

TEST_CASE("a drag that cannot be is damage, whatever the checksums say", "[recording]")
{
    const RecordingFolder folder;
    const std::filesystem::path file = folder / "run.carom", changed = folder / "changed.carom";
    record_to(file, ball_with_series());
    CHECK(RecordingReader(file).run().frame.drag == 0);
    for (const double drag : {-1e-300, std::numeric_limits<double>::infinity()}) {
        fuzz::RecordingParts parts = fuzz::read_parts(file);
        parts.frame.drag = drag;
        std::filesystem::remove(changed);
        fuzz::write_parts(changed, parts);
        CAPTURE(drag);
        CHECK_THROWS_WITH(content_of(changed), Contains("a drag that cannot be"));
    }
}

TEST_CASE("what SQLite says of a damaged schema cannot reach the terminal raw", "[recording]")
{
    const RecordingFolder folder;
    const std::filesystem::path file = folder / "run.carom";
    record_to(file, ball_with_series());
    std::string bytes = bytes_of(file);
    const std::size_t at = bytes.find("tablemetameta");
    REQUIRE(at != std::string::npos);
    bytes.replace(at, 9, "table\x1b[1m");
    write_bytes(file, bytes);
    try {
        RecordingReader reader(file);
        FAIL("the damage was not seen");
    } catch (const InputError& error) {
        CHECK_THAT(error.what(), Contains("damaged: ") && Contains("\\x1b[1m") && !Contains("\x1b"));
    }
}

TEST_CASE("what is no recording is said so", "[recording]")
{
    const RecordingFolder folder;
    const auto problem = [&](const std::string& bytes) -> std::string {
        write_bytes(folder / "x.carom", bytes);
        try {
            RecordingReader reader(folder / "x.carom");
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    CHECK_THAT(problem("just text, and not little of it, really"), Contains("x.carom"));
    CHECK_THAT(problem(""), Contains("no carom recording"));
    CHECK_THROWS_AS(RecordingReader(folder / "missing.carom"), InputError);
    CHECK_THROWS_AS(RecordingWriter("/proc/nowhere/run.carom", ball_with_series()), InputError);
}

TEST_CASE("a file cut anywhere is refused or reads as a part", "[recording]")
{
    const RecordingFolder folder;
    const std::filesystem::path file = folder / "run.carom", cut = folder / "cut.carom";
    record_to(file, gas(3, 100, 5));
    const std::string bytes = bytes_of(file);
    for (std::size_t n = 0; n < bytes.size(); n += 997) {
        write_bytes(cut, bytes.substr(0, n));
        CHECK_THROWS_AS(content_of(cut), InputError);
    }
}

TEST_CASE("counts beyond reason are refused before memory is asked for, whatever the checksums say", "[recording]")
{
    const RecordingFolder folder;
    const std::filesystem::path file = folder / "run.carom", changed = folder / "changed.carom";
    record_to(file, ball_with_series());
    for (std::size_t k = 0; k < io::bodies_kinds().size(); ++k)
        for (const std::int64_t count : {std::int64_t{1} << 31, std::int64_t{1} << 40, INT64_MAX, std::int64_t{-1}}) {
            fuzz::RecordingParts parts = fuzz::read_parts(file);
            parts.bodies[k].count = count;
            std::filesystem::remove(changed);
            fuzz::write_parts(changed, parts);
            CAPTURE(k, count);
            CHECK_THROWS_WITH(content_of(changed), Contains("too many " + io::bodies_kinds()[k]));
        }
}

TEST_CASE("drag, accelerations of their own, supports by several and windows of the guard are read back to the bit",
          "[recording]")
{
    const RecordingFolder folder;
    const std::filesystem::path file = folder / "run.carom";
    Scene scene = empty_scene(2, {0, 0, -1}, 0.5);
    add_sphere(scene, 1, {0, 0, 0});
    add_sphere(scene, 1, {3, 0, 0});
    scene.rest.closing_speed = 0.1;
    scene.rest.window = 1.0 / 3;
    FlightRecord held, guarded;
    held.body = 0;
    held.acceleration = own_acceleration;
    held.own = {1.0 / 3, -0.0, 1e-300};
    held.support = several_supports;
    held.mode = Mode::sliding;
    guarded.body = 1;
    guarded.guarded = true;
    guarded.mode = Mode::numeric;
    {
        RecordingWriter writer(file, scene, {"event", false, scene.end_time});
        writer.on_frame({1, 1, 1.0 / 7, {Vec3::Zero(), scene.gravity}});
        writer.on_flight(held);
        writer.on_flight(guarded);
        Event guard;
        guard.kind = EventKind::guard;
        guard.a = 0;
        writer.on_event(guard);
        writer.on_flight(held);
        writer.finish({});
    }
    RecordingReader reader(file);
    CHECK(reader.run().frame.drag == 1.0 / 7);
    CHECK(reader.run().closing_speed == 0.1);
    CHECK(reader.run().window == 1.0 / 3);
    Instant instant;
    REQUIRE(reader.next(instant));
    REQUIRE(instant.flights.size() == 2);
    const auto same = [](const FlightRecord& f, const FlightRecord& known) {
        return std::memcmp(f.own.data(), known.own.data(), sizeof f.own) == 0 && f.guarded == known.guarded &&
               f.acceleration == known.acceleration && f.support == known.support && f.mode == known.mode;
    };
    CHECK(same(instant.flights[0], held));
    CHECK(same(instant.flights[1], guarded));
    REQUIRE(reader.next(instant));
    REQUIRE(instant.events.size() == 1);
    CHECK(instant.events[0].kind == EventKind::guard);
    CHECK(instant.events[0].b == no_body);
    CHECK(same(instant.flights[0], held));
    CHECK_FALSE(reader.next(instant));
}
