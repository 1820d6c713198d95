/// \file
/// Do the events of an instant obey the laws of contact? Impulses happen where spheres touch; those of a contact alone
/// are what its law says; of those that are connected momentum is kept, energy is not gained, impulses push, and
/// nothing closes afterwards.
#pragma once

#include "verify/coverage.hpp"
#include "verify/findings.hpp"
#include "verify/instant_bodies.hpp"

namespace carom::verification {

class ContactAudit {
public:
    ContactAudit(const RunData& data, const Flights& flights, Coverage& coverage, Findings& findings);

    /// \pre the bodies are connected
    void check(InstantBodies& bodies, std::span<const Event> events);

private:
    /// A contact as its two spheres are at the instant.
    struct Geometry {
        Vec3 normal;
        double gap = 0, size = 1, travel = 0;  ///< [cells]
        double shake = 0;                      ///< error of the normal, in roundings
    };
    Geometry geometry(const Event& event);
    double flown(const Before& b) const;
    double smaller_radius(const Event& event) const;  ///< [cells]
    void check_event(const Event& event);
    void check_impulse(const Event& event, const Geometry& at, const Group& group);
    void check_hold(const Event& event, const Geometry& at, const Group& group);
    /// \returns the restitution that the impulse has: that of the law, or 0 where contacts may be made inelastic
    double check_law(const Event& event, const Vec3& normal, const Group& group);
    bool may_be_inelastic(const Event& event, double closing) const;
    bool closed_a_moment_ago(const Event& event) const;
    bool is_jammed(BodyId body, const Vec3& push);
    void remember(const Event& event);
    void add_up(const Before& b);
    void check_group(const Group& group, const Event* alone);
    void count(const Event& event);
    void fail(const std::string& what, BodyId a, BodyId b = no_body)
    {
        findings_.violation(what, bodies_->now(), a, b);
    }

    const RunData& data_;
    const Flights& flights_;
    Coverage& coverage_;
    Findings& findings_;
    InstantBodies* bodies_ = nullptr;
    std::span<const Event> events_;                        ///< of the present instant
    bool several_ = false;                                 ///< impulses at the present instant
    bool closes_ = false;                                  ///< does a contact of an instant with pulls, before it?
    bool holds_ = false;                                   ///< are there pulls at the present instant?
    double largest_restitution_ = 0;                       ///< of them, if there are several
    double restitution_ = 1;                               ///< that the last impulse examined had
    std::unordered_map<std::uint64_t, EpochTime> closed_;  ///< contacts with e < 1 that closed within tau_p
    std::size_t most_closed_ = 1024;
};

}  // namespace carom::verification
