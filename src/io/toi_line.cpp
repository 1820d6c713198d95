#include "io/toi_line.hpp"

#include "io/limits.hpp"
#include "toi/overlap_depth.hpp"
#include "toi/tolerances.hpp"

#include <carom/time_of_impact.hpp>

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace carom::io {

namespace {

using nlohmann::json;

/// Problem of a line, for its sender.
struct BadQuery : std::runtime_error {
    using std::runtime_error::runtime_error;
};

void expect_object(const json& value, const std::string& where, std::initializer_list<const char*> known)
{
    if (!value.is_object()) throw BadQuery(where + ": must be an object");
    for (const auto& [key, unused] : value.items()) {
        bool is_known = false;
        for (const char* each : known) is_known = is_known || key == each;
        if (!is_known) throw BadQuery(where + ": unknown key \"" + key + "\"");
    }
}

double number(const json& value, const std::string& where)
{
    if (!value.is_number()) throw BadQuery(where + ": must be a number");
    const double x = value.get<double>();
    if (!(std::abs(x) <= largest_number)) throw BadQuery(where + ": must be at most 2^1000 in size");
    return x;
}

Vec3 vector(const json& value, const std::string& where)
{
    if (!value.is_array() || value.size() != 3) throw BadQuery(where + ": must be three numbers");
    return {number(value[0], where), number(value[1], where), number(value[2], where)};
}

const json& needed(const json& object, const char* key, const std::string& where)
{
    const auto found = object.find(key);
    if (found == object.end()) throw BadQuery(where + ": \"" + key + "\" is missing");
    return *found;
}

double at_least_zero(double x, const std::string& where)
{
    if (!(x >= 0)) throw BadQuery(where + ": must not be negative");
    return x;
}

MovingSphere sphere(const json& value, const std::string& where)
{
    expect_object(value, where, {"p", "v", "acc", "r"});
    MovingSphere out;
    out.position = vector(needed(value, "p", where), where + ".p");
    out.velocity = vector(needed(value, "v", where), where + ".v");
    if (value.contains("acc")) out.acceleration = vector(value["acc"], where + ".acc");
    out.radius = at_least_zero(number(needed(value, "r", where), where + ".r"), where + ".r");
    return out;
}

Plane plane(const json& value)
{
    expect_object(value, "plane", {"n", "offset", "thickness"});
    Plane out;
    out.normal = vector(needed(value, "n", "plane"), "plane.n");
    const double most = out.normal.cwiseAbs().maxCoeff();
    if (!(most > 0)) throw BadQuery("plane.n: must not be zero");
    if (std::abs(out.normal.squaredNorm() - 1) > normal_to_rounding) {
        const Vec3 shorter = out.normal / most;
        out.normal = shorter / std::sqrt(shorter.squaredNorm());
    }
    out.offset = number(needed(value, "offset", "plane"), "plane.offset");
    if (value.contains("thickness"))
        out.thickness = at_least_zero(number(value["thickness"], "plane.thickness"), "plane.thickness");
    return out;
}

struct Answer {
    TimeOfImpact hit;
    double overlap = 0;  ///< at t = 0 [length]
};

Answer ask(const json& query)
{
    expect_object(query, "query", {"a", "b", "plane", "until"});
    const MovingSphere a = sphere(needed(query, "a", "query"), "a");
    if (query.contains("b") == query.contains("plane")) throw BadQuery("query: needs either \"b\" or \"plane\"");
    if (query.contains("plane")) {
        const Plane p = plane(query["plane"]);
        return {time_of_impact(a, p), overlap_depth(a, p)};
    }
    const MovingSphere b = sphere(query["b"], "b");
    if (!(a.radius + b.radius > 0)) throw BadQuery("query: one of the radii must be positive");
    return {time_of_impact(a, b), overlap_depth(a, b)};
}

double until(const json& query)
{
    const auto found = query.find("until");
    if (found == query.end()) return std::numeric_limits<double>::infinity();
    if (!found->is_number()) throw BadQuery("until: must be a number");
    return at_least_zero(found->get<double>(), "until");
}

std::string answer(const TimeOfImpact& hit, double overlap)
{
    const std::string tail = (overlap > 0 ? fmt::format(R"(,"overlap":{})", overlap) : "") + "}";
    if (!hit)
        return fmt::format(
                   R"({{"status":"none","t":null,"lo":null,"hi":null,"normal":null,"approach_speed":null,"level":{})",
                   hit.level) +
               tail;
    return fmt::format(R"({{"status":"{}","t":{},"lo":{},"hi":{},"normal":[{},{},{}],"approach_speed":{},"level":{})",
                       hit.status == ImpactStatus::touching ? "touching" : "impact", hit.t, hit.t_lo, hit.t_hi,
                       hit.normal.x(), hit.normal.y(), hit.normal.z(), hit.approach_speed, hit.level) +
           tail;
}

std::string error(const std::string& message)
{
    const json text = message;
    return R"({"status":"error","message":)" + text.dump(-1, ' ', true, json::error_handler_t::replace) + "}";
}

}  // namespace

std::string answer_toi_line(std::string_view line)
{
    if (line.size() > longest_toi_line) return error(fmt::format("longer than {} characters", longest_toi_line));
    try {
        const json query = json::parse(line);
        auto [hit, overlap] = ask(query);
        if (hit.t > until(query)) {
            const int level = hit.level;
            hit = {};
            hit.level = level;
        }
        return answer(hit, overlap);
    } catch (const BadQuery& problem) {
        return error(problem.what());
    } catch (const json::exception& problem) {
        return error(std::string("no JSON: ") + problem.what());
    }
}

}  // namespace carom::io
