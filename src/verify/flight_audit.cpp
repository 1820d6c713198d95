#include "verify/flight_audit.hpp"

namespace carom::verification {

namespace {

constexpr auto furthest = static_cast<std::int64_t>(most_recorded);

bool is_finite(const FlightRecord& f)
{
    for (std::size_t k = 0; k < 3; ++k) {
        if (!(std::abs(f.local[k]) < most_recorded) || !(std::abs(f.local_low[k]) < most_recorded)) return false;
        if (!std::isfinite(f.velocity[k]) || !std::isfinite(f.velocity_low[k]) || !std::isfinite(f.own[k]))
            return false;
        if (f.cell[k] <= -furthest || f.cell[k] >= furthest) return false;
    }
    return true;
}

SeriesRecord scaled(const SeriesRecord& s, const Units& units)
{
    SeriesRecord out = s;
    out.normal_speed = units.speed(s.normal_speed);
    out.gravity = units.acceleration(s.gravity);
    for (int k = 0; k < 3; ++k) {
        out.velocity[k] = units.speed(s.velocity[k]);
        out.acceleration[k] = units.acceleration(s.acceleration[k]);
    }
    return out;
}

/// The numbers of a series follow from its flight, its plane and the contact law.
bool series_fits(const RunData& data, BodyId body, const Path& path, const SeriesRecord& s)
{
    const Wall& wall = data.wall(path.support);
    const Vec3 normal = side_of(wall, path) * wall.normal;
    const ContactLaw law = data.law(body, data.spheres() + path.support);
    const double speed = path.velocity.norm(), pull = data.gravity.norm();
    const double w = normal.dot(path.velocity);
    const Vec3 along = path.velocity - w / normal.squaredNorm() * normal;
    return s.normal_speed > 0 && s.gravity > 0 && s.restitution == law.restitution && s.restitution > 0 &&
           s.restitution < 1 && s.tangential == law.tangential &&
           std::abs(s.normal_speed - w) <= split_rounding * speed &&
           std::abs(s.gravity + normal.dot(data.gravity)) <= split_rounding * pull &&
           (s.velocity - along).cwiseAbs().maxCoeff() <= split_rounding * speed &&
           data.is_along(s.acceleration, path.support);
}

/// Demand of the mode on acceleration, support and speed that is not met; nullptr if all is well.
const char* wrong_with(const RunData& data, BodyId body, const Path& path, const std::optional<SeriesRecord>& series)
{
    const Vec3 a = data.acceleration(path);
    const bool fixed = data.sphere(body).fixed;
    if (fixed != (path.mode == Mode::fixed)) return "is fixed, or is not";
    const bool several = path.support == several_supports, numeric = path.mode == Mode::numeric;
    const bool supported = is_held(path) || path.mode == Mode::series;
    if ((supported != (path.support != -1) && !numeric) || (several && !is_held(path) && !numeric))
        return "has a support that its mode does not have";
    if (path.guarded && !(numeric && a.isZero(0))) return "is guarded and goes no straight line";
    if (path.acceleration == own_acceleration && !numeric && !is_held_by_several(path))
        return "has an acceleration of its own that its mode does not have";
    if (fixed) return a.isZero(0) && path.velocity.isZero(0) ? nullptr : "is fixed and moves";
    if (is_held(path) && !several && !data.is_along(a, path.support))
        return "slides under an acceleration that is not gravity's";
    if (path.mode == Mode::resting && !(a.isZero(0) && path.velocity.isZero(0) && path.velocity_low.isZero(0)))
        return "rests and moves";
    if (path.mode == Mode::flying && a != data.gravity) return "flies under an acceleration that is not gravity";
    if (path.mode == Mode::series && data.drag > 0) return "is in a series, which drag does not allow";
    if (path.mode == Mode::series && !(series && series_fits(data, body, path, *series)))
        return "is in a series that does not follow from its flight";
    return nullptr;
}

}  // namespace

bool is_moment(const EpochTime& t)
{
    return t.offset >= 0 && t.offset < 1 && t.epoch >= 0 && t.epoch < furthest;
}

std::optional<Accepted> accept(const RunData& data, Findings& findings, const FlightRecord& f)
{
    const std::string who = "sphere " + std::to_string(f.body);
    const auto refuse = [&](const std::string& what) -> std::optional<Accepted> {
        findings.violation(what, is_moment(data.units.moment(f.start)) ? data.units.moment(f.start) : EpochTime{},
                           f.body);
        return {};
    };
    if (f.body < 0 || f.body >= data.spheres()) return refuse("a flight of " + who + ", which is not there");
    if (!is_moment(data.units.moment(f.start)) || !is_finite(f)) return refuse(who + " has a number out of range");
    const bool is_own = f.acceleration == own_acceleration;
    if (f.acceleration < own_acceleration ||
        (!is_own && static_cast<std::size_t>(f.acceleration) >= data.accelerations.size()) ||
        f.support < several_supports || f.support >= data.planes())
        return refuse(who + " has an acceleration or a support that is not there");
    Accepted out;
    Path& path = out.path;
    path.start = data.units.moment(f.start);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        path.cell[k] = f.cell[k];
        path.local[k] = f.local[k] / data.units.length;
        path.local_low[k] = f.local_low[k] / data.units.length;
        path.velocity[i] = data.units.speed(f.velocity[k]);
        path.velocity_low[i] = data.units.speed(f.velocity_low[k]);
        path.own[i] = is_own ? data.units.acceleration(f.own[k]) : 0;
    }
    path.acceleration = f.acceleration;
    path.support = f.support;
    path.mode = f.mode;
    path.guarded = f.guarded;
    path.drag = data.drag;
    if (f.series) out.series = scaled(*f.series, data.units);
    if (!path.velocity.allFinite() || !path.own.allFinite()) return refuse(who + " has a speed out of range");
    if (const char* wrong = wrong_with(data, f.body, path, out.series)) return refuse(who + " " + wrong);
    return out;
}

