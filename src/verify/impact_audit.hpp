/// \file
/// Are the changes at one instant those that contacts can make? Each flight begins where the one before ended; speeds
/// change by the impulses of the instant's events and nothing else; impulses obey the contact laws; momentum and energy
/// balance.
#pragma once

#include "verify/bounces.hpp"
#include "verify/findings.hpp"

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
    int impulses = 0;                    ///< how many
    bool rests = false;                  ///< an event says so
    bool named = false;                  ///< by an event
    bool changed = false;                ///< has got its new flight
};

class ImpactAudit {
public:
    ImpactAudit(const RunData& data, const Flights& flights, Findings& findings);

    /// The events of an instant, before anything has changed.
    void begin(std::span<const Event> events, std::span<const FlightRecord> flights, const EpochTime& now);
    /// The next flight of this body, which the flights know already.
    void change(BodyId body);
    /// All flights of the instant have begun.
    void end();

private:
    Before& before(BodyId body);
    Before* find(BodyId body);
    void take(const Event& event);
    void check_place(const Before& b, const Path& after);
    void check_speed(Before& b, const Path& after);
    void check_contact(const Event& event);
    void check_law(const Event& event, const Vec3& normal, const ContactLaw& law);
    void check_energy();
    double tolerance() const { return data_.run.certified ? 0x1p-96 : 16 * u; }
    Vec3 speed_before(BodyId body);
    Vec3 speed_after(BodyId body) const;
    double inverse_mass(BodyId body) const;
    void fail(const std::string& what, BodyId a, BodyId b = no_body);

    const RunData& data_;
    const Flights& flights_;
    Findings& findings_;
    EpochTime now_;
    std::span<const Event> events_;
    std::vector<Before> bodies_;
    double speeds_ = 0;          ///< all speeds of the instant's bodies added [cells/epoch]
    double support_energy_ = 0;  ///< what persistent contacts may swallow
};

}  // namespace carom::verification
