/// \file
/// Two steps of a method from the exact state of a case, in a scene of the bodies near, and what came of them.
#pragma once

#include "study/audit/cases.hpp"

#include <carom/study.hpp>

#include <optional>

namespace carom::study {

/// Answer of a method to one impact.
enum class Answer : std::uint8_t {
    found,   ///< answered in its step, with the right velocity after two
    late,    ///< answered in the step after it
    missed,  ///< not answered
    wrong    ///< answered in its step, with another velocity after two
};

struct ContactAnswer {
    Answer answer = Answer::missed;
    double delay = 0;  ///< from the impact to the answer, below 0 if that came before; 0 if missed [steps]
};

/// Runs cases of a scene. It must outlive this.
class CaseRunner {
public:
    CaseRunner(const Scene& scene, const Truth& truth);

    ContactAnswer ask(const ContactCase& contact, const Method& method);
    /// Whether the body answers a contact that is none.
    bool invents(const QuietCase& quiet, const Method& method);

private:
    /// The scene of these bodies alone, in their exact state at `start`.
    void place(const std::vector<BodyId>& bodies, double start);
    BodyId number_in_case(const std::vector<BodyId>& bodies, BodyId body) const;
    bool is_right(const ContactCase& contact, double end, const std::vector<BodyState>& after) const;

    const Scene& scene_;
    const Truth& truth_;
    Scene case_;  ///< planes and materials of the scene, spheres of the case
};

}  // namespace carom::study