std::optional<Vec3> check_first(const RunData& data, Findings& findings, BodyId body, const Path& path)
{
    const RecordedStart& start = data.run.starts[static_cast<std::size_t>(body)];
    const double size = start.velocity.norm() / data.units.length * data.units.time;
    bool is_off = false;
    Vec3 off = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble x =
            DoubleDouble(static_cast<double>(path.cell[k])) + joined<DoubleDouble>(path.local[k], path.local_low[k]);
        const double scene = start.position[k] / data.units.length;
        // A place on the negative side of 0 may be rounded to its cell.
        if (std::abs((x - DoubleDouble(scene)).high) > (scene < 0 ? negative_place_rounding : 0)) {
            findings.violation("sphere " + std::to_string(body) + " does not start where the scene says", {}, body);
            return {};
        }
        const double v = data.units.speed(data.sphere(body).fixed ? 0 : start.velocity[k]);
        double turn = path.support < 0 ? 0 : split_rounding * size * std::abs(data.wall(path.support).normal[k]);
        if (path.support == several_supports) turn = 4 * (still * data.closing_speed + hidden * size);
        off[k] = path.velocity[k] - v;
        if (path.velocity_low[k] != 0) off[k] = std::numeric_limits<double>::infinity();
        is_off = is_off || std::abs(off[k]) > turn;
    }
    return is_off ? std::optional(off) : std::nullopt;
}

void check_first_speed(const RunData& data, Findings& findings, BodyId body, const Vec3& off,
                       std::span<const Vec3> normals, double speeds)
{
    Vec3 along = Vec3::Zero();
    for (const Vec3& n : normals) along += n.cwiseAbs();
    const Vec3 allowed = 4 * (still * data.closing_speed + hidden * speeds) * along;
    if (!(off.array().abs() <= allowed.array()).all())
        findings.violation("sphere " + std::to_string(body) + " does not start as fast as the scene says", {}, body);
}

}  // namespace carom::verification
