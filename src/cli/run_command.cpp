#include "cli/choices.hpp"
#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/limits.hpp"
#include "cli/notes.hpp"
#include "cli/response.hpp"
#include "cli/session.hpp"
#include "cli/tables.hpp"
#include "io/events_csv.hpp"
#include "io/frames_csv.hpp"
#include "io/output_file.hpp"
#include "io/run_json.hpp"

#include <carom/error.hpp>
#include <carom/io.hpp>

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <ostream>

namespace carom::cli {

namespace {

/// Name of stdout for `--events`.
constexpr const char* standard_output = "-";

/// Where the events of a run go: a file, made before the run so that a wrong path fails at once, or stdout.
class EventsOutput {
public:
    EventsOutput(const std::string& where, const Scene& scene, const Method& method, const Console& console)
    {
        if (where != standard_output) open(where);
        csv_.emplace(file_ ? file_->stream() : console.out, scene, std::holds_alternative<EventDriven>(method));
    }
    void write(const Event& event)
    {
        csv_->write(event);
        if (file_) file_->check();  // a full disk ends the run, not a day later
    }
    void close()
    {
        if (file_) file_->close();
    }

private:
    void open(const std::filesystem::path& file)
    {
        // A slip in a path must not make folders.
        if (std::error_code ignored;
            file.has_parent_path() && !std::filesystem::is_directory(file.parent_path(), ignored))
            throw InputError({file.string() + ": no such folder: " + file.parent_path().string() + " (make it first)"});
        file_.emplace(file);
    }

