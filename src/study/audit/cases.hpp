/// \file
/// The cases that a step length is put to: impacts of the truth with two steps around them, and two steps of bodies
/// without an impact. They do not depend on the method, so that methods with one step are asked the same.
#pragma once

#include "study/audit/truth.hpp"

#include <cstdint>
#include <vector>

namespace carom::study {

/// One impact, begun at a random phase of the step in which it happens.
struct ContactCase {
    TruthContact contact;
    double start = 0;            ///< of the first step [time]
    std::vector<BodyId> bodies;  ///< spheres that may come near within the steps, those of the contact among them
};

/// Two steps of a body that has no impact in them.
struct QuietCase {
    BodyId body = no_body;
    double start = 0;            ///< [time]
    std::vector<BodyId> bodies;  ///< as in ContactCase
};

struct AuditCases {
    double dt = 0;  ///< [time]
    std::vector<ContactCase> contacts;
    std::vector<QuietCase> quiet;
    std::int64_t crowded = 0;  ///< impacts drawn that are not among them: a body has another contact within the steps
};

/// Impacts up to `end` that are asked about: all of them, or `most_audited` drawn at random; the same for each step.
/// \return indices into truth.contacts, ascending
std::vector<std::size_t> drawn_contacts(const Truth& truth, double end, std::uint64_t seed);

/// Random phases at which each impact is asked about: one, but several where there are few.
int phases_of(std::size_t drawn);

/// \param end quiet steps begin up to here [time]; the truth is known for `longest_case` steps more
AuditCases make_cases(const Scene& scene, const Truth& truth, const std::vector<std::size_t>& drawn, double dt,
                      double end, std::uint64_t seed);

}  // namespace carom::study
