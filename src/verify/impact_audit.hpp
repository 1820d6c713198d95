/// \file
/// Are the changes at one instant those that contacts can make? Each flight begins where the one before ended; speeds
/// change by the impulses of the instant's events and nothing else.
#pragma once

#include "verify/contact_audit.hpp"

namespace carom::verification {

class ImpactAudit {
public:
    ImpactAudit(const RunData& data, const Flights& flights, Coverage& coverage, Findings& findings);

    /// The events of an instant, before anything has changed.
    void begin(std::span<const Event> events, std::span<const FlightRecord> flights, const EpochTime& now);
    /// The next flight of this body, which the flights know already.
    void change(BodyId body);
    /// All flights of the instant have begun.
    void end();

private:
    /// May this flight change without an event that names its body?
    bool is_excused(const Before& b) const;
    void check_place(const Before& b, const Path& after);
    void check_speed(const Before& b, const Path& after);
    double tolerance() const { return data_.run.certified ? 0x1p-96 : 16 * u; }
    void fail(const std::string& what, BodyId a) { findings_.violation(what, bodies_.now(), a); }

    const RunData& data_;
    const Flights& flights_;
    Coverage& coverage_;
    Findings& findings_;
    InstantBodies bodies_;
    ContactAudit contacts_;
    std::span<const Event> events_;
};

}  // namespace carom::verification
