#include "peers/answer.hpp"

#include "core/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>

namespace carom::peers {

namespace {

/// Removes and returns the first line, without its end.
std::string_view take_line(std::string_view& text)
{
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

/// Removes and returns the last number of a line of fields: ids stand at its begin, and may hold commas.
std::optional<double> take_last_number(std::string_view& line)
{
    const std::size_t comma = line.rfind(',');
    const std::string_view field = comma == std::string_view::npos ? line : line.substr(comma + 1);
    double value = 0;
    const auto end = std::from_chars(field.data(), field.data() + field.size(), value);
    if (field.empty() || end.ec != std::errc() || end.ptr != field.data() + field.size() || !std::isfinite(value))
        return {};
    line.remove_suffix(line.size() - (comma == std::string_view::npos ? 0 : comma));
    return value;
}

/// The state at the end of a line; spheres come in the order of the scene.
std::optional<BodyState> state_of(std::string_view line, bool has_velocities)
{
    BodyState state;
    for (Vec3* vector : {&state.velocity, &state.position}) {
        if (vector == &state.velocity && !has_velocities) continue;
        for (int axis = 2; axis >= 0; --axis) {
            const std::optional<double> number = take_last_number(line);
            if (!number) return {};
            (*vector)[axis] = *number;
        }
    }
    return state;
}

/// "# steps 240 cpu_seconds 0.0012"
bool read_cost(std::string_view line, PeerRun& run)
{
    const std::string text(line);
    long long steps = 0;
    if (std::sscanf(text.c_str(), "# steps %lld cpu_seconds %lf", &steps, &run.cpu_seconds) != 2) return false;
    run.steps = steps;
    return true;
}

PeerRun no_answer(PeerRun run, const std::string& why)
{
    run.status = Status::unresolved;
    run.message = why;
    return run;
}

}  // namespace

PeerRun run_of_answer(const Scene& scene, const std::vector<double>& times, std::string_view text)
{
    constexpr std::string_view comment = "# ", error = "# error ";
    PeerRun run;
    std::string_view line = take_line(text);
    if (line.starts_with(error)) return no_answer(run, std::string(line.substr(error.size())));
    if (!line.starts_with(comment)) return no_answer(run, "an answer begins with a line of settings, \"# NAME ...\"");
    run.settings = line.substr(comment.size());
    line = take_line(text);
    run.has_velocities = line == "t,id,x,y,z,vx,vy,vz";
    if (!run.has_velocities && line != "t,id,x,y,z")
        return no_answer(run, "the columns of an answer are t,id,x,y,z,vx,vy,vz, or without velocities");
    for (std::size_t k = 0; k < times.size(); ++k) {
        std::vector<BodyState> sample;
        for (const Sphere& sphere : scene.spheres) {
            line = take_line(text);
            std::optional<BodyState> state = state_of(line, run.has_velocities);
            if (!state)
                return no_answer(
                    run, "the frame at t = " + to_text(times[k]) + " has no row of numbers for " + quoted(sphere.id));
            if (sphere.fixed) state->mode = Mode::fixed;
            sample.push_back(*state);
        }
        run.samples.push_back(std::move(sample));
    }
    if (!read_cost(take_line(text), run)) return no_answer(run, "\"# steps N cpu_seconds S\" is missing at its end");
    return run;
}

}  // namespace carom::peers
