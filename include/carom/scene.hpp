/// \file
/// A scene as plain data: what the files in `scenes/` say, with every fill and box expanded.
///
/// Ranges are noted with the fields and checked by `validate`; functions that take a scene expect a valid one.
/// Functions here throw nothing.
#pragma once

#include <carom/event.hpp>
#include <carom/response.hpp>
#include <carom/stress.hpp>
#include <carom/types.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace carom {

/// The answer of a material to an impact. The smaller value of two materials in contact holds, unless a ContactRule
/// says otherwise.
struct Material {
    std::string name;
    double restitution = 1;  ///< e, in [0, 1]: v_n+ = -e v_n
    double tangential = 1;   ///< alpha, in [0, 1]: v_t+ = alpha v_t; acts at planes
    std::string color;       ///< CSS colour, may be empty
};

/// Override for contacts between two materials.
struct ContactRule {
    int a = 0, b = 0;                   ///< indices into Scene::materials
    std::optional<double> restitution;  ///< [0, 1]
    std::optional<double> tangential;   ///< [0, 1]; between spheres it acts only when given here
    std::optional<double>
        attenuation;  ///< [0, 1], sphere-sphere only: both velocities are multiplied by it after the exchange
};

/// The coefficients that hold for one contact, see `contact_law`.
struct ContactLaw {
    double restitution = 1;  ///< e
    double tangential = 1;   ///< alpha
    double attenuation = 1;  ///< damping of both velocities after an impact of two spheres; not Galilean invariant
};

struct Sphere {
    std::string id;
    double radius = 0;             ///< > 0 [length]
    double mass = 1;               ///< > 0 [mass]
    Vec3 position = Vec3::Zero();  ///< centre, relative to Scene::origin [length]
    Vec3 velocity = Vec3::Zero();  ///< [length/time]
    int material = 0;              ///< index into Scene::materials
    std::string color;             ///< CSS colour; empty: that of the material
    bool fixed = false;            ///< never moves: velocity 0, infinitely heavy in impacts whatever `mass` says
};

/// A plane. Without thickness: a half-space wall, free side normal.x >= offset, gap = normal.x - offset - r. With
/// thickness: a two-sided plate, gap = |normal.x - offset| - thickness/2 - r.
struct Plane {
    std::string id;
    Vec3 normal = Vec3::UnitZ();      ///< unit length to rounding
    double offset = 0;                ///< [length], relative to Scene::origin
    std::optional<double> thickness;  ///< >= 0 [length]; present: a plate
    int material = 0;                 ///< index into Scene::materials
};

/// Questions that checks ask of a run; see `evaluate_checks` for the error of each.
enum class CheckType : std::uint8_t {
    no_overlap,
    energy,
    final_energy,
    momentum,
    inside,
    event_time,
    event_count,
    rest_time,
    position,
    final_position,
    final_velocity,
    moved,         ///< the scene moved by `value` has the same run
    moved_origin,  ///< so has the scene whose origin is moved by `value`
    later,         ///< so has the scene whose clock shows `time` more
    reversed,      ///< run on from the end with all velocities turned round, the scene comes back to its start
    mirrored       ///< at the end it is its own image in the plane through 0 across `value`
};
inline constexpr std::array<std::string_view, 16> check_type_names{
    "no_overlap",   "energy",    "final_energy", "momentum",       "inside",         "event_time",
    "event_count",  "rest_time", "position",     "final_position", "final_velocity", "moved",
    "moved_origin", "later",     "reversed",     "mirrored"};

/// One line of a scene's `checks`: what a correct event run of the scene must show.
struct Check {
    CheckType type = CheckType::no_overlap;
    std::optional<double> rel, abs;  ///< tolerance, at most one of them
    std::int64_t index = 0;          ///< event_time: 0-based among the impacts, or among those of the two of `between`
    std::optional<std::array<BodyId, 2>> between;  ///< event_time
    std::int64_t count = 0;                        ///< event_count
    EventKind kind = EventKind::impact;            ///< event_count
    double time = 0;            ///< event_time, rest_time, position: since the start of the run; later [time]
    BodyId body = no_body;      ///< rest_time, position, final_position, final_velocity
    Vec3 value = Vec3::Zero();  ///< positions, moved, moved_origin [length], final_velocity [length/time]; mirrored: a
                                ///< normal, not 0
};

