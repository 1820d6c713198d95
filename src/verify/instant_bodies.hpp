/// \file
/// The bodies of one instant as they were before it, and which of them its impacts connect.
#pragma once

#include "verify/bounces.hpp"
#include "verify/flight_audit.hpp"

namespace carom::verification {

/// A body at an instant, before it.
struct Before {
    BodyId body = no_body;
    Path path;                           ///< the flight that ends
    Vector<DoubleDouble> place, speed;   ///< place relative to path.cell
    Vec3 place_size, speed_size;         ///< of the parts they are made of; 0 where a coordinate cannot change
    bool follows = true;                 ///< false: a series too long to be followed; place and speed say nothing
    std::optional<SeriesRecord> series;  ///< the series that ends, if one does
    Vec3 impulse = Vec3::Zero();         ///< of all events [mass cells/epoch]
    double pushes = 0;                   ///< sizes of all impulses added [mass cells/epoch]
    int impulses = 0;                    ///< how many
    std::size_t group = 0;               ///< index of the body that stands for all that impulses connect with it
    bool rests = false;                  ///< an event says so
    bool sums_bounces = false;           ///< and its impulse is that of all bounces of a series, which is over
    bool named = false;                  ///< by an event
    bool changed = false;                ///< has got its new flight
};

/// Bodies that impulses connect.
struct Group {
    int impulses = 0;
    int settles = 0;  ///< impulses that hold a contact which opens slowly
    /// More than one sphere that meets another body: several impulses, or bodies that several contacts hold. Its
    /// velocities come from a solver, not from a formula.
    bool coupled = false;
    bool supported = false;  ///< a persistent contact takes part
    bool loose = false;      ///< a piece that no closed form gives, or a series, ends here: before is known roughly
    double mass = 0;         ///< of its bodies that changed
    double speeds = 0;       ///< of its bodies, before, added [cells/epoch]
    double energy = 0, change = 0;             ///< kinetic; the sizes that it is made of, and what it gained
    double momenta = 0;                        ///< sizes of momenta added
    Vec3 momentum = Vec3::Zero();              ///< gained beside the impulses
    double swallowed = 0;                      ///< energy that persistent contacts may take or give
    BodyId first = no_body, second = no_body;  ///< of its first event
};

class InstantBodies {
public:
    InstantBodies(const RunData& data, const Flights& flights) : data_(data), flights_(flights) {}

    /// Before anything has changed.
    void begin(std::span<const Event> events, std::span<const FlightRecord> flights, const EpochTime& now);
    /// When all new flights are known.
    void connect(std::span<const Event> events);

    Before* find(BodyId body);
    std::vector<Before>& all() { return bodies_; }
    std::vector<Group>& groups() { return groups_; }  ///< by Before::group
    Group& group_of(const Before& b) { return groups_[b.group]; }
    const EpochTime& now() const { return now_; }
    /// All speeds of the instant's bodies added [cells/epoch].
    double speeds() const { return speeds_; }
    /// What a body that several contacts hold may change its speed by without an impulse: openings of 1e-6 v_c each
    /// [cells/epoch].
    double settling() const
    {
        return (1 + static_cast<double>(bodies_.size())) * 4 * still * data_.closing_speed + 4 * hidden * speeds_;
    }
    /// Is there more than one contact to be resolved, as far as can be told before?
    bool has_several_contacts() const { return coupled_; }
    /// Has there been, so far? Then contacts may be closed at any instant that nobody speaks of.
    bool knows_several_contacts() const { return seen_; }
    /// May bodies that several contacts hold change their flights without an event of their own?
    bool is_stirred() const { return stirred_; }

    Vec3 speed_before(BodyId body);
    Vec3 speed_after(BodyId body) const;
    double inverse_mass(BodyId body) const;

private:
    Before& before(BodyId body);
    void take(const Event& event);
    std::size_t root(std::size_t i);

    const RunData& data_;
    const Flights& flights_;
    EpochTime now_;
    std::vector<Before> bodies_;
    std::vector<Group> groups_;
    std::unordered_map<BodyId, std::size_t> places_;  ///< of many bodies
    double speeds_ = 0;
    bool stirred_ = false, coupled_ = false, seen_ = false;
};

/// The part of a dot product that doubles hold.
inline Vec3 high(const Vector<DoubleDouble>& a)
{
    return {a.x.high, a.y.high, a.z.high};
}

inline DoubleDouble component(const Vector<DoubleDouble>& a, int k)
{
    return k == 0 ? a.x : k == 1 ? a.y : a.z;
}

}  // namespace carom::verification
