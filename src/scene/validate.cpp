#include "scene/validate.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>

#include "core/text.hpp"
#include "scene/check_keys.hpp"
#include "scene/tolerances.hpp"

namespace carom {

std::string BodyPlaces::sphere(std::size_t i) const
{
    return spheres.empty() ? "/spheres/" + std::to_string(i) : spheres[i];
}

std::string BodyPlaces::plane(std::size_t p) const
{
    return planes.empty() ? "/planes/" + std::to_string(p) : planes[p];
}

namespace {

class ValueRules {
public:
    ValueRules(const Scene& scene, const BodyPlaces& places, Patience& patience)
        : scene_(scene), places_(places), patience_(patience)
    {
    }

    std::vector<std::string> broken()
    {
        finite("/gravity", scene_.gravity);
        rule(std::isfinite(scene_.drag) && scene_.drag >= 0, "/drag",
             [&] { return "must be finite and >= 0, is " + to_text(scene_.drag); });
        finite("/origin", scene_.origin);
        rule(std::isfinite(scene_.start_time.offset), "/start_time", "must be finite");
        positive("/end_time", scene_.end_time);
        for (const auto& m : scene_.materials) material(m);
        for (std::size_t i = 0; i < scene_.contacts.size(); ++i)
            contact("/contacts/" + std::to_string(i), scene_.contacts[i]);
        rest();
        impact();
        guard();
        for (std::size_t i = 0; i < scene_.spheres.size() && patience_.lasts_for(1); ++i) sphere(i);
        for (std::size_t p = 0; p < scene_.planes.size(); ++p) plane(places_.plane(p), scene_.planes[p]);
        for (std::size_t p = 0; p < scene_.planes.size(); ++p)
            for (std::size_t q = 0; q < p; ++q) wedge(p, scene_.planes[q]);
        for (std::size_t k = 0; k < scene_.checks.size(); ++k) check("/checks/" + std::to_string(k), scene_.checks[k]);
        if (scene_.stress) stress(*scene_.stress);
        return std::move(lines_);
    }

private:
    /// Places and messages of rules that are kept are never spelled out: functions give them.
    template <class Text>
    static std::string spelled(const Text& text)
    {
        if constexpr (std::is_invocable_v<const Text&>)
            return text();
        else
            return text;
    }
    template <class Place, class What>
    void rule(bool kept, const Place& place, const What& what)
    {
        if (!kept) lines_.push_back(spelled(place) + ": " + spelled(what));
    }
    template <class Place>
    void finite(const Place& place, const Vec3& v)
    {
        rule(v.allFinite(), place, "must be finite");
    }
    template <class Place>
    void positive(const Place& place, double x)
    {
        rule(std::isfinite(x) && x > 0, place, [x] { return "must be finite and > 0, is " + to_text(x); });
    }
    template <class Place>
    void not_negative(const Place& place, std::optional<double> x)
    {
        if (x) rule(std::isfinite(*x) && *x >= 0, place, [x] { return "must be finite and >= 0, is " + to_text(*x); });
    }
    void at_least_one(const std::string& place, int n)
    {
        rule(n >= 1, place, [n] { return "must be at least 1, is " + std::to_string(n); });
    }
    void fraction(const std::string& place, std::optional<double> x)
    {
        if (x) rule(*x >= 0 && *x <= 1, place, [x] { return "must be between 0 and 1, is " + to_text(*x); });
    }
    template <class Place>
    void material_index(const Place& place, int index)
    {
        rule(index >= 0 && static_cast<std::size_t>(index) < scene_.materials.size(), place,
             [index] { return "no material has index " + std::to_string(index); });
    }