/// Default options of a command: its long option names with `_` for `-`. Values are kept as the file wrote them.
using OptionValue = std::variant<bool, double, std::string, std::vector<std::string>>;
using CommandDefaults = std::map<std::string, OptionValue>;

struct Units {
    std::string length, time, mass;  ///< text for titles and axes; may be empty
};

struct Scene {
    std::string name, description;
    Units units;
    Vec3 gravity = Vec3::Zero();  ///< [length/time^2]
    double drag = 0;              ///< k >= 0 of the field friction: dv/dt = gravity - k v [1/time]
    Vec3 origin = Vec3::Zero();   ///< where the scene lies; positions and planes are relative to it [length]
    /// The clock's time when the run began: a label, no time of a run counts from it. `epoch` counts epochs of the run.
    EpochTime start_time;
    double end_time = 0;     ///< > 0, length of the run [time]
    std::uint64_t seed = 1;  ///< every random choice comes from it
    std::vector<Material> materials{Material{"default", 1, 1, ""}};
    std::vector<ContactRule> contacts;
    RestOptions rest;
    ImpactOptions impact;
    GuardOptions guard;
    std::vector<Sphere> spheres;
    std::vector<Plane> planes;
    std::vector<Check> checks;
    std::optional<StressPart> stress;  ///< none: no part of `carom stress`
    CommandDefaults run, compare, tunnel, view;

    /// Id under which events name plane p. \pre p < planes.size()
    BodyId plane_body(std::size_t p) const { return static_cast<BodyId>(spheres.size() + p); }
    /// Id string of a sphere or plane as events number them. \pre 0 <= body < number of spheres and planes
    const std::string& body_name(BodyId body) const
    {
        const auto n = static_cast<BodyId>(spheres.size());
        return body < n ? spheres[static_cast<std::size_t>(body)].id : planes[static_cast<std::size_t>(body - n)].id;
    }
};

/// Every broken rule as "/json/pointer: what is wrong (the cure)"; empty when the scene is valid. Values first (finite,
/// in range, ids unique, materials known); if those hold, overlaps: a gap below -1e-9 r, r the smaller
/// radius, of bodies of which one can move, unless `allow_overlap`. Scenes that a reader gave are valid; ask for those
/// built in code.
std::vector<std::string> validate(const Scene& scene, bool allow_overlap = false);

/// Coefficients for contacts between two spheres of these materials: smaller restitution; tangential and attenuation 1
/// unless a ContactRule gives them. \pre both are indices into Scene::materials; so below.
ContactLaw sphere_contact_law(const Scene& scene, int material_a, int material_b);
/// Coefficients for a sphere on a plane: smaller restitution, smaller tangential unless a ContactRule gives them;
/// attenuation 1.
ContactLaw plane_contact_law(const Scene& scene, int sphere_material, int plane_material);

/// RestOptions with every default filled in (this project; docs/impacts.md, section 4).
struct RestThresholds {
    double closing_speed;  ///< v_c: slower closings count as rest, but for a sphere alone on a plane or on another one
                           ///< [length/time]
    double window;         ///< tau_p: a contact that closed more recently is inelastic [time]
    double numeric_step;   ///< h: step of numeric clusters, window of the impact-rate bound [time]
    double gap_tolerance;  ///< g_tol: a contact within it counts as closed when it persists [length]
};
RestThresholds rest_thresholds(const Scene& scene);

/// Signed distance from the surface of sphere `s`, centred at `position`, to the surface of plane `p`, negative where
/// they overlap; in plain double arithmetic [length].
double plane_gap(const Plane& p, const Sphere& s, const Vec3& position);

}  // namespace carom
