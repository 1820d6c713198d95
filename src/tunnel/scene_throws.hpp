/// \file
/// Throws in a scene of the user's: its fastest body, with its speed scaled, and the first contact that it has.
#pragma once

#include "study/audit/truth.hpp"
#include "tunnel/study.hpp"

#include <carom/progress.hpp>

#include <vector>

namespace carom::tunnel {

/// One speed of a scene. The truth is an event-driven run of it.
class SceneThrows {
public:
    /// \param longest_step of those that are asked about [time]
    SceneThrows(const Scene& scene, double speed, double longest_step, const OnProgress& on_progress);

    /// Whether the body meets anything in the length of the scene (longer where it was slowed down), closing at v_c or
    /// faster.
    bool has_contact() const { return contact_ < truth_.contacts.size(); }
    const std::string& thrown() const { return scene_.spheres[static_cast<std::size_t>(body_)].id; }
    double speed() const { return speed_; }  ///< of the body [length/time]
    /// \pre has_contact(); so below
    Cell cell(double dt) const;
    /// Part of the way of a step in which the body can be seen: from the contact on to the middle of a plate, or to
    /// where it is nearest to the middle of a sphere; infinite at a wall. None where gravity or drag changes the
    /// velocity, or the other body moves.
    std::optional<double> seen_of_a_step(double dt) const;
    /// Makes `current` the throw at this phase. False where a body has another contact within the steps, or overlaps at
    /// the begin: then nobody could say which answer belongs to the contact.
    bool place(double phase, double dt);
    const Throw& current() const { return throw_; }

private:
    bool is_crowded(double start, double dt) const;
    double closing_steps(double dt) const;

    Scene scene_;
    double speed_;
    BodyId body_;
    study::Truth truth_;
    std::size_t contact_ = 0;  ///< among those of the truth
    Throw throw_;
};

/// Whether there is a speed to scale.
bool some_body_moves(const Scene& scene);

/// Every contestant at every step and speed of the scene; targets, thickness and radius are the scene's.
/// \pre some_body_moves(scene)
void run_scene(const Scene& scene, const Matrix& matrix, const std::vector<Contestant>& contestants, Report& report,
               const OnProgress& on_progress);

/// Critical speeds of every contestant at each step: the body is as in run_scene, its speed is what is looked for. What
/// is behind a wall nobody asks. \pre some_body_moves(scene)
void find_scene_criticals(const Scene& scene, const Matrix& matrix, const std::vector<Contestant>& contestants,
                          Report& report, const OnProgress& on_progress);

}  // namespace carom::tunnel
