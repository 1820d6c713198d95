/// \file
/// One run of a case against what is known of it.
#pragma once

#include "study/stress/case.hpp"

#include <carom/scene.hpp>
#include <carom/simulate.hpp>

#include <optional>

namespace carom::stress {

/// A sphere at the end of the run. Its errors count relative to these scales.
struct ExpectedState {
    BodyId body = no_body;
    Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();
    double length = 0;  ///< scale of the error of the position; 0: it is not asked for [length]
    double speed = 0;   ///< likewise of the velocity [length/time]
};

/// The first impact of two bodies.
struct ExpectedImpact {
    BodyId a = no_body, b = no_body;
    double time = 0;   ///< [time]
    double scale = 0;  ///< of its error [time]
};

/// A scene, a step, and what comes out if all is right.
struct Trial {
    std::string label = {};
    Scene scene = {};
    double dt = 0;  ///< of discrete methods [time]
    std::vector<ExpectedState> states = {};
    std::vector<ExpectedImpact> first = {};    ///< impacts whose time is asked for
    std::optional<std::int64_t> impacts = {};  ///< how many there are; a wrong number is a symptom
    bool count_is_figure = false;              ///< then a wrong number counts in the figure, too
};

/// Run the trials. The figure is the largest error in them.
Evidence measure(const std::vector<Trial>& trials, std::string_view method, Patience& patience);

/// An observer of a run that ends with the patience.
Observer observed(Patience& patience);

/// Add what the outcome says, whatever is asked: did it end well, how deep, what became of the energy.
void take_note(const Scene& scene, const Outcome& outcome, Evidence& evidence);

/// The figure grows to `value`, found in `where`.
void note_figure(Evidence& evidence, double value, const std::string& where);

}  // namespace carom::stress
