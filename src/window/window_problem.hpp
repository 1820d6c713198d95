/// \file
/// A window: a short time in which the bodies of a heap go straight on, so that none can overlap. The problem and its
/// outcome, plain values.
#pragma once

#include "core/partner.hpp"

#include <carom/types.hpp>

#include <optional>
#include <vector>

namespace carom {

struct WindowBody {
    Vec3 place = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    Vec3 acceleration = Vec3::Zero();
    double inverse_mass = 0;  ///< 0: the body keeps its velocity, whatever pushes it
    double radius = 0;        ///< [length] > 0
};

/// The half-space normal.x >= offset, or a plate on both sides of normal.x = offset.
struct WindowPlane {
    Vec3 normal = Vec3::UnitZ();
    double offset = 0;                     ///< [length]
    std::optional<double> half_thickness;  ///< [length] of a plate
};

/// Two bodies, or a body and a plane, that may meet in the window.
struct WindowContact {
    int a = 0;
    Partner b;               ///< a sphere or a plane
    double restitution = 0;  ///< e
    double impulse = 0;      ///< >= 0: a guess of the window's; it saves time
};

struct WindowProblem {
    std::vector<WindowBody> bodies;
    std::vector<WindowPlane> planes;
    /// All that can meet, in the order of the sweeps, each pair once. Pairs that are not listed may overlap.
    std::vector<WindowContact> contacts;
};

enum class WindowSolver {
    relaxation,  ///< cheap, leaves `speed_tolerance`: for hot windows
    exact        ///< interior points: for calm, long windows
};

struct WindowOptions {
    double length = 0;           ///< [time] > 0
    double margin = 0;           ///< [length] gap below which relaxation pushes out, within what the window loses
    double closing_speed = 0;    ///< [velocity] contacts that close faster rebound
    double speed_tolerance = 0;  ///< [velocity] > 0: error of a contact's rate that relaxation may leave
    WindowSolver solver = WindowSolver::relaxation;
};

enum class WindowStatus {
    complete,
    shortened,  ///< it ends early, where nothing overlaps
    infeasible  ///< no motion without overlap, or without a gain of energy, was found: nothing moves, length is 0
};

/// A body's motion in the window: straight, or its parabola.
struct WindowMotion {
    Vec3 velocity = Vec3::Zero();      ///< as the window begins
    Vec3 acceleration = Vec3::Zero();  ///< 0 of a body that goes straight
    Vec3 end_velocity = Vec3::Zero();  ///< after restitution
};

struct WindowOutcome {
    WindowStatus status = WindowStatus::complete;
    double length = 0;                  ///< [time] that was really taken
    std::vector<WindowMotion> motions;  ///< by body
    std::vector<double> impulses;       ///< by contact, >= 0, along the normal towards a
    std::vector<double> guess;          ///< by contact: impulses to begin the next window of the same length with
    double taken_by_window = 0;         ///< [energy] >= 0 up to rounding
    double taken_by_restitution = 0;    ///< [energy] <= 0 where rebounds give back what the window took
    int sweeps = 0;                     ///< of relaxation
    long relaxations = 0;               ///< of single contacts
    int interior_steps = 0;             ///< factorisations of interior points
};

}  // namespace carom