    void material(const Material& m)
    {
        fraction("/materials/" + m.name + "/restitution", m.restitution);
        fraction("/materials/" + m.name + "/tangential", m.tangential);
    }
    void contact(const std::string& place, const ContactRule& c)
    {
        material_index(place + "/between/0", c.a);
        material_index(place + "/between/1", c.b);
        fraction(place + "/restitution", c.restitution);
        fraction(place + "/tangential", c.tangential);
        fraction(place + "/attenuation", c.attenuation);
    }
    void rest()
    {
        not_negative("/rest/closing_speed", scene_.rest.closing_speed);
        not_negative("/rest/window", scene_.rest.window);
        if (scene_.rest.numeric_step) positive("/rest/numeric_step", *scene_.rest.numeric_step);
        not_negative("/rest/gap_tolerance", scene_.rest.gap_tolerance);
        not_negative("/rest/series_below", scene_.rest.series_below);
        double radius = std::numeric_limits<double>::infinity();
        for (const Sphere& s : scene_.spheres) radius = std::min(radius, s.radius);
        if (!(radius > 0) || !std::isfinite(radius)) return;
        const double gap = largest_contact_gap * radius;
        rule(!(scene_.rest.gap_tolerance > gap), "/rest/gap_tolerance",
             "must be at most " + to_text(gap) +
                 ", a hundredth of the smallest radius: contacts that are open are not "
                 "closed");
        const double rises = std::sqrt(2 * scene_.gravity.norm() * radius);
        rule(!(rises > 0 && scene_.rest.closing_speed > rises), "/rest/closing_speed",
             "must be at most " + to_text(rises) +
                 ", which lifts the smallest sphere by its radius: slower impacts have "
                 "no rebound");
    }
    void impact()
    {
        not_negative("/impact/tie", scene_.impact.tie);
        rule(!(scene_.impact.tie > largest_contact_gap), "/impact/tie",
             "must be at most " + to_text(largest_contact_gap) +
                 " of a radius: contacts that are open do not close together");
        at_least_one("/impact/sweeps", scene_.impact.lcp.sweeps);
    }
    void guard()
    {
        at_least_one("/guard/impacts", scene_.guard.impacts);
        if (scene_.guard.window) positive("/guard/window", *scene_.guard.window);
    }
    void sphere(std::size_t i)
    {
        const Sphere& s = scene_.spheres[i];
        const auto at = [&](const char* key) { return [this, i, key] { return places_.sphere(i) + key; }; };
        positive(at("/radius"), s.radius);
        positive(at("/mass"), s.mass);
        finite(at("/position"), s.position);
        finite(at("/velocity"), s.velocity);
        rule(!s.fixed || s.velocity == Vec3::Zero(), at("/velocity"), "must be 0, for the sphere is fixed");
        material_index(at("/material"), s.material);
    }
    void plane(const std::string& place, const Plane& p)
    {
        rule(std::abs(p.normal.squaredNorm() - 1) <= unit_square_error, place + "/normal", "must have unit length");
        rule(std::isfinite(p.offset), place + "/offset", "must be finite");
        not_negative(place + "/thickness", p.thickness);
        material_index(place + "/material", p.material);
    }
    /// The angle of two planes: contacts with nearly parallel normals count as dependent, and a narrow wedge would be
    /// none.
    void wedge(std::size_t p, const Plane& other)
    {
        const double angle = scene_.planes[p].normal.cross(other.normal).norm();
        rule(!(angle > parallel_rounding && angle < narrowest_wedge), places_.plane(p) + "/normal",
             "is parallel to plane \"" + other.id + "\" to within " + to_text(angle) +
                 ", but not exactly (take its normal with more digits, or an angle of at least " +
                 to_text(narrowest_wedge) + ")");
    }
    void check(const std::string& place, const Check& c)
    {
        const auto type = static_cast<std::size_t>(c.type);
        rule(type < check_keys.size(), place + "/type", "unknown check " + std::to_string(type));
        if (type >= check_keys.size()) return;
        not_negative(place + "/abs", c.abs);
        not_negative(place + "/rel", c.rel);
        rule(!(c.abs && c.rel), place, "has both abs and rel (give one)");
        not_negative(place + "/time", c.time);
        rule(c.index >= 0, place + "/event", "must be >= 0");
        rule(c.count >= 0, place + "/count", "must be >= 0");
        finite(place + "/value", c.value);
        const auto known = [](BodyId body, std::size_t count) {
            return body >= 0 && static_cast<std::size_t>(body) < count;
        };
        const std::size_t spheres = scene_.spheres.size(), bodies = spheres + scene_.planes.size();
        rule(!check_keys_of(c.type).has(CheckKey::body) || known(c.body, spheres), place + "/body",
             "must name a sphere of the scene");
        rule(c.type != CheckType::mirrored || c.value != Vec3::Zero(), place + "/value",
             "must not be 0, it is a normal");
        rule(!c.between || (known((*c.between)[0], bodies) && known((*c.between)[1], bodies)), place + "/between",
             "must name two bodies of the scene");
    }
    void stress(const StressPart& s)
    {
        rule(!s.case_name.empty(), "/stress/case", "must not be empty");
        positive("/stress/dt", s.dt);
        not_negative("/stress/exact", s.exact);
        not_negative("/stress/limit", s.limit);
        if (s.stiffness) positive("/stress/stiffness", *s.stiffness);
    }

