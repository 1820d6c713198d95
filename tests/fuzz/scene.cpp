/// \file
/// A scene: it is refused with reasons, or it is valid; and a small one runs without a crash, in finite numbers.
#include "fuzz/fuzz.hpp"

#include <carom/error.hpp>
#include <carom/io.hpp>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace carom::fuzz {

namespace {

constexpr std::size_t most_spheres = 20;
constexpr std::int64_t most_events = 200;
constexpr double most_seconds = 0.05;

/// Thousands of spheres are no finding, but take their time. A triangle of n rows has n (n + 1) / 2.
bool may_be_large(const std::string& text)
{
    struct Size {
        const char* key;
        double most;
    };
    for (const auto& [key, most] : {Size{"\"count\"", 500}, Size{"\"rows\"", 30}})
        for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
            const std::size_t value = text.find_first_not_of(" \t\r\n:", at + std::string_view(key).size());
            if (value != std::string::npos && std::strtod(text.c_str() + value, nullptr) > most) return true;
        }
    return false;
}

void run(const Scene& scene, bool certified)
{
    EventDriven method;
    method.certified = certified;
    RunOptions options;
    options.max_events = most_events;
    options.max_seconds = most_seconds;
    const Outcome outcome = simulate(scene, method, options);
    expect(outcome.final.size() == scene.spheres.size(), "a sphere has no state");
    expect(std::isfinite(outcome.time) && outcome.time >= 0, "a run that ended at no time");
    if (outcome.status == Status::unresolved) {
        expect(!outcome.message.empty(), "unresolved without a word");
        return;
    }
    for (const BodyState& state : outcome.final)
        expect(state.position.allFinite() && state.velocity.allFinite(), "a state that is not finite");
    for (const double impulse : outcome.plane_impulses) expect(std::isfinite(impulse), "an impulse that is not finite");
    for (const auto& time : outcome.rest_times) expect(!time || std::isfinite(*time), "a rest at no time");
}

}  // namespace

std::vector<std::string> seeds()
{
    std::vector<std::string> texts;
    for (const char* folder : {CAROM_SCENE_DIR, CAROM_SCHEMA_TESTS_DIR})
        for (const auto& path : scene_files(folder)) {
            std::ifstream file(path, std::ios::binary);
            texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
        }
    return texts;
}

}  // namespace carom::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace carom;
    const std::string text(reinterpret_cast<const char*>(data), size);
    if (fuzz::may_be_large(text)) return 0;
    try {
        const Scene scene = parse_scene(text, "scene");
        fuzz::expect(validate(scene).empty(), "a scene that was read is not valid");
        if (scene.spheres.size() > fuzz::most_spheres) return 0;
        for (const bool certified : {false, true}) fuzz::run(scene, certified);
    } catch (const InputError& error) {
        fuzz::expect(!error.problems().empty(), "refused without a reason");
    }
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int seed)
{
    static const std::vector<std::string_view> words{
        "format",       "carom-scene/1", "name",          "units",       "gravity",
        "origin",       "start_time",    "epoch",         "offset",      "end_time",
        "seed",         "materials",     "restitution",   "tangential",  "color",
        "default",      "contacts",      "between",       "attenuation", "rest",
        "policy",       "contact",       "closing_speed", "window",      "numeric_step",
        "series_below", "gap_tolerance", "spheres",       "id",          "radius",
        "mass",         "density",       "position",      "velocity",    "material",
        "fixed",        "planes",        "normal",        "point",       "thickness",
        "box",          "min",           "max",           "walls",       "fill",
        "pattern",      "cubic",         "random",        "triangle",    "line",
        "count",        "rows",          "region",        "spacing",     "speed",
        "checks",       "type",          "energy",        "no_overlap",  "event_time",
        "body",         "value",         "rel",           "abs",         "run",
        "compare",      "method",        "event",         "dt",          "until"};
    return carom::fuzz::mutate_json(data, size, most, seed, words);
}
