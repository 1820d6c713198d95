/// \file
/// A recording: it is refused, or it can be read to its end and examined, whatever its flights and events say. Half of
/// the changes are made to its contents, with checksums as they should be.
#include "fuzz/fuzz.hpp"
#include "fuzz/mutate_recording.hpp"
#include "fuzz/recording_parts.hpp"

#include <carom/error.hpp>
#include <carom/io.hpp>
#include <carom/verify.hpp>

#include <cmath>
#include <cstring>

namespace carom::fuzz {

namespace {

void check(const Certificate& c)
{
    expect(c.holds() == c.violations.empty(), "violations that are not listed");
    expect(std::isfinite(c.until) && c.until >= 0, "examined up to no time");
    for (const double share : {c.body_seconds.exact, c.body_seconds.bounded, c.body_seconds.not_certified})
        expect(share >= 0, "body-seconds that are no time");
    for (const double error : {c.largest_jump, c.largest_impulse_error, c.largest_momentum_error,
                               c.largest_energy_error, c.largest_law_error, c.largest_impact_gap})
        expect(error >= 0, "an error that is no number");
}

void examine(const std::filesystem::path& file, bool all_pairs)
{
    RecordingReader reader(file);
    VerifyOptions options;
    options.all_pairs = all_pairs;
    check(verify(reader, options));
    const std::size_t bodies = reader.run().spheres.size() + reader.run().planes.size();
    if (bodies > 0) reader.body_name(static_cast<BodyId>(bodies - 1));
}

Scene scene_of(const char* name)
{
    return read_scene(find_scene(name, CAROM_SCENE_DIR));
}

std::string recorded(const Scene& scene, bool certified, std::int64_t most_events)
{
    const MemoryFile file;
    {
        RecordingWriter writer(file.path(), scene, {"event", certified, scene.end_time});
        EventDriven method;
        method.certified = certified;
        RunOptions options;
        options.max_events = most_events;
        Observer observer;
        observer.on_frame = [&](const RunFrame& frame) { writer.on_frame(frame); };
        observer.on_event = [&](const Event& event) { writer.on_event(event); };
        observer.on_flight = [&](const FlightRecord& flight) { writer.on_flight(flight); };
        writer.finish(simulate(scene, method, options, observer));
    }
    return file.read();
}

}  // namespace

std::vector<std::string> seeds()
{
    constexpr std::int64_t most_events = 24;
    std::vector<std::string> recordings;
    for (const char* name : {"bouncing_ball", "cradle", "two_spheres", "counting_pi_1", "incline", "far_away"})
        for (const bool certified : {false, true})
            recordings.push_back(recorded(scene_of(name), certified, most_events));
    for (const char* name : {"viscous_throw", "fading_gas"})
        recordings.push_back(recorded(scene_of(name), false, most_events));
    return recordings;
}

}  // namespace carom::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace carom;
    const fuzz::MemoryFile file;
    file.write(data, size);
    for (const bool all_pairs : {false, true}) try {
            fuzz::examine(file.path(), all_pairs);
        } catch (const InputError& error) {
            fuzz::expect(!error.problems().empty(), "refused without a reason");
        }
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int seed)
{
    using namespace carom;
    Random random(seed);
    if (random.below(4) == 0) return LLVMFuzzerMutate(data, size, most);
    try {
        const fuzz::MemoryFile from, to;
        from.write(data, size);
        fuzz::RecordingParts parts = fuzz::read_parts(from.path());
        for (std::size_t n = 1 + random.below(3); n > 0; --n) fuzz::mutate_recording(parts, random);
        fuzz::write_parts(to.path(), std::move(parts));
        const std::string out = to.read();
        if (out.size() <= most) {
            std::memcpy(data, out.data(), out.size());
            return out.size();
        }
    } catch (const InputError&) {
        // no recording any more: nothing but bytes
    }
    return LLVMFuzzerMutate(data, size, most);
}
