/// \file
/// The study of tunnelling: a matrix of throws, and the critical speeds of methods.
#pragma once

#include "tunnel/contestant.hpp"
#include "tunnel/critical_speed.hpp"
#include "tunnel/tolerances.hpp"

#include <carom/progress.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carom::tunnel {

/// Everything that is thrown with and at; every combination is a cell, but a sphere has a thickness above 0 and a wall
/// has none.
struct Matrix {
    std::vector<Target> targets{Target::plate, Target::sphere, Target::wall};
    std::vector<double> thickness{default_thickness.begin(), default_thickness.end()};  ///< [length]
    std::vector<double> radius{default_radius.begin(), default_radius.end()};           ///< [length]
    std::vector<double> dt{default_dt.begin(), default_dt.end()};                       ///< [time]
    std::vector<double> speed{default_speeds.begin(), default_speeds.end()};            ///< [length/time]
    std::int64_t trials = default_trials;  ///< throws of each method at each cell, >= 1
    std::uint64_t seed = 1;
    /// Offsets of sphere targets in searches [radius + sphere's radius]
    std::vector<double> offsets{default_offsets.begin(), default_offsets.end()};
};

/// A line of tunnel.csv.
struct Row {
    std::string method, variant;
    std::optional<Integrator> integrator;
    Cell cell;
    std::int64_t trials = 0, tunnelled = 0, wrong = 0;
    std::optional<double> worst_error;  ///< of throws that did not tunnel; none if all did [length]
    std::optional<double> law;          ///< share missed by the law; none for methods without one
    Aim example;  ///< the first throw that tunnelled, else the first that was wrong, else the first
    std::optional<Throw> example_throw;  ///< of a scene; those of the matrix follow from cell and aim
};

/// A critical speed as it was found.
struct Critical {
    std::string method, variant;
    std::optional<Integrator> integrator;
    Cell cell;          ///< with that speed
    double offset = 0;  ///< of a sphere target [radius + sphere's radius]
    CriticalSpeed speed;
    std::optional<double> law;  ///< infinite for methods that never tunnel; none without a law [length/time]
};

/// An engine that is none of carom's, and what was set.
struct EngineSettings {
    std::string name, words;
};

/// A contestant that could not be there, and why.
struct Absence {
    std::string name, reason;
};

struct Report {
    std::string scene;  ///< its name; empty: the matrix
    std::uint64_t seed = 1;
    std::vector<Row> rows;
    std::vector<Critical> criticals;
    std::vector<Absence> absent;
    std::vector<EngineSettings> engines;  ///< among the contestants
    bool interrupted = false;             ///< rows and critical speeds are those finished before

    /// Whether every exact method hit in every throw.
    bool exact_hold() const;
};

/// The cells of a matrix: by target, thickness, radius, step, speed.
std::vector<Cell> cells_of(const Matrix& matrix);

/// Every contestant at every cell. All of them get the same throws at a cell, whose random numbers depend on seed and
/// cell alone. \param on_progress may be empty; false interrupts
void run_matrix(const Matrix& matrix, const std::vector<Contestant>& contestants, Report& report,
                const OnProgress& on_progress);

/// The throw that shows a row.
Throw example_of(const Row& row);

/// Critical speeds of every contestant at plates and spheres, within 1 %.
void find_criticals(const Matrix& matrix, const std::vector<Contestant>& contestants, Report& report,
                    const OnProgress& on_progress);

/// The lowest speed at which one of 200 phases tunnels, looked for from v dt = 1e-6 to 1e6 chords. \param cell without
/// its speed
CriticalSpeed find_critical(const Contestant& who, Cell cell, double offset);

}  // namespace carom::tunnel