    std::optional<io::OutputFile> file_;
    std::optional<io::EventsCsv> csv_;
};

/// Frames of a run at equal intervals, beside run.json.
class FramesOutput {
public:
    FramesOutput(const std::filesystem::path& folder, const Scene& scene, double rate, double until)
    {
        if (folder.empty()) throw UsageError("run: --frames needs a folder for frames.csv (add -o DIR)");
        if (rate * until > most_frames)
            throw UsageError(
                fmt::format("run: --frames {}: more than {} frames to t = {:.10g}", rate, most_frames, until));
        for (double k = 0; k / rate <= until; ++k) times_.push_back(k / rate);
        std::error_code ignored;  // then the file cannot be written, and says so
        std::filesystem::create_directories(folder, ignored);
        file_.emplace(folder / "frames.csv");
        csv_.emplace(file_->stream(), scene);
    }
    const std::vector<double>& times() const { return times_; }
    /// Writes the states if `time` is that of the next frame.
    void look(double time, std::span<const BodyState> states)
    {
        if (next_ == times_.size() || time != times_[next_]) return;
        csv_->write(time, states);
        file_->check();
        ++next_;
    }
    void close() { file_->close(); }

private:
    std::vector<double> times_;
    std::size_t next_ = 0;
    std::optional<io::OutputFile> file_;
    std::optional<io::FramesCsv> csv_;
};

/// Flights and events of an event-driven run, beside run.json. Discrete methods have none.
std::unique_ptr<RecordingWriter> make_recording(const std::filesystem::path& folder, const Scene& scene,
                                                const RunSettings& settings, bool quiet, const Console& console)
{
    if (!std::holds_alternative<EventDriven>(settings.method)) {
        if (!quiet)
            console.err << fmt::format("{} has no flights to record: {} holds run.json alone\n", name(settings.method),
                                       folder.string());
        return nullptr;
    }
    RecordingOptions options;
    options.method = std::string(name(settings.method));
    options.until = settings.run.until;
    const auto* event = std::get_if<EventDriven>(&settings.method);
    options.certified = event != nullptr && event->certified;
    return std::make_unique<RecordingWriter>(folder / recording_name, scene, options);
}

void explain_settings(const Scene& scene, const std::filesystem::path& file, const RunSettings& settings,
                      const Console& console)
{
    console.err << fmt::format("{}: {}, method {}, to t = {:.10g}\n", file.string(), bodies(scene),
                               name(settings.method), settings.run.until);
    console.err << fmt::format("impact: {}\nrest: {}\nguard: {}\n", impact_words(scene), rest_words(scene),
                               guard_words(scene));
    if (const StepOptions* step = step_options(settings.method))
        console.err << fmt::format("step: dt {:.10g}, {} substeps, {} passes, order {}, integrator {}, seed {}\n",
                                   step->dt, step->substeps, step->passes, name(step->order), name(step->integrator),
                                   step->seed);
}

}  // namespace

int do_run(const RunArguments& args, const GlobalArguments& global, const Console& console)
{
    const bool events_to_stdout = args.events == standard_output;
    if (events_to_stdout && global.json)
        throw UsageError("run: --events - and --json both write to stdout (name a file for the events)");
    Session session(args.given, global, console);
    const std::filesystem::path file = find_scene(args.scene, scene_folder());
    const Scene scene = with_response(session.read(file, args.allow_overlap, args.set), args.given, file.string());
    const RunSettings settings = run_settings(args, global, scene, file.string());
    session.watch.limit(settings.max_seconds);
    if (global.verbose) explain_settings(scene, file, settings, console);
    if (!global.quiet) {
        for (const std::string& each : ignored_options(args.given, settings.method)) print_note(console, each);
        for (const std::string& each : unused_materials(scene, args.set)) print_note(console, each);
    }

    std::optional<EventsOutput> events;
    if (!args.events.empty()) events.emplace(args.events, scene, settings.method, console);
    std::optional<FramesOutput> frames;
    if (settings.frames) frames.emplace(args.out, scene, *settings.frames, settings.run.until);
    std::unique_ptr<RecordingWriter> recording;
    if (!args.out.empty()) recording = make_recording(args.out, scene, settings, global.quiet, console);
    RunStudyOptions options;
    options.run = settings.run;
    if (events || recording)
        options.on_event = [&](const Event& event) {
            if (events) events->write(event);
            if (recording) recording->on_event(event);
        };
    if (recording) {
        options.on_frame = [&](const RunFrame& frame) { recording->on_frame(frame); };
        options.on_flight = [&](const FlightRecord& flight) { recording->on_flight(flight); };
    }
    if (frames) {
        options.more_times = frames->times();
        options.on_state = [&](double time, std::span<const BodyState> states) { frames->look(time, states); };
    }
    options.on_progress = session.on_time("run", settings.run.until, scene);
    RunStudy run = run_study(scene, settings.method, options);
    session.progress.clear();
    session.watch.name_reason(run.outcome);
    if (events) events->close();
    if (frames) frames->close();
    if (recording) recording->finish(run.outcome);

    const io::CommandFacts facts = session.watch.facts();
    if (global.json || !args.out.empty()) {
        const std::string json =
            io::run_json(scene, settings.method, run, {.always_final = settings.always_final, .command = facts});
        if (!args.out.empty()) write_file(std::filesystem::path(args.out) / "run.json", json);
        if (global.json) console.out << json;
    }
    if (!events_to_stdout && !global.json)
        console.out << run_table(scene, run, facts);
    else if (events_to_stdout && !global.quiet)
        console.err << run_table(scene, run, facts);
    const Outcome& outcome = run.outcome;
    if (outcome.status != Status::reached_end && !global.quiet)
        print_error(console, outcome.message.empty()
                                 ? fmt::format("{} at t = {:.10g}", name(outcome.status), outcome.time)
                                 : fmt::format("{}: {}", name(outcome.status), outcome.message));
    const std::string advice = unresolved_advice(outcome);
    if (!advice.empty() && !global.quiet) print_note(console, advice);
    if (!global.quiet)
        for (const std::string& each : lift_notes(scene, run.lifts)) print_note(console, each);
    return exit_code(outcome.status);
}

}  // namespace carom::cli