    const Scene& scene_;
    const BodyPlaces& places_;
    Patience& patience_;
    std::vector<std::string> lines_;
};

/// Owners of ids: a hash table with open places, eight bytes each.
class IdTable {
public:
    explicit IdTable(std::size_t ids) : slots_(std::bit_ceil(2 * ids + 1)) {}

    /// \param id_of gives the id of each body inserted so far, and of this one
    /// \return the owner of its id: `body` itself, or who was inserted before it
    template <class IdOf>
    std::size_t insert(std::size_t body, const IdOf& id_of)
    {
        const std::size_t hash = std::hash<std::string_view>()(id_of(body)), mask = slots_.size() - 1;
        const auto tag = static_cast<std::uint32_t>(hash >> 32);
        for (std::size_t k = hash & mask;; k = (k + 1) & mask) {
            Slot& slot = slots_[k];
            if (slot.owner == nobody) {
                slot = {tag, static_cast<std::uint32_t>(body)};
                return body;
            }
            if (slot.tag == tag && id_of(slot.owner) == id_of(body)) return slot.owner;
        }
    }

private:
    static constexpr std::uint32_t nobody = ~std::uint32_t{0};
    struct Slot {
        std::uint32_t tag = 0;  ///< of the id's hash: other ids are hardly ever looked at
        std::uint32_t owner = nobody;
    };
    std::vector<Slot> slots_;
};

}  // namespace

std::vector<std::string> find_duplicate_ids(const Scene& scene, const BodyPlaces& places, Patience& patience)
{
    const std::size_t n = scene.spheres.size(), all = n + scene.planes.size();  // planes after spheres
    const auto id_of = [&](std::size_t body) -> const std::string& {
        return body < n ? scene.spheres[body].id : scene.planes[body - n].id;
    };
    const auto place_of = [&](std::size_t body) { return body < n ? places.sphere(body) : places.plane(body - n); };
    std::vector<std::string> lines;
    IdTable owners(all);
    for (std::size_t body = 0; body < all && patience.lasts_for(1); ++body) {
        const std::size_t owner = owners.insert(body, id_of);
        if (owner != body)
            lines.push_back(place_of(body) + ": id " + quoted(id_of(body)) + " is already that of " + place_of(owner) +
                            " (ids must be unique)");
    }
    return lines;
}

std::vector<std::string> validate(const Scene& scene, bool allow_overlap, const BodyPlaces& places, Patience& patience)
{
    std::vector<std::string> lines = ValueRules(scene, places, patience).broken();
    for (auto& line : find_duplicate_ids(scene, places, patience)) lines.push_back(std::move(line));
    return lines.empty() ? find_overlaps(scene, allow_overlap, places, patience) : lines;
}

std::vector<std::string> validate(const Scene& scene, bool allow_overlap)
{
    Patience endless;
    return validate(scene, allow_overlap, {}, endless);
}

}  // namespace carom
